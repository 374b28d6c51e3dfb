#pragma once

#include <array>

#include "reader/parts/cell_faces.h"

namespace aeolic {

/// A cell's faces by its corners, seen from outside; -1 ends a face of three.
struct ShapeFaces {
    int count;
    std::array<std::array<int, 4>, 6> corners;
};
const ShapeFaces& facesOfShape(CellShape shape);

template <class Take>
void forEachFaceOf(const PartCells& cells, const Take& take)
{
    if (!fillsSpace(cells.shape)) return;
    std::size_t at = 0, ofFace = 0;
    if (cells.shape == CellShape::polyhedron) {
        for (std::size_t cell = 0; cell < cells.count; ++cell)
            for (std::int64_t k = 0; k < cells.sizes[cell]; ++k) {
                const auto size = std::size_t(cells.ofFaces[ofFace++]);
                take(cell, std::span(cells.corners).subspan(at, size));
                at += size;
            }
        return;
    }
    const ShapeFaces& faces = facesOfShape(cells.shape);
    const std::size_t corners = cornersOf(cells.shape);
    std::array<std::int64_t, 4> own;
    for (std::size_t cell = 0; cell < cells.count; ++cell)
        for (int k = 0; k < faces.count; ++k) {
            std::size_t size = 0;
            for (const int corner : faces.corners[std::size_t(k)])
                if (corner >= 0) own[size++] = cells.corners[cell * corners + std::size_t(corner)];
            take(cell, std::span<const std::int64_t>(own).first(size));
        }
}

}  // namespace aeolic
