#pragma once

#include "aeolic/picture.h"
#include "aeolic/scene_description.h"
#include "data/scene.h"
#include "engine/frame_group.h"

namespace aeolic {

/// All pixels of the picture that rank 0 gathered, or that one rank drew. `kept`: a picture that nobody needs any more;
/// its memory is used again.
Picture gatheredPicture(const FrameTiles& tiles, int height, Picture kept = {});

/// The gathered picture for the user: with the scalar bar on top where something is coloured.
Picture pictureOf(const FrameTiles& tiles, int height, const ShadingOptions& shading, const Scene& scene, Picture kept);

/// A rank's own rows for the user, with their part of the scalar bar. `height` is the whole picture's.
Picture pictureOf(const Tile& stripe, int height, const ShadingOptions& shading, const Scene& scene, Picture kept);

}  // namespace aeolic
