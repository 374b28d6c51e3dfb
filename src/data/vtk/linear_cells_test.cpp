#include "data/vtk/linear_cells.h"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellType.h>
#include <vtkGenericCell.h>
#include <vtkHigherOrderHexahedron.h>
#include <vtkHigherOrderQuadrilateral.h>
#include <vtkHigherOrderWedge.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkNonLinearCell.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <glm/glm.hpp>

#include "aeolic/error.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "describe_testing.h"

namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

/// Where VTK has the points of a cell of that many.
std::vector<glm::dvec3> placesOf(int type, vtkIdType points)
{
    const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
    cell->PointIds->SetNumberOfIds(points);
    cell->Points->SetNumberOfPoints(points);
    for (vtkIdType i = 0; i < points; ++i) {
        cell->PointIds->SetId(i, i);
        cell->Points->SetPoint(i, 0, 0, 0);
    }
    if (auto* quad = vtkHigherOrderQuadrilateral::SafeDownCast(cell)) quad->SetUniformOrderFromNumPoints(points);
    if (auto* hexahedron = vtkHigherOrderHexahedron::SafeDownCast(cell))
        hexahedron->SetUniformOrderFromNumPoints(points);
    if (auto* wedge = vtkHigherOrderWedge::SafeDownCast(cell)) wedge->SetUniformOrderFromNumPoints(points);
    cell->Initialize();
    const double* p = cell->GetParametricCoords();
    std::vector<glm::dvec3> places;
    for (vtkIdType i = 0; p && i < points; ++i) places.emplace_back(p[3 * i], p[3 * i + 1], p[3 * i + 2]);
    return places;
}

/// The signed size of a linear cell: of a triangle or quadrilateral along z, else its volume by tetrahedra.
double sizeOf(int type, const std::vector<glm::dvec3>& c)
{
    const auto tetra = [&](std::size_t a, std::size_t b, std::size_t d, std::size_t e) {
        return glm::dot(c[b] - c[a], glm::cross(c[d] - c[a], c[e] - c[a])) / 6;
    };
    const auto area = [&](std::size_t a, std::size_t b, std::size_t d) {
        return glm::cross(c[b] - c[a], c[d] - c[a]).z / 2;
    };
    switch (type) {
        case VTK_TRIANGLE:
            return area(0, 1, 2);
        case VTK_QUAD:
            return area(0, 1, 2) + area(0, 2, 3);
        case VTK_TETRA:
            return tetra(0, 1, 2, 3);
        case VTK_WEDGE:
            return tetra(0, 1, 2, 3) + tetra(1, 2, 3, 4) + tetra(2, 3, 4, 5);
        default:
            return tetra(0, 1, 3, 4) + tetra(1, 2, 3, 6) + tetra(1, 3, 4, 6) + tetra(1, 4, 5, 6) + tetra(3, 4, 6, 7);
    }
}

/// The small cells fill the large one: none is turned inside out, and together they are as large.
TEST(LagrangeCells, AreCutIntoCellsThatFillThem)
{
    const struct {
        int type, linear;
        vtkIdType (*points)(vtkIdType);
        vtkIdType (*cells)(vtkIdType);
        double size;
    } kinds[] = {
        {VTK_LAGRANGE_TRIANGLE, VTK_TRIANGLE, [](vtkIdType n) { return (n + 1) * (n + 2) / 2; },
         [](vtkIdType n) { return n * n; }, 0.5},
        {VTK_LAGRANGE_QUADRILATERAL, VTK_QUAD, [](vtkIdType n) { return (n + 1) * (n + 1); },
         [](vtkIdType n) { return n * n; }, 1},
        {VTK_LAGRANGE_TETRAHEDRON, VTK_TETRA, [](vtkIdType n) { return (n + 1) * (n + 2) * (n + 3) / 6; },
         [](vtkIdType n) { return n * n * n; }, 1.0 / 6},
        {VTK_LAGRANGE_HEXAHEDRON, VTK_HEXAHEDRON, [](vtkIdType n) { return (n + 1) * (n + 1) * (n + 1); },
         [](vtkIdType n) { return n * n * n; }, 1},
        {VTK_LAGRANGE_WEDGE, VTK_WEDGE, [](vtkIdType n) { return (n + 1) * (n + 1) * (n + 2) / 2; },
         [](vtkIdType n) { return n * n * n; }, 0.5},
    };
    for (const auto& kind : kinds)
        for (vtkIdType degree = 1; degree <= 4; ++degree) {
            SCOPED_TRACE(testing::Message() << "type " << kind.type << ", degree " << degree);
            const vtkIdType points = kind.points(degree);
            const std::vector<glm::dvec3> places = placesOf(kind.type, points);
            ASSERT_EQ(vtkIdType(places.size()), points);
            const auto cut = lagrangeCut(kind.type, points, {0, 0, 0});
            ASSERT_TRUE(cut);
            EXPECT_EQ(cut->vtkType, kind.linear);
            ASSERT_EQ(cut->points.size(), std::size_t(kind.cells(degree)) * cut->corners);
            double sum = 0;
            for (std::size_t first = 0; first < cut->points.size(); first += cut->corners) {
                std::vector<glm::dvec3> corners;
                for (std::size_t k = 0; k < cut->corners; ++k)
                    corners.push_back(places[std::size_t(cut->points[first + k])]);
                const double size = std::abs(sizeOf(kind.linear, corners));
                EXPECT_NEAR(size, kind.size / double(kind.cells(degree)), 1e-9);
                EXPECT_EQ(sizeOf(kind.linear, corners) > 0,
                          sizeOf(kind.linear, {places.begin(), places.begin() + std::ptrdiff_t(cut->corners)}) > 0);
                sum += size;
            }
            EXPECT_NEAR(sum, kind.size, 1e-9);
        }
}

