#pragma once

#include <string>

#include "data/color_map/color_points.h"

namespace aeolic {

/// Local. The points of a colour map in ParaView's XML: <ColorMap space="RGB"><Point x= r= g= b=/>…<NaN r= g= b=/>
/// </ColorMap>, perhaps within <ColorMaps>, of which the first is taken. `path` stands in front of messages. Throws
/// InputError.
ColorPoints colorPointsInXml(const std::string& text, const std::string& path);

}  // namespace aeolic
