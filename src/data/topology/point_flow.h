#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "data/scene.h"
#include "data/surface_range.h"

namespace aeolic {

/// A surface with the flow at each of its points.
struct PointFlow {
    SurfaceMesh mesh;                ///< Positions and triangles; as fine as the field that is sampled.
    std::vector<glm::vec3> vectors;  ///< [points of the mesh] World axes; NaN where no streaks show.
};

/// The flow that a scene's streaks follow. The scene's surface is whole in this process. Values of triangles are
/// brought to the points. A field is looked up at the points, and the triangles are cut until they are as fine as its
/// cells. Cost: O(points), parallel; the mesh is copied.
PointFlow pointFlow(const Scene& scene, const FieldLookup& lookUp = vectorsAt);

}  // namespace aeolic