TEST(LagrangeCells, DegreesMayDifferAlongTheAxes)
{
    const auto cut = lagrangeCut(VTK_LAGRANGE_QUADRILATERAL, 4 * 3, {3, 2, 1});
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->points.size(), 4u * 6);
    EXPECT_FALSE(lagrangeCut(VTK_LAGRANGE_QUADRILATERAL, 4 * 3, {0, 0, 0})) << "no square";
    EXPECT_FALSE(lagrangeCut(VTK_LAGRANGE_TRIANGLE, 8, {0, 0, 0}));
    EXPECT_FALSE(lagrangeCut(VTK_HEXAHEDRON, 8, {0, 0, 0}));
}

TEST(LagrangeCells, OfBezierCellsAndPyramidsTheCornersStay)
{
    const auto bezier = lagrangeCut(VTK_BEZIER_TETRAHEDRON, 20, {0, 0, 0});
    ASSERT_TRUE(bezier);
    EXPECT_EQ(bezier->vtkType, VTK_TETRA);
    EXPECT_EQ(bezier->points, (std::vector<vtkIdType>{0, 1, 2, 3}));
    const auto pyramid = lagrangeCut(VTK_LAGRANGE_PYRAMID, 14, {0, 0, 0});
    ASSERT_TRUE(pyramid);
    EXPECT_EQ(pyramid->points.size(), 5u);
}

/// A triangle of degree 2: its four parts have the values of all its points.
TEST(LagrangeCells, FilesOfThemAreDrawn)
{
    const TempFolder folder;
    const std::string head =
        "# vtk DataFile Version 3.0\nlagrange\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 double\n"
        "0 0 0 2 0 0 0 2 0 1 0 0 1 1 0 0 1 0\nCELLS 1 7\n6 0 1 2 3 4 5\nCELL_TYPES 1\n";
    const std::string values =
        "\nPOINT_DATA 6\nSCALARS p double 1\nLOOKUP_TABLE default\n0 0 0 5 6 7\n"
        "VECTORS U double\n1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0\nCELL_DATA 1\n"
        "SCALARS q double 1\nLOOKUP_TABLE default\n3\n";
    for (const int type : {VTK_LAGRANGE_TRIANGLE, VTK_BEZIER_TRIANGLE}) {
        writeBytes(folder.file("a.vtk"), head + std::to_string(type) + values);
        const Scene scene = loadScene(describe("boundary", folder.file("a.vtk"), "p"));
        const bool isCut = type == VTK_LAGRANGE_TRIANGLE;
        EXPECT_EQ(scene.surface.triangles.size(), isCut ? 4u : 1u);
        EXPECT_EQ(scene.scalarRange[1], isCut ? 7 : 0);
        EXPECT_EQ(loadScene(describe("boundary", folder.file("a.vtk"), "q")).scalarRange[0], 3);
    }
    writeBytes(folder.file("b.vtk"), head + "72" + values);
    EXPECT_THROW(loadScene(describe("boundary", folder.file("b.vtk"))), InputError) << "six points are no hexahedron's";
}

}  // namespace
}  // namespace aeolic
