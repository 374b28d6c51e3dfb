#include "data/vtk/grid/grid_volume.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkCellTypes.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "aeolic/error.h"
#include "data/cells/cell_sampler.h"
#include "data/vtk/grid/near_cells.h"

namespace aeolic {
namespace {

glm::dvec3 flowAt(const glm::dvec3& p)
{
    return {1 + p.x - 2 * p.y, 3 * p.z - p.x, 0.5 + p.y + p.z};
}

/// Cells of VTK's kinds, each in its own place.
class Cells {
public:
    Cells() { grid_->SetPoints(points_); }

    /// The cell as it is in its own coordinates, skewed and moved; `mirrored`: inside out. Returns its middle.
    glm::dvec3 add(int type, bool mirrored = false)
    {
        vtkNew<vtkGenericCell> cell;
        cell->SetCellType(type);
        const double* own = cell->GetParametricCoords();
        const glm::dvec3 shift(3.0 * double(grid_->GetNumberOfCells()), 0, 0);
        std::vector<vtkIdType> ids;
        glm::dvec3 middle(0);
        for (int k = 0; k < cell->GetNumberOfPoints(); ++k) {
            const glm::dvec3 c(own[3 * k], own[3 * k + 1], mirrored ? -own[3 * k + 2] : own[3 * k + 2]);
            const glm::dvec3 p = shift + glm::dvec3(c.x + 0.2 * c.y, c.y - 0.1 * c.z, c.z + 0.3 * c.x);
            ids.push_back(points_->InsertNextPoint(p.x, p.y, p.z));
            middle += p / double(cell->GetNumberOfPoints());
        }
        grid_->InsertNextCell(type, vtkIdType(ids.size()), ids.data());
        return middle;
    }

    /// All of them.
    std::shared_ptr<VolumeCells> take()
    {
        const auto vectors = vtkSmartPointer<vtkFloatArray>::New();
        vectors->SetNumberOfComponents(3);
        for (vtkIdType i = 0; i < points_->GetNumberOfPoints(); ++i) {
            double p[3];
            points_->GetPoint(i, p);
            const glm::dvec3 v = flowAt({p[0], p[1], p[2]});
            vectors->InsertNextTuple3(v.x, v.y, v.z);
        }
        SurfaceMesh far;
        far.positions.assign(3, glm::vec3(0));
        far.triangles = {{0, 1, 2}};
        NearSurface everywhere(SurfaceZone(far, std::vector<double>(3, 1e6)));
        return std::make_shared<VolumeCells>(
            GridVolume(grid_.GetPointer(), vectors, nullptr, "cells.vtu").near(everywhere, 1).cells);
    }

