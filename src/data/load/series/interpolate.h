#pragma once

#include <memory>
#include <optional>

#include "data/loaded_surface.h"
#include "data/vector_field.h"

namespace aeolic {

/// Between two moments of the data values are interpolated linearly: value = first + weight (second - first), in double
/// precision, rounded once. Where either is masked (NaN), so is the result. Each value is computed by itself, so a
/// brick gets the bits of the whole.

/// Whether two moments of a field are on the same grid, the same part of it, and its samples lie in the same way.
bool sameGrid(const GridField& a, const GridField& b);

/// The field between `first` and `second`, which are on the same grid. `reuse`: the result of an earlier call, whose
/// memory is taken where it fits; nobody else may be reading it. Throws InputError where there is not enough memory.
/// Cost: one parallel pass.
std::shared_ptr<GridField> interpolated(const GridField& first, const GridField& second, double weight,
                                        std::shared_ptr<GridField> reuse = nullptr);

/// Whether two moments of a surface have the same points, polygons and arrays. The whole has where all of its pieces
/// have. Cost: nothing, or a pass over the points where polygons were cut into other triangles.
bool interpolable(const LoadedSurface& first, const LoadedSurface& second);

/// The surface between two moments, to be finished; nothing where it is not interpolable. Triangles are those of
/// `first`. Normals, where both have them, are of unit length again. Cost: a pass over the surface.
std::optional<LoadedSurface> interpolated(const LoadedSurface& first, const LoadedSurface& second, double weight);

/// Moves the mesh's origin; points stay where they are in the world, to a float's precision.
void setOrigin(SurfaceMesh& mesh, const glm::dvec3& originWorld);

}  // namespace aeolic
