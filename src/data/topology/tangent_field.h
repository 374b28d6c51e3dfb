#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "data/topology/surface_fans.h"

namespace aeolic {

/// The tangential part of a vector at each fan of a surface: angle in the fan, and length.
struct TangentField {
    std::vector<double> rad;           ///< [fans] as SurfaceFans::edgeRad counts.
    std::vector<double> length;        ///< [fans] 0: at rest; NaN: masked.
    std::vector<std::uint8_t> masked;  ///< [triangles] One of its own corners has no vector: no line enters it.

    /// [fans] or empty: at these the surface has a sharp edge. A triangle there has what `own` is along it, as streaks
    /// have it, and not what is carried over from the fan.
    std::vector<std::uint8_t> sharp = {};
    std::vector<glm::vec3> own = {};  ///< [points of the mesh] where `sharp` is not empty.
};

/// A surface and the flow on it, all of which has to last as long as this.
struct FlowSurface {
    const SurfaceMesh& mesh;
    const SurfaceFans& fans;
    const TangentField& field;
};

/// `vectors`: [points of the mesh] in the world's axes. A fan has the mean of those of its corners that are finite, by
/// the triangles' angles there. Cost: O(triangles), parallel.
TangentField tangentField(const SurfaceMesh& mesh, const SurfaceFans& fans, const std::vector<glm::vec3>& vectors);

/// [fans] The normals of a fan's triangles are far from their mean. Cost: O(triangles), parallel.
std::vector<std::uint8_t> sharpFans(const SurfaceMesh& mesh, const SurfaceFans& fans);

}  // namespace aeolic
