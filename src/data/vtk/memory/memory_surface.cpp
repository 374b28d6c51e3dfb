#include "data/vtk/memory/memory_surface.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include "aeolic/error.h"
#include "data/vtk/checks/cell_checks.h"
#include "data/vtk/joined_arrays.h"
#include "data/vtk/memory/memory_arrays.h"
#include "data/vtk/surface/polydata_mesh.h"

namespace aeolic {
namespace {

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

}  // namespace

LoadedSurface surfaceFromMemory(const Surface& surface, const std::string& name, const SurfaceArrays& wanted)
{
    if (surface.triangles.count != 0 && (surface.offsets.count != 0 || surface.connectivity.count != 0))
        throw InputError(name, "triangles and polygons", "one or the other");
    vtkNew<vtkPolyData> given;
    given->SetPoints(wrappedPoints(surface.points, name + ": points"));
    given->SetPolys(surface.triangles.count != 0
                        ? trianglesOf(surface, name)
                        : wrappedCells(surface.offsets, surface.connectivity, name, "polygon"));
    addArrays(*given, surface.pointArrays, true, name);
    addArrays(*given, surface.cellArrays, false, name);
    requireSoundData(*given, name);

    const std::vector<ArrayInfo> there = withJoined(arraysOf(*given));
    std::vector<ArrayInfo> written, kept;
    if (wanted.wantVectors) written.push_back(chooseVectors(there, wanted.vectors, name));
    const auto scalar = wanted.colorBy.empty() ? std::nullopt : findScalar(there, wanted.colorBy, name);
    if (scalar) written.push_back(scalar->array);
    makeVectors(*given, written, wanted.wantVectors ? &written.front() : nullptr, name);
    for (const ArrayInfo& array : there)
        if (isMaskName(array.name) || array.activeNormals || array.name == "Normals") kept.push_back(array);
    kept.insert(kept.end(), written.begin(), written.end());
    takeCopies(*given, written, false);

    vtkNew<vtkPolyData> polyData;  // Arrays that nobody wants would be copied with the polygons that are cut up.
    polyData->CopyStructure(given);
    for (const ArrayInfo& array : kept) {
        vtkDataSetAttributes* all = attributesOf(*polyData, array.onPoints);
        all->AddArray(findArray(*given, array.name, array.onPoints));
        if (array.activeNormals) all->SetActiveNormals(array.name.c_str());
    }
    SurfaceArrays chosen = wanted;
    if (wanted.wantVectors) {  // A name alone may be that of two arrays.
        chosen.vectors.clear();
        attributesOf(*polyData, written.front().onPoints)->SetActiveVectors(written.front().name.c_str());
    }
    LoadedSurface loaded = meshFromPolyData(*polyData, name, chosen);
    loaded.arrays = listArrays(there);
    loaded.offered = offeredArrays(there);
    if (scalar) tellColors(*scalar, loaded);  // An empty piece says so, too.
    if (wanted.wantVectors) loaded.vectorsName = written.front().name;
    return loaded;
}

}  // namespace aeolic
