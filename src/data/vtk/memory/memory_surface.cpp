#include "data/vtk/memory/memory_surface.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>

#include "aeolic/error.h"
#include "data/vtk/checks/cell_checks.h"
#include "data/vtk/memory/memory_arrays.h"
#include "data/vtk/surface/polydata_mesh.h"

namespace aeolic {
namespace {

void requireComponents(const ArrayView& view, int expected, const std::string& where)
{
    if (view.components != expected)
        throw InputError(where, fmt::format("{} components", view.components), fmt::format("{}", expected));
}

vtkSmartPointer<vtkPoints> pointsOf(const Surface& surface, const std::string& name)
{
    const std::string where = name + ": points";
    const bool floating = surface.points.type == ValueType::float32 || surface.points.type == ValueType::float64;
    if (!floating) throw InputError(where, "whole numbers", "float or double");
    auto points = vtkSmartPointer<vtkPoints>::New();
    if (surface.points.count == 0) return points;
    requireComponents(surface.points, 3, where);
    points->SetData(wrapped(surface.points, where));
    return points;
}

vtkSmartPointer<vtkCellArray> trianglesOf(const Surface& surface, const std::string& name)
{
    requireComponents(surface.triangles, 3, name + ": triangles");
    const auto corners = wrappedIndices(surface.triangles, name + ": triangles");
    vtkNew<vtkIdTypeArray> offsets;
    offsets->SetNumberOfValues(surface.triangles.count + 1);
    for (vtkIdType i = 0; i <= surface.triangles.count; ++i) offsets->SetValue(i, 3 * i);
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(offsets, corners);
    return cells;
}

vtkSmartPointer<vtkCellArray> polygonsOf(const Surface& surface, const std::string& name)
{
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    if (surface.offsets.count == 0 && surface.connectivity.count == 0) return cells;
    const std::string where = name + ": offsets";
    requireComponents(surface.offsets, 1, where);
    requireComponents(surface.connectivity, 1, name + ": connectivity");
    const auto offsets = wrappedIndices(surface.offsets, where);
    const auto corners = wrappedIndices(surface.connectivity, name + ": connectivity");
    const vtkIdType *begin = offsets->GetPointer(0), *end = begin + offsets->GetNumberOfValues();
    if (begin == end || *begin != 0 || *(end - 1) != corners->GetNumberOfValues() || !std::is_sorted(begin, end))
        throw InputError(where, "they do not rise from 0 to the number of indices",
                         fmt::format("where each polygon begins, and {} at the end", corners->GetNumberOfValues()));
    cells->SetData(offsets, corners);
    return cells;
}

}  // namespace

LoadedSurface surfaceFromMemory(const Surface& surface, const std::string& name, const SurfaceArrays& wanted)
{
    if (surface.triangles.count != 0 && (surface.offsets.count != 0 || surface.connectivity.count != 0))
        throw InputError(name, "triangles and polygons", "one or the other");
    vtkNew<vtkPolyData> given;
    given->SetPoints(pointsOf(surface, name));
    given->SetPolys(surface.triangles.count != 0 ? trianglesOf(surface, name) : polygonsOf(surface, name));
    addArrays(*given, surface.pointArrays, true, name);
    addArrays(*given, surface.cellArrays, false, name);
    requireSoundData(*given, name);

    const std::vector<ArrayInfo> there = arraysOf(*given);
    std::vector<ArrayInfo> written, kept;
    if (wanted.wantVectors) written.push_back(chooseVectors(there, wanted.vectors, name));
    const auto scalar = wanted.colorBy.empty() ? std::nullopt : findScalar(there, wanted.colorBy, name);
    if (scalar) written.push_back(scalar->array);
    for (const ArrayInfo& array : there)
        if (isMaskName(array.name) || array.name == "Normals") kept.push_back(array);
    kept.insert(kept.end(), written.begin(), written.end());
    takeCopies(*given, written, false);

    vtkNew<vtkPolyData> polyData;  // Arrays that nobody wants would be copied with the polygons that are cut up.
    polyData->CopyStructure(given);
    for (const ArrayInfo& array : kept)
        (array.onPoints ? static_cast<vtkFieldData*>(polyData->GetPointData()) : polyData->GetCellData())
            ->AddArray(findArray(*given, array.name, array.onPoints));
    SurfaceArrays chosen = wanted;
    if (wanted.wantVectors) chosen.vectors = written.front().name;
    LoadedSurface loaded = meshFromPolyData(*polyData, name, chosen);
    loaded.arrays = listArrays(there);
    loaded.offered = offeredArrays(there);
    if (scalar) loaded.scalarLabel = scalar->label();  // An empty piece says so, too.
    return loaded;
}

}  // namespace aeolic
