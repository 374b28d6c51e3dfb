#include "data/vtk/memory/memory_volume.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <limits>

#include "aeolic/error.h"
#include "data/vtk/checks/cell_checks.h"
#include "data/vtk/linear_cells.h"
#include "data/vtk/memory/memory_arrays.h"

namespace aeolic {
namespace {

void requireOneEach(const ArrayView& view, vtkIdType cells, const std::string& where)
{
    requireComponents(view, 1, where);
    if (view.count != cells)
        throw InputError(where, fmt::format("{} values", view.count),
                         fmt::format("{}, one for each of the cells", cells));
}

/// VTK's numbers of cell types, a byte each.
vtkSmartPointer<vtkUnsignedCharArray> typesOf(const Volume& volume, vtkIdType cells, const std::string& name)
{
    const std::string where = name + ": types";
    requireOneEach(volume.types, cells, where);
    if (cells == 0) return vtkSmartPointer<vtkUnsignedCharArray>::New();
    if (volume.types.type == ValueType::uint8) return vtkUnsignedCharArray::SafeDownCast(wrapped(volume.types, where));
    const auto given = wrappedIndices(volume.types, where);
    auto types = vtkSmartPointer<vtkUnsignedCharArray>::New();
    types->SetNumberOfValues(cells);
    for (vtkIdType i = 0; i < cells; ++i) types->SetValue(i, cellTypeOf(given->GetValue(i), i, name));
    return types;
}

using Dims = std::array<std::int64_t, 3>;

std::string dimsText(const Dims& dims)
{
    return fmt::format("{} x {} x {}", dims[0], dims[1], dims[2]);
}

/// The dimensions for VTK. Throws InputError where they are negative or too large. `what` they count: points, samples.
std::array<int, 3> checkedDims(const Dims& dims, const char* what, const std::string& name)
{
    double all = 1;
    for (const std::int64_t count : dims) all *= double(count);
    for (const std::int64_t count : dims)
        if (count < 0 || count > std::numeric_limits<int>::max() || all > 1e15)
            throw InputError(name, fmt::format("{} {}", dimsText(dims), what), "how many there are in x, y and z");
    return {int(dims[0]), int(dims[1]), int(dims[2])};
}

std::array<int, 3> dimsOf(const Volume& volume, const std::string& name)
{
    const auto dims = checkedDims(volume.dims, "points", name);
    if (volume.types.count != 0 || volume.offsets.count != 0 || volume.connectivity.count != 0 ||
        volume.faces.count != 0 || volume.faceLocations.count != 0)
        throw InputError(name, "dims together with cells", "one or the other");
    return dims;
}

vtkSmartPointer<vtkDataSet> structuredGrid(const Volume& volume, const std::string& name)
{
    const auto dims = dimsOf(volume, name);
    const std::int64_t count = volume.dims[0] * volume.dims[1] * volume.dims[2];
    if (volume.points.count != count)
        throw InputError(name, fmt::format("{} points", volume.points.count),
                         fmt::format("{}, which are {}", count, dimsText(volume.dims)));
    auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
    grid->SetDimensions(dims.data());
    grid->SetPoints(wrappedPoints(volume.points, name + ": points"));
    return grid;
}

vtkSmartPointer<vtkDataSet> rectilinearGrid(const Volume& volume, const std::string& name)
{
    const auto dims = dimsOf(volume, name);
    if (volume.points.count != 0) throw InputError(name, "axes together with points", "one or the other");
    auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
    grid->SetDimensions(dims.data());
    vtkSmartPointer<vtkDataArray> axes[3];
    for (std::size_t c = 0; c < 3; ++c) {
        const std::string where = fmt::format("{}: coordinates along {}", name, "xyz"[c]);
        requireComponents(volume.axes[c], 1, where);
        if (volume.axes[c].count != volume.dims[c])
            throw InputError(where, fmt::format("{} values", volume.axes[c].count),
                             fmt::format("{}, for {} points", volume.dims[c], dimsText(volume.dims)));
        axes[c] = wrapped(volume.axes[c], where);
    }
    grid->SetXCoordinates(axes[0]);
    grid->SetYCoordinates(axes[1]);
    grid->SetZCoordinates(axes[2]);
    return grid;
}

vtkSmartPointer<vtkDataSet> unstructuredGrid(const Volume& volume, const std::string& name)
{
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetPoints(wrappedPoints(volume.points, name + ": points"));
    const auto cells = wrappedCells(volume.offsets, volume.connectivity, name, "cell");
    const vtkIdType count = cells->GetNumberOfCells();
    const auto types = typesOf(volume, count, name);
    vtkSmartPointer<vtkIdTypeArray> faces, locations;
    if (volume.faces.count != 0 || volume.faceLocations.count != 0) {
        requireComponents(volume.faces, 1, name + ": faces");
        requireOneEach(volume.faceLocations, count, name + ": faceLocations");
        faces = wrappedIndices(volume.faces, name + ": faces");
        locations = wrappedIndices(volume.faceLocations, name + ": faceLocations");
    }
    // Without these two, VTK would take the corners of polyhedra for their faces, and believe every number.
    grid->SetCells(types, cells, locations, faces);
    return grid;
}

}  // namespace

vtkSmartPointer<vtkImageData> imageFromMemory(const Grid& grid, const std::string& name)
{
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(checkedDims(grid.dims, "samples", name).data());
    image->SetOrigin(grid.origin.data());
    image->SetSpacing(grid.spacing.data());
    addArrays(*image, grid.pointArrays, true, name);
    addArrays(*image, grid.cellArrays, false, name);
    requireSoundData(*image, name);
    return image;
}

vtkSmartPointer<vtkDataSet> cellsFromMemory(const Volume& volume, const std::string& name)
{
    vtkSmartPointer<vtkDataSet> grid = volume.isRectilinear()  ? rectilinearGrid(volume, name)
                                       : volume.isStructured() ? structuredGrid(volume, name)
                                                               : unstructuredGrid(volume, name);
    addArrays(*grid, volume.pointArrays, true, name);
    addArrays(*grid, volume.cellArrays, false, name);
    makeCellsLinear(*grid, name);
    requireSoundData(*grid, name);
    return grid;
}

}  // namespace aeolic
