#include "data/vtk/grid/near_cells.h"

#include "base/parallel.h"

namespace aeolic {
namespace {

/// The first cells of the runs that may have a cell that is near, and a box around the middles of their cells.
struct NearRuns {
    std::vector<std::size_t> first;
    Bounds middles;
};

/// `leftOut` gets the other runs.
NearRuns nearRunsOf(const std::vector<CellRun>& runs, const NearSurface& surface, double diagonals, LeftOut& leftOut)
{
    std::vector<char> near(runs.size());
    parallelRanges(near.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (runs[i].mostDiagonal >= 0) {
                near[i] = surface.mayBeNear(runs[i].middles, diagonals * runs[i].mostDiagonal);
                if (!near[i]) leftOut.add(runs[i].middles, runs[i].leastDiagonal);
            }
    });
    NearRuns some;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (!near[i]) continue;
        some.first.push_back(i * CellRun::kCells);
        some.middles.add(glm::dvec3(runs[i].middles.lo));
        some.middles.add(glm::dvec3(runs[i].middles.hi));
    }
    return some;
}

}  // namespace

NearCells nearCellsOf(vtkDataSet& data, const CellRuns& all, NearSurface& surface, double diagonals)
{
    NearCells cells;
    cells.chosen.resize(std::size_t(data.GetNumberOfCells()), 0);
    cells.leftOut = LeftOut(all.bounds, cells.chosen.size());
    const NearRuns runs = nearRunsOf(all.runs, surface, diagonals, cells.leftOut);
    const auto boxOf = cellBoxesOf(data);
    const auto cellAt = [&](std::size_t i) { return runs.first[i / CellRun::kCells] + i % CellRun::kCells; };
    const std::size_t count = runs.first.size() * CellRun::kCells;
    surface.prepare(runs.middles, count, [&](std::size_t i) {
        const Bounds box = cellAt(i) < cells.chosen.size() ? boxOf(cellAt(i)) : Bounds();
        return NearSurface::Question{box.center(), isFinite(box) ? diagonals * box.diagonal() : -1};
    });
    parallelRanges(count, 4096, [&](std::size_t begin, std::size_t end) {
        std::uint32_t hint = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t cell = cellAt(i);
            if (cell >= cells.chosen.size()) continue;
            const Bounds box = boxOf(cell);
            if (!isFinite(box)) continue;
            const double diagonal = box.diagonal();
            cells.chosen[cell] = surface.isNear(box.center(), diagonals * diagonal, hint);
            if (!cells.chosen[cell]) cells.leftOut.add(box.center(), diagonal);
        }
    });
    return cells;
}

}  // namespace aeolic
