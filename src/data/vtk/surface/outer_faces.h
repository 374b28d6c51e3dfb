#pragma once

#include <vtkUnstructuredGrid.h>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace aeolic {

/// Faces of a grid's cells that no other cell has.
struct OuterFaces {
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    std::vector<std::array<std::uint32_t, 4>> corners;  ///< [faces] Points of the grid; a triangle's last is kNone.
    std::vector<std::uint32_t> cells;                   ///< [faces] Whose they are.
};

/// The outer faces in the order and with the first corners that vtkDataSetSurfaceFilter gives them: by the smallest
/// corner, then by cell. A face of three cells or more is not an outer one. Nothing where the grid has other cells
/// than tetrahedra, pyramids, wedges, hexahedra and voxels, or point ghosts, or more points or cells than 32 bits
/// count. The cells must refer to points that there are. Parallel; the same from any number of threads. Cost: two
/// passes over the cells, and 8 bytes a point beside the faces.
std::optional<OuterFaces> outerFacesOf(vtkUnstructuredGrid& grid);

}  // namespace aeolic
