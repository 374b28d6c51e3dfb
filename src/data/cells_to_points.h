#pragma once

#include "data/mesh/surface_mesh.h"

namespace aeolic {

/// Brings values of triangles to the points, whose value is the mean of the triangles around it, by their angles there.
/// So it does not matter into which triangles a flat polygon was cut. Nothing crosses edges at which points are split,
/// as computeSmoothNormals() splits them. Masked triangles stay masked, with points of their own, and count for no
/// other. Cost: a few passes over the triangles.
void bringCellsToPoints(SurfaceMesh& mesh);

}  // namespace aeolic
