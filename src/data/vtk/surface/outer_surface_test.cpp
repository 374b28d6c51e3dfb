#include "data/vtk/surface/outer_surface.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <random>

#include "data/vtk/surface/outer_faces.h"

namespace aeolic {
namespace {

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// Points at their numbers' places, with values, and no cells.
Grid gridOfPoints(vtkIdType count, int type = VTK_FLOAT)
{
    auto grid = Grid::New();
    vtkNew<vtkPoints> points;
    points->SetDataType(type);
    vtkNew<vtkFloatArray> values;
    values->SetName("U");
    values->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < count; ++i) {
        const double x = double(i % 7) / 3, y = double(i / 7 % 5) / 7, z = double(i / 35) / 11;
        points->InsertNextPoint(x, y, z);
        values->InsertNextTuple3(x + 1, y * z, double(i));
    }
    grid->SetPoints(points);
    grid->GetPointData()->AddArray(values);
    return grid;
}

void add(vtkUnstructuredGrid& grid, int type, const std::vector<vtkIdType>& corners)
{
    grid.InsertNextCell(type, vtkIdType(corners.size()), corners.data());
}

/// A value in each cell, and a mark in some.
void finish(vtkUnstructuredGrid& grid, unsigned char ghost = 0)
{
    vtkNew<vtkDoubleArray> values;
    values->SetName("p");
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType i = 0; i < grid.GetNumberOfCells(); ++i) {
        values->InsertNextValue(double(i) / 3);
        ghosts->InsertNextValue(i % 3 == 1 ? ghost : 0);
    }
    grid.GetCellData()->AddArray(values);
    if (ghost) grid.GetCellData()->AddArray(ghosts);
}

/// Boxes of cells; `type` is a hexahedron or a voxel.
Grid block(int nx, int ny, int nz, int type = VTK_HEXAHEDRON)
{
    Grid grid = gridOfPoints(vtkIdType(nx + 1) * (ny + 1) * (nz + 1));
    const auto id = [&](int i, int j, int k) { return vtkIdType((k * (ny + 1) + j) * (nx + 1) + i); };
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) {
                std::vector<vtkIdType> corners{
                    id(i, j, k),     id(i + 1, j, k),     id(i + 1, j + 1, k),     id(i, j + 1, k),
                    id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1)};
                if (type == VTK_VOXEL) {
                    std::swap(corners[2], corners[3]);
                    std::swap(corners[6], corners[7]);
                }
                add(*grid, type, corners);
            }
    return grid;
}

void expectSame(vtkDataArray* mine, vtkDataArray* theirs, const char* what)
{
    ASSERT_EQ(mine == nullptr, theirs == nullptr) << what;
    if (!mine) return;
    ASSERT_EQ(mine->GetDataType(), theirs->GetDataType()) << what;
    ASSERT_EQ(mine->GetNumberOfComponents(), theirs->GetNumberOfComponents()) << what;
    ASSERT_EQ(mine->GetNumberOfTuples(), theirs->GetNumberOfTuples()) << what;
    for (vtkIdType i = 0; i < mine->GetNumberOfTuples(); ++i)
        for (int k = 0; k < mine->GetNumberOfComponents(); ++k)
            ASSERT_EQ(mine->GetComponent(i, k), theirs->GetComponent(i, k)) << what << " " << i;
}

