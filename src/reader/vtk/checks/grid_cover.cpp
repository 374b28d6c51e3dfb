#include "reader/vtk/checks/grid_cover.h"

#include <algorithm>
#include <utility>

namespace aeolic {
namespace {

/// Cells from a first to one behind the last. A layer of points counts as one of cells where the whole grid is flat.
using CellBox = std::array<std::int64_t, 6>;

CellBox cellsOf(const GridExtent& extent, const GridExtent& whole)
{
    CellBox cells = extent;
    for (std::size_t c = 0; c < 6; c += 2)
        if (whole[c] == whole[c + 1]) cells[c + 1] = cells[c] + 1;
    return cells;
}

bool isEmpty(const CellBox& box)
{
    return box[0] >= box[1] || box[2] >= box[3] || box[4] >= box[5];
}

/// Takes `part` out of the boxes, of which it may cut some into several.
void takeOut(const CellBox& part, std::vector<CellBox>& boxes)
{
    std::vector<CellBox> left;
    for (CellBox box : boxes) {
        CellBox common{};
        for (std::size_t c = 0; c < 6; c += 2) {
            common[c] = std::max(box[c], part[c]);
            common[c + 1] = std::min(box[c + 1], part[c + 1]);
        }
        if (isEmpty(common)) {
            left.push_back(box);
            continue;
        }
        for (std::size_t c = 0; c < 6; c += 2) {
            CellBox below = box, above = box;
            below[c + 1] = box[c] = common[c];
            above[c] = box[c + 1] = common[c + 1];
            for (const CellBox& rest : {below, above})
                if (!isEmpty(rest)) left.push_back(rest);
        }
    }
    boxes = std::move(left);
}

}  // namespace

std::optional<std::array<std::int64_t, 3>> firstUncovered(const std::vector<GridExtent>& pieces,
                                                          const GridExtent& whole)
{
    std::vector<CellBox> missing{cellsOf(whole, whole)};
    for (const GridExtent& piece : pieces) takeOut(cellsOf(piece, whole), missing);
    if (missing.empty()) return std::nullopt;
    return std::array{missing.front()[0], missing.front()[2], missing.front()[4]};
}

}  // namespace aeolic
