#include "reader/parts/ordered_cells.h"

namespace aeolic {

PartCells orderedCells(std::span<const std::int64_t> lengths)
{
    std::vector<std::int64_t> cells, steps;  // Of the directions in which there are cells.
    std::int64_t step = 1;
    for (const std::int64_t length : lengths) {
        if (length > 1) {
            cells.push_back(length - 1);
            steps.push_back(step);
        }
        step *= length;
    }
    PartCells all{cells.size() == 3 ? CellShape::hexahedron : CellShape::quad, 0, {}, {}, {}};
    if (cells.size() < 2) return all;
    cells.resize(3, 1);
    steps.resize(3, 0);
    all.count = std::size_t(cells[0] * cells[1] * cells[2]);
    all.corners.reserve(all.count * cornersOf(all.shape));
    const auto addRing = [&](std::int64_t at) {
        for (const std::int64_t corner : {at, at + steps[0], at + steps[0] + steps[1], at + steps[1]})
            all.corners.push_back(corner);
    };
    for (std::int64_t k = 0; k < cells[2]; ++k)
        for (std::int64_t j = 0; j < cells[1]; ++j)
            for (std::int64_t i = 0; i < cells[0]; ++i) {
                const std::int64_t at = i * steps[0] + j * steps[1] + k * steps[2];
                addRing(at);
                if (all.shape == CellShape::hexahedron) addRing(at + steps[2]);
            }
    return all;
}

}  // namespace aeolic
