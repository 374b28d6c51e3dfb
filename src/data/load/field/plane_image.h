#pragma once

#include <optional>

#include "aeolic/data.h"
#include "aeolic/scene_description.h"

namespace aeolic {

struct PlaneSize {
    int width = 0, height = 0;
};

/// Local. For `--surface image`: how many pixels its picture has across and up by default. It has the plane's shape,
/// and a pixel for each sample in the direction in which they are closest, so at least one in the other; fewer where a
/// side would be longer than pictures may be. Nothing for other surfaces, and where the header of the field's file does
/// not tell. Throws InputError where the field has more than one layer, or more samples than a picture may have pixels.
std::optional<PlaneSize> planeSize(const SceneDescription& description, const Data& memory = {});

}  // namespace aeolic
