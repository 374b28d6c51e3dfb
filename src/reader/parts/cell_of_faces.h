#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "reader/parts/part_source.h"

namespace aeolic {

/// A cell with its corners in the order of its shape.
struct ShapedCell {
    CellShape shape;
    std::vector<std::int64_t> corners;
};

/// The tetrahedron, pyramid, wedge or hexahedron that has these faces, seen from outside; nothing where they are those
/// of another cell.
std::optional<ShapedCell> cellOfFaces(std::span<const std::span<const std::int64_t>> faces);

/// The polygon whose edges these are, in any order and direction; empty where the edges make no polygon or several.
std::vector<std::int64_t> polygonOfEdges(std::span<const std::span<const std::int64_t>> edges);

}  // namespace aeolic