    const vtkNew<vtkUnstructuredGrid> grid_;
    const vtkNew<vtkPoints> points_;
};

TEST(GridVolumes, EveryKindOfCell)
{
    for (const int type : {VTK_TETRA, VTK_HEXAHEDRON, VTK_VOXEL, VTK_WEDGE, VTK_PYRAMID, VTK_PENTAGONAL_PRISM,
                           VTK_HEXAGONAL_PRISM, VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE,
                           VTK_QUADRATIC_PYRAMID, VTK_TRIQUADRATIC_HEXAHEDRON, VTK_QUADRATIC_LINEAR_WEDGE,
                           VTK_BIQUADRATIC_QUADRATIC_WEDGE, VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON})
        for (const bool mirrored : {false, true}) {
            SCOPED_TRACE(vtkCellTypes::GetClassNameFromTypeId(type));
            Cells cells;
            cells.add(VTK_TRIANGLE);
            const glm::dvec3 middle = cells.add(type, mirrored);
            const auto volume = cells.take();
            ASSERT_EQ(volume->count(), 1u) << "the triangle has no volume";
            const CellSampler sampler(volume);
            CellPlace place;
            for (const glm::dvec3& off : {glm::dvec3(0), glm::dvec3(0.02, 0.01, -0.03)}) {
                ASSERT_TRUE(sampler.findWithin(middle + off, place));
                EXPECT_LT(glm::length(sampler.vectorAt(place) - flowAt(middle + off)), 1e-5);
            }
            EXPECT_FALSE(sampler.findWithin(middle + glm::dvec3(5, 0, 0), place));
        }
}

TEST(GridVolumes, APolyhedronHasItsOwnFaces)
{
    Cells cells;
    cells.add(VTK_VERTEX);
    const double corners[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const vtkIdType base = cells.points_->GetNumberOfPoints();
    for (const auto& p : corners) cells.points_->InsertNextPoint(p);
    vtkNew<vtkIdList> faces;
    faces->InsertNextId(8);
    for (const vtkIdType x : {0, 1})
        for (const vtkIdType y : {2, 3})
            for (const vtkIdType z : {4, 5})
                for (const vtkIdType id : {vtkIdType{3} - base, x, y, z}) faces->InsertNextId(base + id);
    cells.grid_->InsertNextCell(VTK_POLYHEDRON, faces);
    const auto volume = cells.take();
    ASSERT_EQ(volume->count(), 1u);
    const CellSampler sampler(volume);
    CellPlace place;
    const glm::dvec3 in(0.2, -0.3, 0.4), out(0.5, -0.5, 0.4);
    ASSERT_TRUE(sampler.findWithin(in, place));
    EXPECT_LT(glm::length(sampler.vectorAt(place) - flowAt(in)), 1e-6);
    EXPECT_FALSE(sampler.findWithin(out, place));
}

TEST(GridVolumes, HiddenCellsAndCellsWithoutAPlaceAreLeftOut)
{
    Cells cells;
    for (int i = 0; i < 3; ++i) cells.add(VTK_HEXAHEDRON);
    cells.points_->SetPoint(2, std::numeric_limits<double>::quiet_NaN(), 0, 0);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (const int flag : {0, int(vtkDataSetAttributes::HIDDENCELL), int(vtkDataSetAttributes::DUPLICATECELL)})
        ghosts->InsertNextValue(static_cast<unsigned char>(flag));
    cells.grid_->GetCellData()->AddArray(ghosts);
    EXPECT_EQ(cells.take()->count(), 1u) << "a duplicate has the values of the other";
}

TEST(GridVolumes, FlatDataHaveNone)
{
    Cells cells;
    cells.add(VTK_QUAD);
    EXPECT_FALSE(hasVolume(*cells.grid_));
    EXPECT_EQ(cells.take()->count(), 0u);
    cells.add(VTK_PYRAMID);
    EXPECT_TRUE(hasVolume(*cells.grid_));
}

/// Cells that are far from the surface stay in the file's data, and so do points that none of the others has.
TEST(GridVolumes, OnlyCellsNearTheSurfaceAreTaken)
{
    Cells cells;
    for (int i = 0; i < 10; ++i) cells.add(VTK_HEXAHEDRON);
    const auto vectors = vtkSmartPointer<vtkFloatArray>::New();
    vectors->SetNumberOfComponents(3);
    vectors->SetNumberOfTuples(80);
    vectors->Fill(1);
    const GridVolume volume(cells.grid_.GetPointer(), vectors, nullptr, "cells.vtu");
    SurfaceMesh mesh;
    mesh.originWorld = {12.5, 0.5, 0.5};  // In the fifth cell.
    mesh.positions = {{0, 0, 0}, {0.1F, 0, 0}, {0, 0.1F, 0}};
    mesh.triangles = {{0, 1, 2}};
    NearSurface surface(SurfaceZone(mesh, {})), wider(SurfaceZone(mesh, {3, 3, 3}));
    const auto [one, leftOut] = volume.near(surface, 1);
    EXPECT_NEAR(leftOut.least(), 2, 0.5) << "a cell's diagonal";
    EXPECT_EQ(one.count(), 1u);
    EXPECT_EQ(one.points.size(), 8u);
    EXPECT_EQ(volume.near(wider, 1).cells.count(), 3u);
    EXPECT_EQ(volume.bounds().lo.x, 0);
    EXPECT_GT(volume.bounds().hi.x, 27);
}

/// Whether cells are asked one by one or in runs makes no difference, in whatever order they stand.
TEST(GridVolumes, NearCellsAreTheSameInRuns)
{
    constexpr int side = 24;
    for (const bool inOrder : {true, false}) {
        vtkNew<vtkUnstructuredGrid> grid;
        vtkNew<vtkPoints> points;
        points->SetDataType(VTK_DOUBLE);
        grid->SetPoints(points);
        std::vector<int> order(side * side * side);
        std::iota(order.begin(), order.end(), 0);
        if (!inOrder) std::shuffle(order.begin(), order.end(), std::mt19937(5));
        for (const int i : order) {
            const double x = double(i % side), y = std::exp(0.1 * (i / side % side)), z = double(i / side / side);
            vtkIdType corners[4] = {points->InsertNextPoint(x, y, z), points->InsertNextPoint(x + 1, y, z),
                                    points->InsertNextPoint(x, y * 1.1, z), points->InsertNextPoint(x, y, z + 1)};
            if (i % 1000 == 7) points->SetPoint(corners[2], x, std::numeric_limits<double>::quiet_NaN(), z);
            grid->InsertNextCell(VTK_TETRA, 4, corners);
        }
        SurfaceMesh mesh;
        mesh.positions = {{2, 3, 2}, {20, 3.5F, 3}, {2, 3, 19}, {60, 3, 19}};
        mesh.triangles = {{0, 1, 2}, {1, 2, 3}};
        NearSurface surface(SurfaceZone(mesh, {0.3, 0, 0, 1}));
        const NearSurface plain(SurfaceZone(mesh, {0.3, 0, 0, 1}));
        const auto boxOf = cellBoxesOf(*grid);
        const CellRuns runs = runsOfCells(*grid);
        for (const double diagonals : {1.0, 1.5}) {
            const NearCells near = nearCellsOf(*grid, runs, surface, diagonals);
            double least = std::numeric_limits<double>::infinity();
            int found = 0;
            for (std::size_t cell = 0; cell < near.chosen.size(); ++cell) {
                const Bounds box = boxOf(cell);
                const bool expected = isFinite(box) && plain.isNear(box.center(), diagonals * box.diagonal());
                ASSERT_EQ(bool(near.chosen[cell]), expected) << cell;
                found += expected;
                if (isFinite(box) && !expected) least = std::min(least, box.diagonal());
            }
            EXPECT_EQ(near.leftOut.least(), least);
            EXPECT_GT(found, 500);
            EXPECT_LT(found, 3 * side * side * side / 4);
        }
    }
}

}  // namespace
}  // namespace aeolic
