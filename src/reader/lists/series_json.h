#pragma once

#include <string>
#include <vector>

#include "data/series_entry.h"

namespace aeolic {

/// ParaView's JSON of a file series: {"file-series-version": "1.0", "files": [{"name": "a.vtp", "time": 0}, …]}.
/// Whether files are there and times make sense is not judged here.
std::vector<SeriesEntry> readSeriesFile(const std::string& path);

}  // namespace aeolic
