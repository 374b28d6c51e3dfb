#pragma once

#include <string>

#include "data/file_summary.h"
#include "data/progress.h"

namespace aeolic {

/// Reads all of the file; of a case no more than its patches, at its first time. Throws the InputError that loading
/// would throw.
FileSummary summaryOf(const std::string& path, const ProgressReport& progress);

}  // namespace aeolic
