#pragma once

#include <string>
#include <vector>

namespace aeolic {

/// A line of a series file, as it stands there.
struct SeriesEntry {
    std::string file;
    double time = 0;
};

/// ParaView's JSON of a file series: {"file-series-version": "1.0", "files": [{"name": "a.vtp", "time": 0}, …]}.
/// Whether files are there and times make sense is not judged here. Throws InputError with one line for anything else.
std::vector<SeriesEntry> readSeriesFile(const std::string& path);

}  // namespace aeolic
