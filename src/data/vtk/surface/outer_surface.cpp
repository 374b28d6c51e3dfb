#include "data/vtk/surface/outer_surface.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <optional>

#include "aeolic/error.h"
#include "base/large_memory.h"
#include "data/vtk/arrays.h"
#include "data/vtk/messages.h"
#include "data/vtk/surface/outer_faces.h"

namespace aeolic {
namespace {

vtkSmartPointer<vtkPolyData> surfaceByVtk(vtkDataSet& data, bool withPointIds, const std::string& where)
{
    const VtkMessages messages;
    vtkNew<vtkDataSetSurfaceFilter> filter;
    filter->SetInputData(&data);
    filter->SetPassThroughPointIds(withPointIds);
    filter->Update();
    if (messages.failed()) throw InputError(where, "cutting failed (" + messages.firstError() + ")", "sound cells");
    return filter->GetOutput();
}

std::optional<OuterFaces> ownFaces(vtkDataSet& data)
{
    auto* grid = vtkUnstructuredGrid::SafeDownCast(&data);
    return grid ? outerFacesOf(*grid) : std::nullopt;
}

/// Numbers the faces' points in the order in which they come first. `faces` get these numbers.
std::vector<vtkIdType> numberPoints(OuterFaces& faces, vtkIdType ofGrid)
{
    LargeVector<std::uint32_t> numbers(std::size_t(ofGrid), OuterFaces::kNone);
    std::vector<vtkIdType> points;
    for (auto& face : faces.corners)
        for (std::uint32_t& corner : face) {
            if (corner == OuterFaces::kNone) continue;
            std::uint32_t& number = numbers[corner];
            if (number == OuterFaces::kNone) {
                number = std::uint32_t(points.size());
                points.push_back(vtkIdType(corner));
            }
            corner = number;
        }
    return points;
}

template <class Ids>
vtkSmartPointer<vtkIdList> listOf(const Ids& ids)
{
    auto list = vtkSmartPointer<vtkIdList>::New();
    list->SetNumberOfIds(vtkIdType(ids.size()));
    std::copy(ids.begin(), ids.end(), list->begin());
    return list;
}

vtkSmartPointer<vtkPolyData> surfaceOf(OuterFaces faces, vtkUnstructuredGrid& grid)
{
    const auto ids = listOf(numberPoints(faces, grid.GetNumberOfPoints()));
    vtkNew<vtkPoints> points;
    points->SetDataType(grid.GetPoints()->GetDataType());
    points->GetData()->SetNumberOfTuples(ids->GetNumberOfIds());
    grid.GetPoints()->GetData()->GetTuples(ids, points->GetData());
    vtkNew<vtkCellArray> polygons;
    polygons->AllocateExact(vtkIdType(faces.corners.size()), 4 * vtkIdType(faces.corners.size()));
    for (const auto& face : faces.corners) {
        const std::array<vtkIdType, 4> corners{face[0], face[1], face[2], face[3]};
        polygons->InsertNextCell(face[3] == OuterFaces::kNone ? 3 : 4, corners.data());
    }
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    surface->SetPoints(points);
    surface->SetPolys(polygons);
    surface->GetFieldData()->ShallowCopy(grid.GetFieldData());
    takeTuples(*grid.GetPointData(), *ids, *surface->GetPointData());
    takeTuples(*grid.GetCellData(), *listOf(faces.cells), *surface->GetCellData());
    return surface;
}

}  // namespace

vtkSmartPointer<vtkPolyData> outerSurface(vtkDataSet& data, const std::string& where)
{
    auto faces = ownFaces(data);
    return faces ? surfaceOf(std::move(*faces), *vtkUnstructuredGrid::SafeDownCast(&data))
                 : surfaceByVtk(data, false, where);
}

std::vector<vtkIdType> outerPoints(vtkDataSet& data, const std::string& where)
{
    if (auto faces = ownFaces(data)) return numberPoints(*faces, data.GetNumberOfPoints());
    const auto surface = surfaceByVtk(data, true, where);
    auto* ids = vtkIdTypeArray::SafeDownCast(surface->GetPointData()->GetArray("vtkOriginalPointIds"));
    if (!ids) return {};
    return {ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues()};
}

}  // namespace aeolic
