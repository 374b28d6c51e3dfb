#pragma once

#include <string>
#include <vector>

#include "data/series_entry.h"

namespace aeolic {

/// The data sets of a ParaView collection (<VTKFile type="Collection"><Collection><DataSet timestep file/>…), in the
/// file's order. Whether files are there and times make sense is not judged here. Throws InputError with one line where
/// it is not such XML, or an entry has no file or no time.
std::vector<SeriesEntry> readPvdFile(const std::string& path);

}  // namespace aeolic
