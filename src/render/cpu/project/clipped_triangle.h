#pragma once

#include <cstdint>
#include <vector>

#include "data/surface_mesh.h"
#include "render/cpu/project/transform.h"
#include "render/view.h"

namespace aeolic::cpu {

/// A piece of a triangle cut at the near plane or the guard band.
struct ClippedTriangle {
    std::int32_t x[3], y[3];  ///< Sub-pixels (transform.h).
    float invDepth[3];
    std::uint32_t original;
};

/// The pieces of a triangle that setUpTriangles() found unsafe; none where nothing of it is seen.
std::vector<ClippedTriangle> clippedPieces(const SurfaceMesh& mesh, const View& view, std::uint32_t id);

/// Its pixel bounds within `scissor`, empty where it covers no pixel centre's row or column; the id is the original's.
TriangleBox boxOf(const ClippedTriangle& piece, const Extent& scissor);

}  // namespace aeolic::cpu
