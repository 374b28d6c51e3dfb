#include "odd_data.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "data/vtk/testing/sample_writers.h"

namespace aeolic::test {
namespace {

/// Arrays of several kinds on the cells; some cells are hidden, some are another rank's.
void addCellArrays(vtkDataSet& data)
{
    const vtkIdType cells = data.GetNumberOfCells();
    auto vectors = newArray(true, "cellTau", 3, cells), numbers = newArray(false, "cellQ", 1, cells);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    vtkNew<vtkStringArray> names;
    names->SetName("names");
    for (vtkIdType cell = 0; cell < cells; ++cell) {
        vectors->SetTuple3(cell, 1, double(cell), 0);
        numbers->SetTuple1(cell, double(cell));
        ghosts->InsertNextValue(cell % 5 == 4   ? vtkDataSetAttributes::HIDDENCELL
                                : cell % 7 == 6 ? vtkDataSetAttributes::DUPLICATECELL
                                                : 0);
        names->InsertNextValue("cell");
    }
    if (data.IsA("vtkPolyData"))
        data.GetCellData()->AddArray(vectors);  // A field with several would have to be chosen from.
    data.GetCellData()->AddArray(numbers);
    data.GetCellData()->AddArray(ghosts);
    data.GetCellData()->AddArray(names);
    vtkNew<vtkStringArray> title;
    title->SetName("title");
    title->InsertNextValue("odd");
    data.GetFieldData()->AddArray(title);
}

/// Points in a wave, one of them not finite, and vectors on them, one of them zero.
void addWave(vtkPointSet& data, int count)
{
    vtkNew<vtkPoints> points;
    auto vectors = newArray(false, "tau", 3, count);
    for (int i = 0; i < count; ++i) {
        const double x = i % 5, y = i / 5;
        points->InsertNextPoint(i == count - 1 ? std::numeric_limits<double>::quiet_NaN() : x, y, 0.1 * x * y);
        vectors->SetTuple3(i, i == 3 ? 0 : 1, i == 3 ? 0 : 0.1 * i, 0);
    }
    data.SetPoints(points);
    data.GetPointData()->AddArray(vectors);
}

}  // namespace

vtkSmartPointer<vtkPolyData> oddPolygons(bool tooShort)
{
    using Cells = std::vector<std::vector<vtkIdType>>;
    auto data = vtkSmartPointer<vtkPolyData>::New();
    addWave(*data, 20);
    const auto add = [&](const Cells& cells, const Cells& shorter) {
        auto array = vtkSmartPointer<vtkCellArray>::New();
        const auto insert = [&](const std::vector<vtkIdType>& c) {
            array->InsertNextCell(vtkIdType(c.size()), c.data());
        };
        if (tooShort) std::for_each(shorter.begin(), shorter.end(), insert);
        std::for_each(cells.begin(), cells.end(), insert);
        return array;
    };
    data->SetVerts(add({{0}, {1, 2}}, {{}}));
    data->SetLines(add({{0, 1, 2}, {19, 3}}, {{}, {4}}));
    data->SetPolys(add({{0, 1, 6},
                        {0, 1, 6},
                        {6, 1, 0},
                        {1, 2, 2},
                        {2, 7, 12, 8, 3},
                        {5, 6, 11, 10},
                        {13, 14, 19},
                        {7, 7, 7},
                        {8, 9, 13, 12, 8}},
                       {{}, {1}, {1, 2}}));
    data->SetStrips(add({{10, 15, 11, 16, 12}, {14, 19, 13}}, {{}, {11, 12}}));
    addCellArrays(*data);
    return data;
}

vtkSmartPointer<vtkUnstructuredGrid> oddCells()
{
    auto data = vtkSmartPointer<vtkUnstructuredGrid>::New();
    addWave(*data, 40);
    const auto add = [&](int type, std::vector<vtkIdType> corners) {
        data->InsertNextCell(type, vtkIdType(corners.size()), corners.data());
    };
    const std::vector<vtkIdType> box{0, 1, 6, 5, 20, 21, 26, 25};
    add(VTK_HEXAHEDRON, box);
    add(VTK_VOXEL, {1, 2, 6, 7, 21, 22, 26, 27});
    add(VTK_EMPTY_CELL, {});
    add(VTK_VERTEX, {0});
    add(VTK_POLY_VERTEX, {0, 1, 2});
    add(VTK_LINE, {0, 1});
    add(VTK_POLY_LINE, {0, 1, 2});
    add(VTK_TRIANGLE, {2, 3, 8});
    add(VTK_TRIANGLE_STRIP, {2, 3, 7, 8});
    add(VTK_POLYGON, {2, 3, 8, 12, 7});
    add(VTK_PIXEL, {2, 3, 7, 8});
    add(VTK_QUAD, {2, 3, 8, 7});
    add(VTK_TETRA, {2, 3, 7, 22});
    add(VTK_TETRA, {3, 3, 3, 3});
    add(VTK_WEDGE, {3, 8, 7, 23, 28, 27});
    add(VTK_PYRAMID, {8, 9, 14, 13, 33});
    add(VTK_QUADRATIC_TETRA, {10, 11, 15, 30, 12, 13, 16, 31, 32, 35});
    add(VTK_PENTAGONAL_PRISM, {10, 11, 12, 16, 15, 30, 31, 32, 36, 35});
    add(VTK_HEXAHEDRON, {13, 14, 19, 18, 33, 34, 39, 38});
    addCellArrays(*data);
    return data;
}

}  // namespace aeolic::test
