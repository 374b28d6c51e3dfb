#pragma once

#include <string>
#include <vector>

#include "data/series_entry.h"

/// Lists of files. Whether these are there and times make sense is not judged here. All throw InputError.
namespace aeolic {

/// ParaView's JSON of a file series: {"file-series-version": "1.0", "files": [{"name": "a.vtp", "time": 0}, …]}.
std::vector<SeriesEntry> readSeriesFile(const std::string& path);

/// The data sets of a ParaView collection (<VTKFile type="Collection"><Collection><DataSet timestep file/>…), in the
/// file's order. Throws InputError with one line where it is not such XML, or an entry has no file or no time.
std::vector<SeriesEntry> readPvdFile(const std::string& path);

}  // namespace aeolic
