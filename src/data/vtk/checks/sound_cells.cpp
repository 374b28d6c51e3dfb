#include "data/vtk/checks/sound_cells.h"

#include <algorithm>
#include <atomic>

#include "base/parallel.h"

namespace aeolic {
namespace {

/// Calls test(begin, end) for ranges that cover [0, count). Whether it holds for all.
template <class Test>
bool holdsForAll(vtkIdType count, const Test& test)
{
    std::atomic<bool> all = true;
    parallelRanges(std::size_t(count), 1 << 16, [&](std::size_t begin, std::size_t end) {
        if (!test(begin, end)) all = false;
    });
    return all;
}

template <class Array>
bool areSurelySound(Array& offsets, Array& corners, vtkIdType points)
{
    const vtkIdType cells = offsets.GetNumberOfValues() - 1;
    const auto *first = offsets.GetPointer(0), *ids = corners.GetPointer(0);
    if (cells < 0 || corners.GetNumberOfComponents() != 1) return false;
    if (first[0] != 0 || first[cells] != corners.GetNumberOfValues()) return false;
    return holdsForAll(cells, [&](auto begin, auto end) { return std::is_sorted(first + begin, first + end + 1); }) &&
           holdsForAll(corners.GetNumberOfValues(), [&](auto begin, auto end) {
               vtkIdType signs = 0;  // Negative as soon as one is. A loop without branches handles several at once.
               for (auto k = begin; k < end; ++k) signs |= vtkIdType(ids[k]) | (points - 1 - vtkIdType(ids[k]));
               return signs >= 0;
           });
}

}  // namespace

bool cellsAreSound(vtkCellArray& cells, vtkIdType points)
{
    if (cells.GetNumberOfCells() == 0) return true;
    const bool surely = cells.IsStorage64Bit()
                            ? areSurelySound(*cells.GetOffsetsArray64(), *cells.GetConnectivityArray64(), points)
                            : areSurelySound(*cells.GetOffsetsArray32(), *cells.GetConnectivityArray32(), points);
    if (surely) return true;
    if (!cells.IsValid()) return false;
    double range[2];
    vtkDataArray* ids = cells.GetConnectivityArray();
    ids->GetRange(range, 0);
    return ids->GetNumberOfValues() == 0 || (range[0] >= 0 && range[1] < double(points));
}

}  // namespace aeolic
