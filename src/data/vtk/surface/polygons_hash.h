#pragma once

#include <vtkPolyData.h>

#include <cstdint>

namespace aeolic {

/// A hash of which points every polygon and strip joins: LoadedSurface::topology. Cost: one pass over the polygons.
std::uint64_t polygonsHash(vtkPolyData& polyData);

}  // namespace aeolic
