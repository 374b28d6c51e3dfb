#pragma once

#include <memory>
#include <optional>

#include "data/load/loaded_surface.h"
#include "data/vector_field.h"

namespace aeolic {

/// Between two moments of the data, linearly: value = first + weight (second - first), in double precision, rounded
/// once; where either is masked (NaN) the result is. Each value by itself, so a brick gets the bits of the whole.

/// Whether two moments of a field are on the same grid, the same part of it, and its samples lie in the same way.
bool sameGrid(const GridField& a, const GridField& b);

/// `first` and `second` on the same grid. `reuse`: the result of an earlier call, whose memory is taken where it fits;
/// nobody else may be reading it. Throws InputError where there is not enough memory. Cost: one parallel pass.
std::shared_ptr<GridField> interpolated(const GridField& first, const GridField& second, double weight,
                                        std::shared_ptr<GridField> reuse = nullptr);

/// Whether two moments of a surface have the same points, polygons and arrays. Of pieces: whether these have, and the
/// whole has where all have. Cost: nothing, or a pass over the points where polygons were cut into other triangles.
bool interpolable(const LoadedSurface& first, const LoadedSurface& second);

/// Two moments of a surface, or nothing where their points and polygons are not the same or their arrays differ.
/// Triangles are those of `first`; normals, where both have them, are of unit length again. To be finished. Cost: a
/// pass over the surface.
std::optional<LoadedSurface> interpolated(const LoadedSurface& first, const LoadedSurface& second, double weight);

/// Moves the mesh's origin; points stay where they are in the world, to a float's precision.
void setOrigin(SurfaceMesh& mesh, const glm::dvec3& originWorld);

}  // namespace aeolic
