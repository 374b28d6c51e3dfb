#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "aeolic/surface_spec.h"
#include "data/mesh/surface_mesh.h"
#include "data/vector_field.h"

namespace aeolic {

/// Where `scalar`, interpolated along the edges of `cells`, is `value`: marching cubes (Lorensen and Cline 1987), by
/// VTK's table of cases. Each edge has one point; its normal is the normalised gradient of the samples (central
/// differences). Triangles come by cell, x fastest; `order` tells where they stand among those of the whole grid. There
/// is nothing at masked samples. The surface may be empty, and may have triangles without an area.
///
/// A cell's triangles are the same, bit for bit, whichever part of the grid is held, so long as that has one more layer
/// of samples around `cells`: everything is computed from global indices, and nothing from more than a point's own two
/// samples and their neighbours. VTK's filter would not do: it adds indices to where its part begins.
///
/// `scalar`: floats of one component. Cost: a few passes over the cells' samples, parallel.
SurfaceMesh isosurface(const GridField& scalar, const Brick& cells, double value);

/// How large an isosurface is.
struct IsosurfaceSize {
    std::uint64_t points = 0, triangles = 0;
    /// What extracting it takes: layers and the mesh that is made of them lie in memory together.
    std::uint64_t bytes() const
    {
        return 2 * (points * 2 * sizeof(glm::vec3) +
                    triangles * (sizeof(std::array<std::uint32_t, 3>) + sizeof(std::uint64_t)));
    }
};

/// How large isosurface() would be. Cost: one pass over the cells' samples, parallel, and hardly any memory.
IsosurfaceSize isosurfaceSize(const GridField& scalar, const Brick& cells, double value);

/// Throws InputError, which begins with `where` (the file's name), where `readers` ranks of this host that extract
/// surfaces of so many triangles and bytes at once would find no memory for it, or where there are more points than
/// indices.
void requireRoomFor(const SurfaceSpec& spec, const std::string& where, const IsosurfaceSize& size, int readers);

/// Throws InputError, which begins with `where` (the file's name), unless the isosurface's value lies within `range`,
/// that of the array's finite values.
void requireWithinRange(const SurfaceSpec& spec, const std::string& where, const std::array<double, 2>& range);

/// Throws InputError, which begins with `where` (the file's name), unless the isosurface's value lies within `range`
/// and it has triangles.
void requireIsosurface(const SurfaceSpec& spec, const std::string& where, const std::array<double, 2>& range,
                       std::size_t triangles);

}  // namespace aeolic
