#include "data/vtk/surface/isosurface.h"

#include <gtest/gtest.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>

#include "aeolic/error.h"
#include "base/memory.h"
#include "data/vtk/grid/uniform_grid.h"

namespace aeolic {
namespace {

using ValueAt = std::function<double(const glm::dvec3& world)>;

struct Grid {
    vtkNew<vtkImageData> image;
    GridField field;

    Grid(const std::array<int, 3>& dims, const ValueAt& valueAt)
    {
        image->SetDimensions(dims.data());
        image->SetOrigin(1, -2, 3);
        image->SetSpacing(0.1, 0.12, 0.09);
        vtkNew<vtkFloatArray> values;
        values->SetName("p");
        values->SetNumberOfTuples(image->GetNumberOfPoints());
        for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i) {
            const double* p = image->GetPoint(i);
            values->SetValue(i, float(valueAt({p[0], p[1], p[2]})));
        }
        image->GetPointData()->SetScalars(values);
        field = gridStructure(*image, std::nullopt);
        setSamples(field, values);
    }
    Brick all() const { return {{0, 0, 0}, {field.dims[0] - 1, field.dims[1] - 1, field.dims[2] - 1}}; }
    glm::dvec3 center() const { return boundsOf().center(); }
    Bounds boundsOf() const
    {
        Bounds bounds;
        bounds.add({1, -2, 3});
        bounds.add(glm::dvec3(1, -2, 3) +
                   glm::dvec3(0.1, 0.12, 0.09) * glm::dvec3(field.dims[0] - 1, field.dims[1] - 1, field.dims[2] - 1));
        return bounds;
    }
};

double areaOf(const SurfaceMesh& mesh)
{
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        area += 0.5 * glm::length(glm::cross(glm::dvec3(mesh.positions[b] - mesh.positions[a]),
                                             glm::dvec3(mesh.positions[c] - mesh.positions[a])));
    return area;
}

constexpr double kRadius = 0.8;

Grid sphere()
{
    const glm::dvec3 center(2, -0.8, 3.9);
    return {{21, 21, 21}, [=](const glm::dvec3& p) { return glm::length(p - center); }};
}

TEST(Isosurface, OfADistanceIsASphere)
{
    const Grid grid = sphere();
    const SurfaceMesh mesh = isosurface(grid.field, grid.all(), kRadius);
    EXPECT_NEAR(areaOf(mesh), 4 * std::numbers::pi * kRadius * kRadius, 0.05);
    const glm::dvec3 center(2, -0.8, 3.9);
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 fromCenter = mesh.originWorld + glm::dvec3(mesh.positions[i]) - center;
        ASSERT_NEAR(glm::length(fromCenter), kRadius, 0.12 * 0.12 / (8 * kRadius) + 1e-4)
            << "a chord is that far inside";
        ASSERT_GT(glm::dot(glm::normalize(fromCenter), glm::dvec3(mesh.normals[i])), 0.999);
        ASSERT_NEAR(glm::length(mesh.normals[i]), 1, 1e-6);
    }
}

/// Every edge has two triangles: no crack between cells, or layers.
TEST(Isosurface, IsClosed)
{
    const Grid grid = sphere();
    const SurfaceMesh mesh = isosurface(grid.field, grid.all(), kRadius);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++edges[std::minmax(t[k], t[(k + 1) % 3])];
    for (const auto& [edge, triangles] : edges) ASSERT_EQ(triangles, 2);
    EXPECT_EQ(std::int64_t(mesh.positions.size()) - std::int64_t(edges.size()) + std::int64_t(mesh.triangles.size()), 2)
        << "Euler: a sphere";
}

TEST(Isosurface, HasTheTrianglesOfVtk)
{
    const Grid grid({17, 13, 19}, [](const glm::dvec3& p) {
        return std::sin(9 * p.x) * std::cos(8 * p.y) + std::sin(7 * p.y) * std::cos(9 * p.z) + std::sin(6 * p.z + p.x);
    });
    for (const double value : {-0.5, 0.1, 0.7}) {
        vtkNew<vtkFlyingEdges3D> filter;
        filter->SetInputData(grid.image);
        filter->SetValue(0, value);
        filter->Update();
        const SurfaceMesh mesh = isosurface(grid.field, grid.all(), value);
        vtkPolyData& expected = *filter->GetOutput();
        ASSERT_EQ(vtkIdType(mesh.triangles.size()), expected.GetNumberOfPolys());
        EXPECT_EQ(vtkIdType(mesh.positions.size()), expected.GetNumberOfPoints());
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            glm::dvec3 mean(0), expectedMean(0);
            vtkIdType size = 0;
            const vtkIdType* corners = nullptr;
            expected.GetPolys()->GetCellAtId(vtkIdType(i), size, corners);
            for (std::size_t k = 0; k < 3; ++k) {
                const double* p = expected.GetPoint(corners[k]);
                expectedMean += glm::dvec3(p[0], p[1], p[2]) / 3.0;
                mean += (mesh.originWorld + glm::dvec3(mesh.positions[mesh.triangles[i][k]])) / 3.0;
            }
            ASSERT_LT(glm::length(mean - expectedMean), 1e-5) << "in the same order";
        }
    }
}

