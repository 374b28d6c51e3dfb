#pragma once

#include "aeolic/picture.h"
#include "aeolic/scene_description.h"
#include "data/scene.h"
#include "render/tile.h"

namespace aeolic {

/// A tile's pixels as the user gets them: without alpha unless the background is transparent, the scalar bar on top
/// where something is coloured. `height` is that of the whole picture, in which the tile says where it lies.
Picture pictureOf(const Tile& tile, int height, const ShadingOptions& shading, const Scene& scene);

}  // namespace aeolic
