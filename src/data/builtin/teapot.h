#pragma once

#include <cstdint>

#include "data/mesh/surface_mesh.h"

namespace aeolic {

/// Newell's teapot with at least `triangles` triangles: 64 n^2 - 8 n for the smallest n >= 2 that suffices, n being the
/// number of segments along each patch edge. The 32 patches are body (16, with the bottom), lid (8), handle (4) and
/// spout (4); each of the four parts is without cracks: where patches meet, positions are equal bit by bit. Points: 32
/// (n + 1)^2. `name` is left empty. Cost: parallel, O(triangles).
SurfaceMesh makeTeapot(std::int64_t triangles);

}  // namespace aeolic
