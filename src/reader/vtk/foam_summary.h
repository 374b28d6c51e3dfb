#pragma once

#include <string>

#include "data/file_summary.h"
#include "data/progress.h"

namespace aeolic {

/// What `aeolic info` tells of an OpenFOAM case: of its patches at its first time, and of each field at the first time
/// that has it. The cells are not read. Throws InputError.
FileSummary summaryOfFoam(const std::string& path, const ProgressReport& progress);

}  // namespace aeolic
