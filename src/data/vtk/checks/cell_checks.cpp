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

#include <atomic>

#include "aeolic/error.h"
#include "base/parallel.h"
#include "data/vtk/checks/sound_cells.h"

namespace aeolic {
namespace {

void requireTuples(vtkDataSet& data, const std::string& path)
{
    for (const bool onPoints : {true, false}) {
        vtkFieldData* all = onPoints ? static_cast<vtkFieldData*>(data.GetPointData()) : data.GetCellData();
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

Corners cornersOf(int type)
{
    switch (type) {
        case VTK_EMPTY_CELL:  // What VTK makes of the hidden cells of structured grids, with their corners.
            return {0, -1};
        case VTK_VERTEX:
            return {1, 1};
        case VTK_POLY_VERTEX:
            return {1, -1};
        case VTK_LINE:
            return {2, 2};
        case VTK_POLY_LINE:
            return {2, -1};
        case VTK_TRIANGLE:
            return {3, 3};
        case VTK_TRIANGLE_STRIP:
        case VTK_POLYGON:
            return {3, -1};
        case VTK_PIXEL:
        case VTK_QUAD:
        case VTK_TETRA:
            return {4, 4};
        case VTK_VOXEL:
        case VTK_HEXAHEDRON:
            return {8, 8};
        case VTK_WEDGE:
            return {6, 6};
        case VTK_PYRAMID:
            return {5, 5};
        case VTK_PENTAGONAL_PRISM:
            return {10, 10};
        case VTK_HEXAGONAL_PRISM:
            return {12, 12};
        case VTK_QUADRATIC_EDGE:
            return {3, 3};
        case VTK_QUADRATIC_TRIANGLE:
            return {6, 6};
        case VTK_QUADRATIC_QUAD:
            return {8, 8};
        case VTK_QUADRATIC_TETRA:
            return {10, 10};
        case VTK_QUADRATIC_HEXAHEDRON:
            return {20, 20};
        case VTK_QUADRATIC_WEDGE:
            return {15, 15};
        case VTK_QUADRATIC_PYRAMID:
            return {13, 13};
        case VTK_BIQUADRATIC_QUAD:
            return {9, 9};
        case VTK_TRIQUADRATIC_HEXAHEDRON:
            return {27, 27};
        case VTK_QUADRATIC_LINEAR_QUAD:
            return {6, 6};
        case VTK_QUADRATIC_LINEAR_WEDGE:
            return {12, 12};
        case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
            return {18, 18};
        case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON:
            return {24, 24};
        case VTK_BIQUADRATIC_TRIANGLE:
            return {7, 7};
        case VTK_CUBIC_LINE:
            return {4, 4};
        case VTK_QUADRATIC_POLYGON:
            return {6, -1};
        case VTK_TRIQUADRATIC_PYRAMID:
            return {19, 19};
        case VTK_POLYHEDRON:
            return {4, -1};
        default:
            return {};
    }
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
    std::atomic<bool> all = true;
    parallelRanges(std::size_t(grid.GetNumberOfCells()), 1 << 14, [&](std::size_t begin, std::size_t end) {
        Corners corners;
        int known = -1;
        for (std::size_t cell = begin; cell < end; ++cell) {
            if (const int type = types[cell]; type != known) {
                corners = cornersOf(type);
                known = type;
            }
            const vtkIdType size = first[cell + 1] - first[cell];
            const bool fits = size >= corners.least && (corners.most < 0 || size <= corners.most);
            if (corners.least < 0 || !fits || known == VTK_POLYHEDRON) all = false;
        }
    });
    return all;
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
