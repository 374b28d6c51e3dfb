#pragma once

#include <cstdint>
#include <span>

#include "data/mesh/surface_mesh.h"
#include "render/cpu/project/edge_pixels.h"
#include "render/cpu/project/raster/raster.h"
#include "render/cpu/project/raster/transform.h"

namespace aeolic::cpu {

/// Draws triangles into the samples of edge pixels by drawTriangle()'s rules: `keys`, [pixels.count()][kSamples], are
/// those of TileKeys. Local. Cost: 20 ns a triangle, and 10 ns for each edge pixel it may cover.
void sampleTriangles(const SurfaceMesh& mesh, const ScreenVertices& screen, std::span<const std::uint32_t> ids,
                     const EdgePixels& pixels, const DrawRule& rule, std::uint64_t* keys);

/// One triangle, of any size.
void sampleTriangle(const Corner& a, const Corner& b, const Corner& c, std::uint32_t id, const EdgePixels& pixels,
                    const DrawRule& rule, std::uint64_t* keys);

}  // namespace aeolic::cpu
