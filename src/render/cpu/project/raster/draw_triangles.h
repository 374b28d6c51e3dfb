#pragma once

#include <cstdint>
#include <span>

#include "data/mesh/surface_mesh.h"
#include "render/cpu/project/raster/raster.h"
#include "render/cpu/project/raster/transform.h"

namespace aeolic::cpu {

/// drawTriangle() for each of the triangles `ids` of a mesh, none of which needs clipping: the same keys. Those smaller
/// than a tile are set up a vector at a time. Local. Cost: 20 ns a triangle of a few pixels.
void drawTriangles(const SurfaceMesh& mesh, const ScreenVertices& screen, std::span<const std::uint32_t> ids,
                   const Extent& tile, const DrawRule& rule, const TileDepths* drawn, TileKeys& keys);

}  // namespace aeolic::cpu
