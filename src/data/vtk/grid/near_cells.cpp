#include "data/vtk/grid/near_cells.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "base/parallel.h"

namespace aeolic {
namespace {

using BoxOf = std::function<Bounds(std::size_t)>;

/// The arrays of an unstructured grid are read directly: asking VTK cell by cell takes several times as long.
template <class Offset, class Coordinate>
BoxOf boxesOf(const Offset* offsets, const Offset* corners, const Coordinate* points)
{
    return [=](std::size_t cell) {
        Bounds box;
        for (Offset k = offsets[cell]; k < offsets[cell + 1]; ++k) {
            const Coordinate* p = points + 3 * corners[k];
            box.add(glm::dvec3(p[0], p[1], p[2]));
        }
        return box;
    };
}

template <class Coordinate>
BoxOf boxesOf(vtkCellArray& cells, const Coordinate* points)
{
    if (cells.IsStorage64Bit())
        return boxesOf(cells.GetOffsetsArray64()->GetPointer(0), cells.GetConnectivityArray64()->GetPointer(0), points);
    return boxesOf(cells.GetOffsetsArray32()->GetPointer(0), cells.GetConnectivityArray32()->GetPointer(0), points);
}

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

BoxOf cellBoxesOf(vtkDataSet& data)
{
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(&data); grid && grid->GetNumberOfCells() > 0) {
        vtkDataArray* points = grid->GetPoints()->GetData();
        if (auto* floats = vtkFloatArray::SafeDownCast(points))
            return boxesOf(*grid->GetCells(), floats->GetPointer(0));
        if (auto* doubles = vtkDoubleArray::SafeDownCast(points))
            return boxesOf(*grid->GetCells(), doubles->GetPointer(0));
    }
    double first[6];
    if (data.GetNumberOfCells() > 0) data.GetCellBounds(0, first);  // VTK prepares itself; then any thread may ask.
    return [&data](std::size_t cell) {
        double b[6];
        data.GetCellBounds(vtkIdType(cell), b);
        Bounds box;
        box.lo = {b[0], b[2], b[4]};
        box.hi = {b[1], b[3], b[5]};
        return box;
    };
}

bool isFinite(const Bounds& box)
{
    return !box.empty() && std::isfinite(box.diagonal());
}

CellRuns runsOfCells(vtkDataSet& data)
{
    const BoxOf boxOf = cellBoxesOf(data);
    const auto cells = std::size_t(data.GetNumberOfCells());
    CellRuns all;
    all.runs.resize((cells + CellRun::kCells - 1) / CellRun::kCells);
    std::mutex joining;
    parallelRanges(all.runs.size(), 128, [&](std::size_t begin, std::size_t end) {
        Bounds some;
        for (std::size_t i = begin; i < end; ++i) {
            Bounds middles;
            CellRun& run = all.runs[i];
            run.leastDiagonal = std::numeric_limits<double>::infinity();
            run.mostDiagonal = -1;
            const std::size_t last = std::min(cells, (i + 1) * CellRun::kCells);
            for (std::size_t cell = i * CellRun::kCells; cell < last; ++cell) {
                const Bounds box = boxOf(cell);
                if (!isFinite(box)) continue;
                some.add(box);
                middles.add(box.center());
                run.leastDiagonal = std::min(run.leastDiagonal, box.diagonal());
                run.mostDiagonal = std::max(run.mostDiagonal, box.diagonal());
            }
            run.middles = CellTree::Box::around(middles);
        }
        const std::lock_guard lock(joining);
        all.bounds.add(some);
    });
    return all;
}

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
