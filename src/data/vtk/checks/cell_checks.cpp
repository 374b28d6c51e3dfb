#include "data/vtk/checks/cell_checks.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>

#include "aeolic/error.h"
#include "base/parallel.h"
#include "data/vtk/arrays.h"

namespace aeolic {
namespace {

constexpr std::size_t kIdsAtOnce = 1 << 16, kCellsAtOnce = 1 << 14;

template <class Array>
bool areSurelySound(Array& offsets, Array& corners, vtkIdType points)
{
    const vtkIdType cells = offsets.GetNumberOfValues() - 1;
    const auto *first = offsets.GetPointer(0), *ids = corners.GetPointer(0);
    if (cells < 0 || corners.GetNumberOfComponents() != 1) return false;
    if (first[0] != 0 || first[cells] != corners.GetNumberOfValues()) return false;
    return holdsForAll(std::size_t(cells), kIdsAtOnce,
                       [&](auto begin, auto end) { return std::is_sorted(first + begin, first + end + 1); }) &&
           holdsForAll(std::size_t(corners.GetNumberOfValues()), kIdsAtOnce, [&](auto begin, auto end) {
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

void requireTuples(vtkDataSet& data, const std::string& path)
{
    for (const bool onPoints : {true, false}) {
        vtkDataSetAttributes* all = attributesOf(data, onPoints);
        const vtkIdType expected = onPoints ? data.GetNumberOfPoints() : data.GetNumberOfCells();
        for (int i = 0; i < all->GetNumberOfArrays(); ++i) {
            vtkAbstractArray* array = all->GetAbstractArray(i);
            if (array->GetNumberOfTuples() != expected)
                throw InputError(path,
                                 fmt::format("array '{}' has {} values", array->GetName() ? array->GetName() : "",
                                             array->GetNumberOfTuples()),
                                 fmt::format("{}, one for each of the {}", expected, onPoints ? "points" : "cells"));
        }
    }
}

/// How many corners a cell of the type has: at least, and at most where that is not as many as it likes (-1). The least
/// is -1 for a type that there is not.
struct Corners {
    vtkIdType least = -1, most = -1;
};

constexpr vtkIdType kAny = -1;

/// How many corners a cell has, at least and at most, by VTK's type. VTK makes empty cells of the hidden ones of
/// structured grids, with their corners.
constexpr auto kCorners = [] {
    struct OfType {
        int type;
        vtkIdType least, most;
    };
    constexpr OfType all[] = {{VTK_EMPTY_CELL, 0, kAny},
                              {VTK_VERTEX, 1, 1},
                              {VTK_POLY_VERTEX, 1, kAny},
                              {VTK_LINE, 2, 2},
                              {VTK_POLY_LINE, 2, kAny},
                              {VTK_TRIANGLE, 3, 3},
                              {VTK_TRIANGLE_STRIP, 3, kAny},
                              {VTK_POLYGON, 3, kAny},
                              {VTK_PIXEL, 4, 4},
                              {VTK_QUAD, 4, 4},
                              {VTK_TETRA, 4, 4},
                              {VTK_VOXEL, 8, 8},
                              {VTK_HEXAHEDRON, 8, 8},
                              {VTK_WEDGE, 6, 6},
                              {VTK_PYRAMID, 5, 5},
                              {VTK_PENTAGONAL_PRISM, 10, 10},
                              {VTK_HEXAGONAL_PRISM, 12, 12},
                              {VTK_QUADRATIC_EDGE, 3, 3},
                              {VTK_QUADRATIC_TRIANGLE, 6, 6},
                              {VTK_QUADRATIC_QUAD, 8, 8},
                              {VTK_QUADRATIC_TETRA, 10, 10},
                              {VTK_QUADRATIC_HEXAHEDRON, 20, 20},
                              {VTK_QUADRATIC_WEDGE, 15, 15},
                              {VTK_QUADRATIC_PYRAMID, 13, 13},
                              {VTK_BIQUADRATIC_QUAD, 9, 9},
                              {VTK_TRIQUADRATIC_HEXAHEDRON, 27, 27},
                              {VTK_QUADRATIC_LINEAR_QUAD, 6, 6},
                              {VTK_QUADRATIC_LINEAR_WEDGE, 12, 12},
                              {VTK_BIQUADRATIC_QUADRATIC_WEDGE, 18, 18},
                              {VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24, 24},
                              {VTK_BIQUADRATIC_TRIANGLE, 7, 7},
                              {VTK_CUBIC_LINE, 4, 4},
                              {VTK_QUADRATIC_POLYGON, 6, kAny},
                              {VTK_TRIQUADRATIC_PYRAMID, 19, 19},
                              {VTK_POLYHEDRON, 4, kAny}};
    std::array<Corners, VTK_NUMBER_OF_CELL_TYPES> corners{};
    for (const auto& [type, least, most] : all) corners[std::size_t(type)] = {least, most};
    return corners;
}();

Corners cornersOf(int type)
{
    return type >= 0 && type < int(kCorners.size()) ? kCorners[std::size_t(type)] : Corners{};
}

/// The faces of a polyhedron are their number, and for each the number of its corners and the corners.
void requireFaces(vtkUnstructuredGrid& grid, vtkIdType cell, const std::string& path)
{
    vtkIdTypeArray *all = grid.GetFaces(), *locations = grid.GetFaceLocations();
    const vtkIdType size = all ? all->GetNumberOfValues() : 0, points = grid.GetNumberOfPoints();
    vtkIdType at = locations && cell < locations->GetNumberOfValues() ? locations->GetValue(cell) : -1;
    const vtkIdType faces = at >= 0 && at < size ? all->GetValue(at++) : 0;
    bool sound = faces > 0;
    for (vtkIdType face = 0; sound && face < faces; ++face) {
        const vtkIdType corners = at < size ? all->GetValue(at++) : 0;
        sound = corners > 0 && corners <= size - at;
        for (vtkIdType k = 0; sound && k < corners; ++k, ++at)
            sound = all->GetValue(at) >= 0 && all->GetValue(at) < points;
    }
    if (!sound)
        throw InputError(path, fmt::format("cell {} is a polyhedron without sound faces", cell), "faces of points");
}

/// Whether every cell has as many corners as its type needs, and none is a polyhedron. The arrays are read directly:
/// asking VTK cell by cell takes several times as long.
template <class Array>
bool areSimple(vtkUnstructuredGrid& grid, Array& offsets)
{
    const unsigned char* types = grid.GetCellTypesArray()->GetPointer(0);
    const auto* first = offsets.GetPointer(0);
    return holdsForAll(std::size_t(grid.GetNumberOfCells()), kCellsAtOnce, [&](std::size_t begin, std::size_t end) {
        Corners corners;
        int known = -1;
        for (std::size_t cell = begin; cell < end; ++cell) {
            if (const int type = types[cell]; type != known) {
                corners = cornersOf(type);
                known = type;
            }
            const vtkIdType size = first[cell + 1] - first[cell];
            const bool fits = size >= corners.least && (corners.most < 0 || size <= corners.most);
            if (corners.least < 0 || !fits || known == VTK_POLYHEDRON) return false;
        }
        return true;
    });
}

bool areSimple(vtkUnstructuredGrid& grid)
{
    vtkCellArray& cells = *grid.GetCells();
    return cells.IsStorage64Bit() ? areSimple(grid, *cells.GetOffsetsArray64())
                                  : areSimple(grid, *cells.GetOffsetsArray32());
}

void requireTypes(vtkUnstructuredGrid& grid, const std::string& path)
{
    vtkUnsignedCharArray* types = grid.GetCellTypesArray();
    const vtkIdType cells = grid.GetNumberOfCells();
    if (cells > 0 && (!types || types->GetNumberOfValues() < cells))
        throw InputError(path, fmt::format("{} cell types", types ? types->GetNumberOfValues() : 0),
                         fmt::format("one for each of the {} cells", cells));
    if (cells == 0 || areSimple(grid)) return;
    for (vtkIdType cell = 0; cell < cells; ++cell) {
        const int type = types->GetValue(cell);
        const vtkIdType size = grid.GetCells()->GetCellSize(cell);
        const Corners corners = cornersOf(type);
        cellTypeOf(type, cell, path);
        if (size < corners.least || (corners.most >= 0 && size > corners.most))
            throw InputError(path, fmt::format("cell {} of type {} has {} corners", cell, type, size),
                             fmt::format("{}{}", corners.least, corners.most < 0 ? " or more" : ""));
        if (type == VTK_POLYHEDRON) requireFaces(grid, cell, path);
    }
}

vtkIdType product(const int dims[3])
{
    return vtkIdType(dims[0]) * dims[1] * dims[2];
}

void requireSoundSet(vtkDataSet& data, const std::string& path)
{
    const vtkIdType points = data.GetNumberOfPoints();
    if (auto* polygons = vtkPolyData::SafeDownCast(&data)) requireSoundCells(*polygons, path);
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(&data)) {
        if (grid->GetCells()) requireSoundCells(*grid->GetCells(), points, path);
        requireTypes(*grid, path);
    }
    if (auto* grid = vtkStructuredGrid::SafeDownCast(&data)) {
        int dims[3];
        grid->GetDimensions(dims);
        if (product(dims) != points)
            throw InputError(path, fmt::format("{} points", points),
                             fmt::format("{} x {} x {}", dims[0], dims[1], dims[2]));
    }
    if (auto* grid = vtkRectilinearGrid::SafeDownCast(&data)) {
        vtkDataArray* axes[3] = {grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates()};
        for (int c = 0; c < 3; ++c)
            if (!axes[c] || axes[c]->GetNumberOfComponents() != 1 ||
                axes[c]->GetNumberOfTuples() != grid->GetDimensions()[c])
                throw InputError(
                    path, fmt::format("{} coordinates in {}", axes[c] ? axes[c]->GetNumberOfTuples() : 0, "xyz"[c]),
                    fmt::format("{}", grid->GetDimensions()[c]));
    }
    requireTuples(data, path);
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

unsigned char cellTypeOf(std::int64_t type, std::int64_t cell, const std::string& path)
{
    if (type < 0 || type > 255 || cornersOf(int(type)).least < 0)
        throw InputError(path, fmt::format("cell {} has the type {}", cell, type), "a linear or quadratic cell of VTK");
    return static_cast<unsigned char>(type);
}

void requireSoundData(vtkDataObject& data, const std::string& path)
{
    if (auto* single = vtkDataSet::SafeDownCast(&data)) requireSoundSet(*single, path);
    if (auto* blocks = vtkCompositeDataSet::SafeDownCast(&data)) {
        const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
        for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
            if (auto* block = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject())) requireSoundSet(*block, path);
    }
}

}  // namespace aeolic
