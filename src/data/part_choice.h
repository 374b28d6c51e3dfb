#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "data/part_info.h"

namespace aeolic {

/// The numbers of the parts that any of `wanted` names, increasing. A name without '/' may stand for the end of a
/// part's name behind a '/'. Several that follow each other count as one with commas where a part is called so. Throws
/// InputError, which begins with `where`, for one that matches none.
std::vector<std::size_t> chooseParts(const std::vector<PartInfo>& parts, const std::vector<std::string>& wanted,
                                     const std::string& where);

}  // namespace aeolic
