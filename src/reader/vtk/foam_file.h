#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "data/file_summary.h"
#include "data/progress.h"
#include "reader/vtk/own_reader.h"

/// What is asked of an OpenFOAM case. `path`: its folder, or a file in it. All throw InputError.
namespace aeolic {

/// Its patches for a surface, else its cells.
std::unique_ptr<OwnReader> openFoam(const std::string& path, FileUse use, std::optional<double> time);

std::vector<double> foamTimes(const std::string& path);

/// 1 for each of its processors, which are dealt out one by one.
std::vector<std::uint64_t> foamPieces(const std::string& path);

/// The first of its times with all of the arrays that are there at any time, by its number; 0 where none has.
std::uint64_t firstFoamStep(const std::string& path, const std::vector<std::string>& arrays);

/// Whether the parts that are wanted are of one region.
bool isOneFoamRegion(const std::string& path, const std::vector<std::string>& parts);

/// Local. What `aeolic info` tells of a case: of its patches at its first time.
FileSummary summaryOfFoam(const std::string& path, const ProgressReport& progress);

}  // namespace aeolic
