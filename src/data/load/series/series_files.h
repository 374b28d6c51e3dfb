#pragma once

#include <string>
#include <vector>

#include "data/series_entry.h"

/// Files at several moments by their names. They throw InputError with one line.
namespace aeolic {

/// Whether the file name holds a wildcard for numbers (%d, %04d or *) and no file has this very name.
bool isNumberPattern(const std::string& path);

/// The files whose names have a number where the pattern has its wildcard, in the order of the numbers, timed 0, 1, 2 …
/// `*` and `%d` take a number of any width, `%04d` one padded with zeros to at least four digits. Throws for a pattern
/// with two wildcards, without any such file, and where two files have the same number.
std::vector<SeriesEntry> numberedFiles(const std::string& path);

}  // namespace aeolic
