#pragma once

#include <cstdint>
#include <vector>

#include "base/extent.h"
#include "data/scene.h"
#include "render/view.h"

namespace aeolic::cpu {

/// Which of several surfaces the pixels of some rows show, in Scene::surfaces' order; -1: none. [pixels of `rows`], row
/// after row. Local. Cost: that of finding what is visible in a frame, and of rearranging the scene for it.
std::vector<std::int32_t> shownSurfaces(const Scene& scene, const View& view, const Extent& rows);

}  // namespace aeolic::cpu