TEST(Isosurface, MaskedSamplesLeaveAHole)
{
    const glm::dvec3 center(2, -0.8, 3.9);
    const Grid whole = sphere();
    const Grid masked({21, 21, 21}, [=](const glm::dvec3& p) {
        return p.x > center.x + 0.55 ? std::numeric_limits<double>::quiet_NaN() : glm::length(p - center);
    });
    const SurfaceMesh mesh = isosurface(masked.field, masked.all(), kRadius);
    EXPECT_LT(mesh.triangles.size(), isosurface(whole.field, whole.all(), kRadius).triangles.size());
    EXPECT_GT(mesh.triangles.size(), 500u);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        ASSERT_LE(mesh.originWorld.x + double(mesh.positions[i].x), center.x + 0.56);
        const glm::dvec3 fromCenter = mesh.originWorld + glm::dvec3(mesh.positions[i]) - center;
        ASSERT_GT(glm::dot(glm::normalize(fromCenter), glm::dvec3(mesh.normals[i])), 0.99) << "one-sided at the hole";
    }
}

/// Differences over two cells vanish where samples alternate.
TEST(Isosurface, EveryPointHasANormal)
{
    int sample = 0;
    const Grid grid({5, 5, 5}, [&](const glm::dvec3&) { return double(sample++ % 2); });
    const SurfaceMesh mesh = isosurface(grid.field, grid.all(), 0.5);
    ASSERT_GT(mesh.triangles.size(), 100u);
    for (const glm::vec3& normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1, 1e-6);
}

TEST(Isosurface, OfNoCellsIsNothing)
{
    const Grid grid = sphere();
    EXPECT_TRUE(isosurface(grid.field, {}, kRadius).triangles.empty());
    EXPECT_TRUE(isosurface(grid.field, grid.all(), 77).positions.empty());
    EXPECT_EQ(isosurface(grid.field, grid.all(), 77).originWorld, grid.center());
}

TEST(Isosurface, IsCountedAsItIsExtracted)
{
    int sample = 0;
    const Grid alternating({9, 8, 21}, [&](const glm::dvec3&) { return double(++sample * 7919 % 11); });
    const Grid masked({21, 21, 21}, [](const glm::dvec3& p) {
        return p.x > 2.5 ? std::numeric_limits<double>::quiet_NaN() : glm::length(p - glm::dvec3(2, -0.8, 3.9));
    });
    const Grid around = sphere();
    for (const Grid* grid : {&alternating, &masked, &around})
        for (const Brick& cells : {grid->all(), Brick{{1, 2, 3}, {6, 5, 17}}, Brick{{0, 0, 0}, {1, 1, 1}}, Brick{}})
            for (const double value : {kRadius, 5.0, 77.0}) {
                const SurfaceMesh mesh = isosurface(grid->field, cells, value);
                const IsosurfaceSize size = isosurfaceSize(grid->field, cells, value);
                EXPECT_EQ(size.points, mesh.positions.size());
                EXPECT_EQ(size.triangles, mesh.triangles.size());
            }
}

TEST(Isosurface, TooLargeForMemoryIsRefusedInOneLine)
{
    const SurfaceSpec spec = parseSurfaceSpec("isosurface:p=0.5");
    EXPECT_NO_THROW(requireRoomFor(spec, "f.vti", {50'000, 100'000}, 2));
    const auto messageOf = [&](const IsosurfaceSize& size, int readers) -> std::string {
        try {
            requireRoomFor(spec, "f.vti", size, readers);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    const std::string one = messageOf({1, 1'000'000'000'000'000}, 1),
                      shared = messageOf({1, 1'000'000'000'000'000}, 64);
    for (const std::string& message : {one, shared}) {
        EXPECT_EQ(message.find("f.vti"), 0u) << message;
        EXPECT_NE(message.find("'isosurface:p=0.5' with 1000000000.0 million triangles"), message.npos) << message;
        EXPECT_NE(message.find("of memory that is available"), message.npos) << message;
        EXPECT_EQ(message.find('\n'), message.npos) << message;
    }
    EXPECT_NE(shared.find("64 ranks"), shared.npos) << shared;
    EXPECT_NE(messageOf({std::uint64_t{1} << 32, 8}, 1), "") << "indices have 32 bits";
    // What one rank has room for, 64 ranks of the same host may not.
    const std::uint64_t fits = availableMemoryBytes() / 10 / 40;
    EXPECT_EQ(messageOf({1, fits}, 1), "");
    EXPECT_NE(messageOf({1, fits}, 64), "");
}

}  // namespace
}  // namespace aeolic
