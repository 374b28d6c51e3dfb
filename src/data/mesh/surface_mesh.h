#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "base/bounds.h"

namespace aeolic {

/// A triangle surface in P-space. Positions are floats relative to `originWorld` (the bounds' centre), so that data far
/// from the origin keeps its precision: world = originWorld + position.
struct SurfaceMesh {
    glm::dvec3 originWorld{0};
    std::vector<glm::vec3> positions;                     ///< [points]
    std::vector<glm::vec3> normals;                       ///< [points], unit length.
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< [triangles], indices into the points; none degenerate.

    std::vector<glm::vec3> pointVectors;  ///< [points] or empty.
    std::vector<glm::vec3> cellVectors;   ///< [triangles] or empty. NaN marks a masked value.
    std::vector<float> pointScalars;      ///< [points] or empty: the array to colour by. NaN marks a masked value.
    std::vector<float> cellScalars;       ///< [triangles] or empty.

    /// [triangles] or empty: rising numbers that tell where the triangles of a piece stand among those of the whole
    /// surface. Where two triangles have the same depth, the one with the lower number shows. Without numbers it is the
    /// one that comes first here.
    std::vector<std::uint64_t> order;

    /// [points] or empty: which of the scene's surfaces a point is of. All corners of a triangle are of one.
    std::vector<std::uint8_t> surfaceOf;

    std::string name;  ///< The file's or the built-in's name, for messages.

    /// Appends a point with all values of another one, and returns its number.
    std::uint32_t copyPoint(std::uint32_t point);

    Bounds bounds() const;  ///< World coordinates. Cost: one pass over the points.
};

}  // namespace aeolic
