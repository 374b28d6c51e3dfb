#pragma once

#include <string>
#include <vector>

#include "base/byte_message.h"

namespace aeolic {

/// An array that a data set has, for people to choose.
struct ArrayChoice {
    std::string name;
    int components = 1;
    bool operator==(const ArrayChoice&) const = default;
};

template <PerhapsConst<ArrayChoice> Array, class Visit>
void withMembers(Array& array, const Visit& visit)
{
    visit(array.name, array.components);
}

using ArrayChoices = std::vector<ArrayChoice>;

/// The arrays that a message lists: "U (points, 3 components), p (cells, 1 component)".
ArrayChoices arraysListed(const std::string& listing);

/// What a scene can be coloured by: NAME of one component, NAME:mag of several, NAME:x … of vectors, and such NAMEs
/// themselves, which are what people type.
std::vector<std::string> colorableNames(const ArrayChoices& arrays);

/// For a message about an array that is not there: "; did you mean U:mag?", or nothing.
std::string nearestArray(const std::string& typed, const ArrayChoices& arrays);

}  // namespace aeolic
