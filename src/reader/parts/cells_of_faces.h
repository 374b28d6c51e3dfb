#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "reader/parts/cell_faces.h"

namespace aeolic {

/// Faces of a mesh with the cells on both sides. They turn as they are seen from `outside`. All faces of a large mesh
/// are kept, so numbers are short.
struct MeshFaces : PolygonList<std::uint32_t> {
    std::vector<std::uint32_t> inside, outside;  ///< [count()] Numbers of cells from 1; 0: none.

    static constexpr std::uint64_t kMost = std::numeric_limits<std::int32_t>::max();  ///< Of points, cells and faces.
};

/// Which corner a cell begins with: a simple cell with one of its base, a polyhedron's face with one of its own.
enum class FirstCorner : std::uint8_t {
    last,   ///< The base's last one. A face that is seen from the other side begins with its last corner.
    first,  ///< The base's first one; of a wedge its other triangle comes first. Every face begins with its first.
};

/// The cells that a mesh's faces enclose.
class CellsOfFaces {
public:
    /// `cells`: how many there are. No number in `faces` is larger. `where`: in front of messages.
    CellsOfFaces(MeshFaces faces, std::size_t cells, FirstCorner firstCorner, std::string where);

    const MeshFaces& faces() const { return faces_; }

    /// The faces of a cell, by their numbers from 1, increasing. Negative: the cell is on the face's outside.
    std::span<const std::int32_t> facesOf(std::size_t cell) const
    {
        return std::span(list_).subspan(begins_[cell], begins_[cell + 1] - begins_[cell]);
    }

    /// Cells `first` to `last`, numbered from 1, in this order: tetrahedra, pyramids, wedges and hexahedra where the
    /// faces are those of one, else polyhedra. Throws InputError for a cell that its faces do not close.
    std::vector<PartCells> cells(std::int64_t first, std::int64_t last) const;

    /// The polygons of a flat mesh, whose faces are edges: cells `first` to `last`, numbered from 1. Throws InputError
    /// for a polygon that its edges do not close.
    std::vector<PartCells> polygons(std::int64_t first, std::int64_t last) const;

private:
    class Turned;

    MeshFaces faces_;  // Without the cells on both sides.
    FirstCorner firstCorner_;
    std::string where_;
    std::vector<std::size_t> begins_;  // [cells + 1] Where each one's faces begin in list_.
    std::vector<std::int32_t> list_;
};

}  // namespace aeolic
