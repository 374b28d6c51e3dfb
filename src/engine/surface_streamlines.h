#pragma once

#include "aeolic/streamlines.h"
#include "data/scene.h"
#include "data/surface_range.h"
#include "render/view.h"

namespace aeolic {

/// Evenly spaced streamlines on a scene's surface, about as far apart as `spacingPx` pixels of the view (as
/// StreamlineStrokes counts them) at the depth of the surface's middle, or as close as EvenStreamlines goes. What finer
/// levels add to a line is part of it. The scene's surface is whole in this process; `lookUp`: its fields. Cost:
/// EvenStreamlines.
EvenSurfaceLines surfaceStreamlines(const Scene& scene, const View& view, double spacingPx, const FieldLookup& lookUp);

}  // namespace aeolic
