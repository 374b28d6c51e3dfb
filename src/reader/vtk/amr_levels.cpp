#include "reader/vtk/amr_levels.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace aeolic {
namespace {

/// Middles of cells that lie so near to a block's border count as beside it, in widths of cells.
constexpr double kSlack = 1e-6;

vtkUnsignedCharArray& flagsOf(vtkImageData& grid)
{
    const char* const name = vtkDataSetAttributes::GhostArrayName();
    vtkCellData& cells = *grid.GetCellData();
    if (auto* flags = vtkUnsignedCharArray::SafeDownCast(cells.GetArray(name))) return *flags;
    vtkSmartPointer<vtkUnsignedCharArray> made = vtkSmartPointer<vtkUnsignedCharArray>::New();
    made->SetName(name);
    made->SetNumberOfValues(grid.GetNumberOfCells());
    made->FillValue(0);
    cells.AddArray(made);
    return *vtkUnsignedCharArray::SafeDownCast(cells.GetArray(name));
}

/// The cells along an axis whose middles lie within a range: [first, last).
std::array<int, 2> cellsWithin(vtkImageData& grid, int axis, double lo, double hi)
{
    const int cells = std::max(grid.GetDimensions()[axis] - 1, 1);
    const double width = grid.GetSpacing()[axis], first = grid.GetOrigin()[axis] + grid.GetExtent()[2 * axis] * width;
    if (grid.GetDimensions()[axis] < 2) return {0, 1};  // A flat grid.
    if (!(width > 0) || !std::isfinite(width) || !std::isfinite(first)) return {0, 0};
    const auto at = [&](double place) { return (place - first) / width - 0.5; };
    const double begin = std::ceil(at(lo) + kSlack), end = std::floor(at(hi) - kSlack) + 1;
    return {int(std::clamp(begin, 0.0, double(cells))), int(std::clamp(end, 0.0, double(cells)))};
}

void hideWithin(vtkImageData& grid, const double (&bounds)[6])
{
    std::array<std::array<int, 2>, 3> range{};
    for (int axis = 0; axis < 3; ++axis) {
        range[std::size_t(axis)] = cellsWithin(grid, axis, bounds[2 * axis], bounds[2 * axis + 1]);
        if (range[std::size_t(axis)][0] >= range[std::size_t(axis)][1]) return;
    }
    vtkUnsignedCharArray& flags = flagsOf(grid);
    const auto across = vtkIdType(std::max(grid.GetDimensions()[0] - 1, 1)),
               down = vtkIdType(std::max(grid.GetDimensions()[1] - 1, 1));
    for (int z = range[2][0]; z < range[2][1]; ++z)
        for (int y = range[1][0]; y < range[1][1]; ++y)
            for (int x = range[0][0]; x < range[0][1]; ++x) {
                const vtkIdType cell = (vtkIdType(z) * down + y) * across + x;
                flags.SetValue(cell, flags.GetValue(cell) | vtkDataSetAttributes::REFINEDCELL);
            }
}

}  // namespace

void hideRefined(const std::vector<LeveledBlock>& blocks)
{
    for (const LeveledBlock& coarse : blocks)
        for (const LeveledBlock& fine : blocks) {
            if (fine.level <= coarse.level) continue;
            auto* const grid = vtkImageData::SafeDownCast(coarse.data);
            auto* const over = vtkImageData::SafeDownCast(fine.data);
            if (!grid || !over || over->GetNumberOfCells() == 0) continue;
            double bounds[6];
            over->GetBounds(bounds);
            hideWithin(*grid, bounds);
        }
}

}  // namespace aeolic
