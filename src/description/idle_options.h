#pragma once

#include <map>
#include <string>
#include <vector>

#include "aeolic/scene_description.h"

namespace aeolic {

/// Options that change no picture of this scene, a line for each: "--legend has no effect without --color-by". A
/// forgotten option is mostly why. `given`: those that were typed, by their names on the command line; what a scene
/// file says is not judged, because it may serve several purposes. `moves`: the data change in time.
std::vector<std::string> idleOptions(const SceneDescription& scene, const std::map<std::string, std::string>& given,
                                     bool moves);

}  // namespace aeolic
