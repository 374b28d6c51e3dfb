#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "description/file_kinds.h"
#include "reader/parts/part_source.h"

/// What is asked of an OpenFOAM case. `path`: its folder, or a file in it. All throw InputError.
namespace aeolic {

/// Its cells for a field, a part for each region; else its patches.
std::unique_ptr<PartSource> openFoamCase(const std::string& path, FileUse use, std::optional<double> time);

/// The times of a case from the first on that has all of the arrays that are there at any time. Later ones may lack
/// them where the first of all times has them.
std::vector<double> foamTimes(const std::string& path, const std::vector<std::string>& arrays);

/// 1 for each of its processors, which are dealt out one by one. Patches of several regions are read as one piece:
/// where two regions meet, their points are at the same places, and are not one.
std::vector<std::uint64_t> foamPieces(const std::string& path, FileUse use, const std::vector<std::string>& parts);

}  // namespace aeolic
