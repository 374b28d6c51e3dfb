#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "data/mesh/surface_mesh.h"
#include "render/cpu/project/raster/raster.h"
#include "render/view.h"

namespace aeolic::cpu {

/// A triangle cut by half-spaces has at most this many corners: one more per plane.
inline constexpr int kMaxClippedCorners = 3 + 5;

/// Cuts a triangle given in eye space (x right, y up, z depth) at the near plane and at four planes of a wide guard
/// band |x| <= slopeX * z, |y| <= slopeY * z (Sutherland & Hodgman 1974). Returns the number of corners left in `out`.
/// New corners are always computed from the inner to the outer end of an edge: two triangles that share the edge get
/// the same bits, hence no gap.
int clipTriangle(const std::array<glm::dvec3, 3>& corners, double nearDepth, double slopeX, double slopeY,
                 std::array<glm::dvec3, kMaxClippedCorners>& out);

/// A piece of a triangle cut at the near plane or the guard band.
struct ClippedTriangle {
    std::array<Corner, 3> corners;
    std::uint32_t original;
};

/// The pieces of a triangle that setUpTriangles() found unsafe; none where nothing of it is seen.
std::vector<ClippedTriangle> clippedPieces(const SurfaceMesh& mesh, const View& view, std::uint32_t id);

}  // namespace aeolic::cpu
