#include "data/vtk/surface/near_origin.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkPointSet.h>
#include <vtkRectilinearGrid.h>

namespace aeolic {
namespace {

vtkSmartPointer<vtkDataArray> lessBy(vtkDataArray& axis, double by)
{
    auto less = vtkSmartPointer<vtkDoubleArray>::New();
    less->SetNumberOfValues(axis.GetNumberOfTuples());
    for (vtkIdType i = 0; i < axis.GetNumberOfTuples(); ++i) less->SetValue(i, axis.GetComponent(i, 0) - by);
    return less;
}

}  // namespace

vtkSmartPointer<vtkPoints> pointsLess(vtkDataSet& data, const glm::dvec3& by)
{
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(data.GetNumberOfPoints());
    double p[3];
    for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
        data.GetPoint(i, p);
        points->SetPoint(i, p[0] - by.x, p[1] - by.y, p[2] - by.z);
    }
    return points;
}

NearOrigin nearOrigin(vtkDataSet& data, const Bounds& boundsWorld)
{
    NearOrigin near{&data};
    const glm::dvec3 cornerWorld = boundsWorld.lo;
    if (boundsWorld.empty() || !(glm::length(cornerWorld) > boundsWorld.diagonal())) return near;
    if (auto* image = vtkImageData::SafeDownCast(&data)) {
        auto copy = vtkSmartPointer<vtkImageData>::New();
        copy->ShallowCopy(image);
        const double* origin = image->GetOrigin();
        copy->SetOrigin(origin[0] - cornerWorld.x, origin[1] - cornerWorld.y, origin[2] - cornerWorld.z);
        near = {copy, cornerWorld};
    } else if (auto* grid = vtkRectilinearGrid::SafeDownCast(&data)) {
        auto copy = vtkSmartPointer<vtkRectilinearGrid>::New();
        copy->ShallowCopy(grid);
        copy->SetXCoordinates(lessBy(*grid->GetXCoordinates(), cornerWorld.x));
        copy->SetYCoordinates(lessBy(*grid->GetYCoordinates(), cornerWorld.y));
        copy->SetZCoordinates(lessBy(*grid->GetZCoordinates(), cornerWorld.z));
        near = {copy, cornerWorld};
    } else if (auto* set = vtkPointSet::SafeDownCast(&data)) {
        const auto copy = vtkSmartPointer<vtkPointSet>::Take(set->NewInstance());
        copy->ShallowCopy(set);
        copy->SetPoints(pointsLess(data, cornerWorld));
        near = {copy, cornerWorld};
    }
    return near;
}

void moveBack(vtkPolyData& surface, const NearOrigin& from)
{
    if (from.movedBy == glm::dvec3(0) || !surface.GetPoints()) return;
    surface.SetPoints(pointsLess(surface, -from.movedBy));
}

}  // namespace aeolic
