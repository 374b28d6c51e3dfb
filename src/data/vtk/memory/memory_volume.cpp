#include "data/vtk/memory/memory_volume.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkUnsignedCharArray.h>

#include "aeolic/error.h"
#include "data/vtk/checks/cell_checks.h"
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

}  // namespace

vtkSmartPointer<vtkUnstructuredGrid> cellsFromMemory(const Volume& volume, const std::string& name)
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
    addArrays(*grid, volume.pointArrays, true, name);
    addArrays(*grid, volume.cellArrays, false, name);
    requireSoundData(*grid, name);
    return grid;
}

}  // namespace aeolic
