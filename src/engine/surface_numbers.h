#pragma once

#include <cstdint>
#include <vector>

#include "data/scene.h"
#include "render/surface_overlay.h"
#include "render/view.h"

namespace aeolic {

/// Which of the scene's surfaces the pixels of some rows show, in Scene::surfaces' order; 0 where there is only one, -1
/// where there is nothing. It is the surface whose triangle lies nearest to what `seen` says, so it does not matter who
/// drew. A covered pixel that no triangle's plane fits, nor one of its neighbours in the row, may have -1, too. Local.
/// Cost: a pass over the triangles for every 64 rows, some 10 ns each, and 20 ns for each pixel of their boxes.
std::vector<std::int32_t> surfaceNumbers(const Scene& scene, const View& view, const Extent& rows,
                                         const SeenSurface& seen);

}  // namespace aeolic
