#pragma once

#include <string>
#include <vector>

namespace aeolic {

/// An array that a data set has, for people to choose.
struct ArrayChoice {
    std::string name;
    int components = 1;
};

using ArrayChoices = std::vector<ArrayChoice>;

}  // namespace aeolic