/// Whether the surface is VTK's in every corner, point and value. Returns how many polygons it has.
vtkIdType expectSameAsVtk(vtkUnstructuredGrid& grid)
{
    vtkNew<vtkDataSetSurfaceFilter> filter;
    filter->SetInputData(&grid);
    filter->PassThroughPointIdsOn();
    filter->Update();
    vtkPolyData& theirs = *filter->GetOutput();
    const auto mine = outerSurface(grid, "grid");
    EXPECT_EQ(mine->GetNumberOfPoints(), theirs.GetNumberOfPoints());
    EXPECT_EQ(mine->GetNumberOfCells(), theirs.GetNumberOfCells());
    if (testing::Test::HasFailure() || theirs.GetNumberOfPoints() == 0) return mine->GetNumberOfPolys();
    expectSame(mine->GetPoints()->GetData(), theirs.GetPoints()->GetData(), "points");
    for (vtkIdType i = 0; i < theirs.GetNumberOfPolys(); ++i) {
        vtkIdType mySize = 0, theirSize = 0;
        const vtkIdType *my = nullptr, *their = nullptr;
        mine->GetPolys()->GetCellAtId(i, mySize, my);
        const std::vector<vtkIdType> own(my, my + mySize);
        theirs.GetPolys()->GetCellAtId(i, theirSize, their);
        EXPECT_EQ(own, std::vector<vtkIdType>(their, their + theirSize)) << "polygon " << i;
    }
    expectSame(mine->GetPointData()->GetArray("U"), theirs.GetPointData()->GetArray("U"), "U");
    for (const char* name : {"p", "vtkGhostType"})
        expectSame(mine->GetCellData()->GetArray(name), theirs.GetCellData()->GetArray(name), name);
    vtkNew<vtkIdTypeArray> ids;
    for (const vtkIdType id : outerPoints(grid, "grid")) ids->InsertNextValue(id);
    expectSame(ids, theirs.GetPointData()->GetArray("vtkOriginalPointIds"), "ids");
    return mine->GetNumberOfPolys();
}

TEST(OuterSurface, OfBlocksIsVtks)
{
    for (const int type : {VTK_HEXAHEDRON, VTK_VOXEL}) {
        const Grid grid = block(23, 19, 17, type);  // More cells than a thread takes at once.
        finish(*grid);
        ASSERT_TRUE(outerFacesOf(*grid));
        EXPECT_EQ(expectSameAsVtk(*grid), 2 * (23 * 19 + 19 * 17 + 17 * 23));
        grid->GetCells()->ConvertTo32BitStorage();
        ASSERT_TRUE(outerFacesOf(*grid));
        EXPECT_EQ(expectSameAsVtk(*grid), 2 * (23 * 19 + 19 * 17 + 17 * 23)) << "32 bits";
    }
}

TEST(OuterSurface, OfOneCellOfEachKind)
{
    const std::vector<std::pair<int, int>> kinds{
        {VTK_TETRA, 4}, {VTK_PYRAMID, 5}, {VTK_WEDGE, 6}, {VTK_HEXAHEDRON, 8}, {VTK_VOXEL, 8}};
    for (const auto& [type, count] : kinds)
        for (const int points : {VTK_FLOAT, VTK_DOUBLE}) {
            const Grid grid = gridOfPoints(12, points);
            std::vector<vtkIdType> corners;
            for (int k = 0; k < count; ++k) corners.push_back((5 * k + 3) % 12);
            add(*grid, type, corners);
            finish(*grid);
            ASSERT_TRUE(outerFacesOf(*grid));
            EXPECT_EQ(expectSameAsVtk(*grid), count == 4 ? 4 : count == 8 ? 6 : 5) << type;
        }
}

TEST(OuterSurface, FacesOfThreeCellsAreNone)
{
    const Grid grid = gridOfPoints(6);
    for (const vtkIdType top : {3, 4, 5}) add(*grid, VTK_TETRA, {0, 1, 2, top});
    finish(*grid);
    EXPECT_EQ(expectSameAsVtk(*grid), 9);
    add(*grid, VTK_TETRA, {0, 1, 2, 3});
    const Grid four = Grid::New();
    four->DeepCopy(grid);
    four->GetCellData()->Initialize();
    finish(*four);
    EXPECT_EQ(expectSameAsVtk(*four), 6) << "a cell that is there twice has no side of its own";
}

/// What coordinates say makes no difference: cells without a volume, points at the same place.
TEST(OuterSurface, PlacesAreNotLookedAt)
{
    const Grid grid = block(3, 3, 3);
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i) grid->GetPoints()->SetPoint(i, 1, 2, double(i % 2));
    finish(*grid);
    EXPECT_EQ(expectSameAsVtk(*grid), 54);
}

