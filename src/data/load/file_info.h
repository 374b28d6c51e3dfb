#pragma once

#include <string>

namespace aeolic {

/// What `aeolic info FILE` prints, lines of at most 100 columns (but for long names): the file's kind, size, bounds and
/// time steps, its arrays with their ranges, and last the `aeolic render` commands to try first. Reads the whole file,
/// or the first file of a series.
/// Throws InputError with one line if it cannot be read.
std::string describeFile(const std::string& path);

}  // namespace aeolic
