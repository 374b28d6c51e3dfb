#include "data/vtk/grid/cell_boxes.h"

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

}  // namespace aeolic
