#pragma once

#include "base/extent.h"
#include "data/mesh/surface_mesh.h"
#include "data/vector_field.h"
#include "render/view.h"

namespace aeolic {

/// The box of a field's brick in world coordinates, `marginCells` cells wider on each side.
Bounds brickBounds(const GridField& field, double marginCells);

/// Local. The pixels in which the box of a field's brick may be seen: empty for an empty brick and for one beside the
/// image, all of the image where the box reaches behind the eye.
Extent imageOf(const GridField& field, const glm::dvec3& originWorld, const View& view);

/// Local. The pixels in which a box may be seen: empty for an empty box, all of the image for one that is not finite.
Extent imageOf(const Bounds& boxWorld, const glm::dvec3& originWorld, const View& view);

}  // namespace aeolic