/// Hexahedra with corners that are the same point: wedges, pyramids, tetrahedra, lines and points.
TEST(OuterSurface, OfCollapsedHexahedra)
{
    const Grid grid = gridOfPoints(40);
    add(*grid, VTK_HEXAHEDRON, {1, 2, 3, 3, 5, 6, 7, 7});
    add(*grid, VTK_HEXAHEDRON, {7, 7, 6, 5, 11, 11, 10, 9});
    add(*grid, VTK_HEXAHEDRON, {12, 13, 14, 15, 16, 16, 16, 16});
    add(*grid, VTK_HEXAHEDRON, {12, 13, 14, 15, 11, 11, 11, 11});
    add(*grid, VTK_HEXAHEDRON, {20, 21, 22, 22, 19, 19, 19, 19});
    add(*grid, VTK_HEXAHEDRON, {20, 20, 20, 20, 25, 25, 25, 25});
    add(*grid, VTK_HEXAHEDRON, {30, 30, 30, 30, 30, 30, 30, 30});
    add(*grid, VTK_TETRA, {20, 21, 22, 22});
    add(*grid, VTK_WEDGE, {1, 2, 3, 5, 6, 7});
    finish(*grid);
    ASSERT_TRUE(outerFacesOf(*grid));
    EXPECT_GT(expectSameAsVtk(*grid), 0);
}

/// A cone of many cells around one point, which has the smallest number.
TEST(OuterSurface, OfManyCellsAtOnePoint)
{
    const Grid grid = gridOfPoints(3002);
    for (vtkIdType i = 1; i < 3000; ++i) add(*grid, VTK_TETRA, {0, i, i + 1, 3001});
    finish(*grid);
    EXPECT_EQ(expectSameAsVtk(*grid), 2 * 2999 + 2);
}

/// Cells of all kinds over few points, in every order: faces of many cells, turned and mirrored, and repeated corners.
TEST(OuterSurface, OfCellsAtRandomIsVtks)
{
    std::mt19937 random(3);
    const std::pair<int, int> kinds[] = {
        {VTK_TETRA, 4}, {VTK_PYRAMID, 5}, {VTK_WEDGE, 6}, {VTK_HEXAHEDRON, 8}, {VTK_VOXEL, 8}};
    for (int round = 0; round < 300 && !HasFailure(); ++round) {
        const int points = 4 + round % 9;
        const Grid grid = gridOfPoints(points + 2);
        const int cells = 1 + round % 40;
        for (int i = 0; i < cells; ++i) {
            const auto [type, count] = kinds[random() % 5];
            std::vector<vtkIdType> corners;
            for (int k = 0; k < count; ++k) corners.push_back(vtkIdType(random() % unsigned(points)));
            add(*grid, type, corners);
        }
        constexpr unsigned char marks[] = {0, vtkDataSetAttributes::DUPLICATECELL, vtkDataSetAttributes::HIDDENCELL,
                                           vtkDataSetAttributes::REFINEDCELL};
        finish(*grid, marks[round % 4]);
        ASSERT_TRUE(outerFacesOf(*grid));
        expectSameAsVtk(*grid);
    }
}

TEST(OuterSurface, OtherCellsAreVtks)
{
    Grid grid = block(2, 2, 2);
    add(*grid, VTK_QUAD, {0, 1, 4, 3});
    finish(*grid);
    EXPECT_FALSE(outerFacesOf(*grid));
    EXPECT_EQ(expectSameAsVtk(*grid), 25);
    grid = block(2, 2, 2);
    const vtkIdType faces[] = {3, 0, 1, 9, 3, 1, 3, 9, 3, 3, 0, 9, 3, 0, 3, 1}, corners[] = {0, 1, 3, 9};
    grid->InsertNextCell(VTK_POLYHEDRON, 4, corners, 4, faces);
    finish(*grid);
    EXPECT_FALSE(outerFacesOf(*grid));
    expectSameAsVtk(*grid);
    grid = gridOfPoints(10);
    add(*grid, VTK_QUADRATIC_TETRA, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
    finish(*grid);
    EXPECT_FALSE(outerFacesOf(*grid));
    EXPECT_GT(expectSameAsVtk(*grid), 0);
}

TEST(OuterSurface, OfNothing)
{
    const Grid points = gridOfPoints(5), empty = Grid::New();
    EXPECT_EQ(outerSurface(*points, "grid")->GetNumberOfCells(), 0);
    EXPECT_EQ(outerSurface(*empty, "grid")->GetNumberOfCells(), 0);
    EXPECT_TRUE(outerPoints(*points, "grid").empty());
    const Grid left = gridOfPoints(8);
    add(*left, VTK_EMPTY_CELL, {0, 1, 2});
    finish(*left);
    EXPECT_EQ(expectSameAsVtk(*left), 0) << "cells of no kind";
}

}  // namespace
}  // namespace aeolic
