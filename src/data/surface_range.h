#pragma once

#include <array>
#include <optional>

#include "data/surface_mesh.h"
#include "data/vector_field.h"

namespace aeolic {

/// Least and greatest finite value, or nothing if none is finite. Parallel; the result does not depend on how it is
/// cut.
std::optional<std::array<double, 2>> finiteRange(const std::vector<float>& values);

/// The same of the field's values (of the vectors' lengths, for three components) on the surface: at its points, and
/// within triangles larger than the field's cells at points about a cell apart. Trilinear, outside the field nothing;
/// of a brick what lies in its own cells.
std::optional<std::array<double, 2>> rangeOnSurface(const SurfaceMesh& mesh, const GridField& field);

/// Whether any triangle's bounds meet the box.
bool meets(const SurfaceMesh& mesh, const Bounds& boxWorld);

Bounds boundsOf(const GridField& field);

}  // namespace aeolic
