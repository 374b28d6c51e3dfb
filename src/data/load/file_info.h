#pragma once

#include <string>
#include <vector>

#include "data/file_summary.h"

namespace aeolic {

/// What a file holds, for people and for programs.
struct FileInfo {
    FileSummary summary;                   ///< Of a series: of its first file, with the times of all.
    std::vector<std::string> suggestions;  ///< `aeolic render` commands to try first; none where nothing can be drawn.
    /// What `aeolic info FILE` prints, lines of at most 100 columns (but for long names): the file's kind, size, bounds
    /// and time steps, its arrays with their ranges, and last the suggestions.
    std::string text;
};

/// Reads the whole file, or the first file of a series. Throws InputError with one line if it cannot be read.
FileInfo fileInfo(const std::string& path);

/// Its text.
std::string describeFile(const std::string& path);

}  // namespace aeolic
