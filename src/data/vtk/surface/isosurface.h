#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "data/surface_mesh.h"
#include "data/vector_field.h"
#include "description/surface_spec.h"

namespace aeolic {

/// Where `scalar`, interpolated along the edges of `cells`, is `value`: marching cubes (Lorensen and Cline 1987), by
/// VTK's table of cases. One point an edge, with the normalised gradient of the samples (central differences) as its
/// normal; triangles by cell, x fastest, of which `order` tells where they stand in the whole grid's. Nothing at masked
/// samples. May be empty, and may have triangles without an area.
///
/// A cell's triangles are the same, bit for bit, whichever part of the grid is held, so long as that has one more layer
/// of samples around `cells`: everything is computed from global indices, and nothing from more than a point's own two
/// samples and their neighbours. That is why it is not VTK's filter, which adds indices to where its part begins.
///
/// `scalar`: floats of one component. Cost: a few passes over the cells' samples, parallel.
SurfaceMesh isosurface(const GridField& scalar, const Brick& cells, double value);

/// Throws InputError unless the value lies within the array's finite values, of which this is the range …
void requireWithinRange(const SurfaceSpec& spec, const std::string& where, const std::array<double, 2>& range);

/// … and the isosurface, as it came out, has triangles. `where` (the file's name) stands in front.
void requireIsosurface(const SurfaceSpec& spec, const std::string& where, const std::array<double, 2>& range,
                       std::size_t triangles);

}  // namespace aeolic
