#pragma once

#include <string>
#include <string_view>

#include "data/color_map/color_points.h"

namespace aeolic {

/// The colour map of that name, or of that file: ParaView's presets as .json or .xml, or .csv (docs/file-formats.md).
/// A file is relative to the folder that the process is in. Reads at most 64 MiB. Throws InputError with one line
/// (file, item, found, expected).
ColorMap loadColorMap(const std::string& nameOrPath);

/// Local. The points that the text of such a file holds. `path` stands in front of messages.
ColorPoints colorPointsFromJson(const std::string& text, const std::string& path);
ColorPoints colorPointsFromCsv(std::string_view text, const std::string& path);

}  // namespace aeolic
