#pragma once

#include <vector>

#include "data/streamlines/streamline_surface.h"
#include "render/overlay/surface_lines.h"

namespace aeolic {

/// The streamline through the place of a surface that is nearest to a point, with heads that tell which way it goes,
/// and the place itself. What comes to the place is thinner than what leaves it.
std::vector<SurfaceLines::Style> streamlineThrough(const StreamlineSurface& surface, const glm::dvec3& pointWorld);

}  // namespace aeolic
