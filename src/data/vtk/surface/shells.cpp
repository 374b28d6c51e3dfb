#include "data/vtk/surface/shells.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "data/vtk/grid/cell_means.h"
#include "data/vtk/surface/outer_surface.h"

namespace aeolic {
namespace {

constexpr const char* kShell = "aeolic: shell";

/// The cells that fill space at those points that faces have.
class SolidsAtPoints {
public:
    SolidsAtPoints(vtkUnstructuredGrid& grid, const std::vector<vtkIdType>& faces) : grid_(grid)
    {
        std::vector<char> asked(std::size_t(grid.GetNumberOfPoints()), 0);
        vtkNew<vtkIdList> points;
        for (const vtkIdType face : faces) {
            grid.GetCellPoints(face, points);
            for (const vtkIdType point : *points.Get()) asked[std::size_t(point)] = 1;
        }
        for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell) {
            if (dimensionOfCells(grid.GetCellType(cell)) != 3) continue;
            grid.GetCellPoints(cell, points);
            for (const vtkIdType point : *points.Get())
                if (asked[std::size_t(point)]) cells_[point].push_back(cell);
        }
    }

    /// Whether one of them has all corners of the face.
    bool haveFace(vtkIdType face)
    {
        grid_.GetCellPoints(face, corners_);
        std::vector<vtkIdType> common;
        for (vtkIdType k = 0; k < corners_->GetNumberOfIds(); ++k) {
            const auto at = cells_.find(corners_->GetId(k));
            if (at == cells_.end()) return false;
            if (k == 0) {
                common = at->second;
                continue;
            }
            std::vector<vtkIdType> both;
            std::set_intersection(common.begin(), common.end(), at->second.begin(), at->second.end(),
                                  std::back_inserter(both));
            common.swap(both);
        }
        return !common.empty();
    }

private:
    vtkUnstructuredGrid& grid_;
    std::unordered_map<vtkIdType, std::vector<vtkIdType>> cells_;  // Ascending.
    vtkNew<vtkIdList> corners_;
};

/// Gives the polygons that are shells points of their own. Returns which points these are.
std::vector<char> splitShells(vtkPolyData& surface)
{
    auto* shells = vtkUnsignedCharArray::SafeDownCast(surface.GetCellData()->GetArray(kShell));
    std::vector<char> ofShell(std::size_t(surface.GetNumberOfPoints()), 0), ofOther = ofShell;
    vtkCellArray& polygons = *surface.GetPolys();
    const vtkIdType first = surface.GetNumberOfVerts() + surface.GetNumberOfLines();
    vtkNew<vtkIdList> corners;
    for (vtkIdType i = 0; i < polygons.GetNumberOfCells(); ++i) {
        polygons.GetCellAtId(i, corners);
        for (const vtkIdType point : *corners.Get())
            (shells->GetValue(first + i) ? ofShell : ofOther)[std::size_t(point)] = 1;
    }
    std::vector<vtkIdType> copies(ofShell.size(), -1);
    vtkPointData& values = *surface.GetPointData();
    values.CopyAllOn();
    for (std::size_t point = 0; point < copies.size(); ++point) {
        if (!ofShell[point] || !ofOther[point]) continue;
        double p[3];
        surface.GetPoint(vtkIdType(point), p);
        copies[point] = surface.GetPoints()->InsertNextPoint(p);
        for (int k = 0; k < values.GetNumberOfArrays(); ++k)
            if (vtkDataArray* array = values.GetArray(k)) array->InsertNextTuple(vtkIdType(point), array);
        ofShell[point] = 0;
        ofShell.push_back(1);
    }
    vtkNew<vtkCellArray> split;
    for (vtkIdType i = 0; i < polygons.GetNumberOfCells(); ++i) {
        polygons.GetCellAtId(i, corners);
        if (shells->GetValue(first + i))
            for (vtkIdType& point : *corners.Get())
                if (copies[std::size_t(point)] >= 0) point = copies[std::size_t(point)];
        split->InsertNextCell(corners);
    }
    surface.SetPolys(split);
    return ofShell;
}

}  // namespace

std::vector<char> shellCells(vtkDataSet& data)
{
    auto* grid = vtkUnstructuredGrid::SafeDownCast(&data);
    if (!grid || dimensionOfCells(data) < 3) return {};
    std::vector<vtkIdType> faces;
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
        if (dimensionOfCells(grid->GetCellType(cell)) == 2) faces.push_back(cell);
    if (faces.empty()) return {};
    SolidsAtPoints solids(*grid, faces);
    std::vector<char> shells(std::size_t(grid->GetNumberOfCells()), 0);
    bool any = false;
    for (const vtkIdType face : faces)
        if (!solids.haveFace(face)) {
            shells[std::size_t(face)] = 1;
            any = true;
        }
    if (!any) shells.clear();
    return shells;
}

vtkSmartPointer<vtkPolyData> boundaryWithShells(vtkDataSet& data, const std::vector<char>& shells,
                                                const std::string& where)
{
    const auto marked = vtkSmartPointer<vtkDataSet>::Take(data.NewInstance());
    marked->ShallowCopy(&data);
    vtkNew<vtkUnsignedCharArray> marks;
    marks->SetName(kShell);
    marks->SetNumberOfValues(vtkIdType(shells.size()));
    std::copy(shells.begin(), shells.end(), marks->GetPointer(0));
    marked->GetCellData()->AddArray(marks);
    auto surface = outerSurface(*marked, where);
    const std::vector<char> own = splitShells(*surface);
    surface->GetCellData()->RemoveArray(kShell);
    for (int k = 0; k < surface->GetPointData()->GetNumberOfArrays(); ++k) {
        auto* array = vtkFloatArray::SafeDownCast(surface->GetPointData()->GetArray(k));
        for (std::size_t point = 0; array && point < own.size(); ++point)
            if (!own[point])
                for (int c = 0; c < array->GetNumberOfComponents(); ++c)
                    array->SetTypedComponent(vtkIdType(point), c, std::numeric_limits<float>::quiet_NaN());
    }
    return surface;
}

}  // namespace aeolic
