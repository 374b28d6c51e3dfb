#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "description/surface_spec.h"

namespace aeolic {

/// A part of a file of several: a patch, a block.
struct PartName {
    std::string name;                 ///< "terrain", or "air/walls/left" where parts stand in others.
    std::vector<std::string> groups;  ///< Other names that it goes by together with others.
};

/// The numbers of the parts that any of `wanted` names, increasing. A name without '/' may stand for the end of a
/// part's name behind a '/'. Several that follow each other count as one with commas where a part is called so. Throws
/// InputError, which begins with `where`, for one that matches none.
std::vector<std::size_t> chooseParts(const std::vector<PartName>& parts, const std::vector<std::string>& wanted,
                                     const std::string& where);

}  // namespace aeolic
