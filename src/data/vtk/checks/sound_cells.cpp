#include "data/vtk/checks/sound_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

#include "aeolic/error.h"
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

/// Throws for the first cell with a corner that is not a point. Every corner belongs to a cell.
void requireCorners(vtkCellArray& cells, vtkIdType points, const std::string& where, std::string_view kind)
{
    const std::string expected = points > 0 ? fmt::format("points from 0 to {}", points - 1) : "at least one point";
    for (vtkIdType cell = 0; cell < cells.GetNumberOfCells(); ++cell) {
        vtkIdType count = 0;
        const vtkIdType* ids = nullptr;
        cells.GetCellAtId(cell, count, ids);
        const auto* bad = std::find_if(ids, ids + count, [&](vtkIdType id) { return id < 0 || id >= points; });
        if (bad != ids + count)
            throw InputError(where, fmt::format("{} {} refers to point {}, which does not exist", kind, cell, *bad),
                             expected);
    }
}

}  // namespace

void requireSoundCells(vtkCellArray& cells, vtkIdType points, const std::string& where, std::string_view kind)
{
    if (cells.GetNumberOfCells() == 0) return;
    const bool surely = cells.IsStorage64Bit()
                            ? areSurelySound(*cells.GetOffsetsArray64(), *cells.GetConnectivityArray64(), points)
                            : areSurelySound(*cells.GetOffsetsArray32(), *cells.GetConnectivityArray32(), points);
    if (surely) return;
    if (!cells.IsValid())
        throw InputError(where, fmt::format("the corners of a {} do not begin where those before it end", kind),
                         "cells one after the other");
    requireCorners(cells, points, where, kind);
}

void requireSoundCells(vtkPolyData& polyData, const std::string& where)
{
    const vtkIdType points = polyData.GetNumberOfPoints();
    requireSoundCells(*polyData.GetVerts(), points, where, "vertex");
    requireSoundCells(*polyData.GetLines(), points, where, "line");
    requireSoundCells(*polyData.GetPolys(), points, where, "polygon");
    requireSoundCells(*polyData.GetStrips(), points, where, "strip");
}

}  // namespace aeolic
