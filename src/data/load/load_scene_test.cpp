#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "aeolic/error.h"
#include "base/half.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "describe_testing.h"
#include "test_paths.h"

namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

/// The field's vector at a grid coordinate that need not be whole; trilinear.
glm::dvec3 sampleAt(const GridField& field, const glm::dvec3& world)
{
    const glm::dvec3 grid = (world - field.originWorld) / field.spacingWorld, cell = glm::floor(grid), w = grid - cell;
    glm::dvec3 sum{0};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 o{corner & 1, corner >> 1 & 1, corner >> 2};
        const auto index = std::size_t((cell.z + o.z) * double(field.dims[1] * field.dims[0]) +
                                       (cell.y + o.y) * double(field.dims[0]) + cell.x + o.x);
        const glm::dvec3 weight = o * w + (1.0 - o) * (1.0 - w);
        for (int c = 0; c < 3; ++c)
            sum[c] += weight.x * weight.y * weight.z * double(field.floats()[3 * index + std::size_t(c)]);
    }
    return sum;
}

void expectLinearField(const GridField& field, double tolerance)
{
    for (const glm::dvec3& p :
         {glm::dvec3(-0.9, -0.3, 0.4), glm::dvec3(0.13, 0.41, 1.1), glm::dvec3(0.77, 1.03, 1.55)}) {
        const auto u = sampleVector(p.x, p.y, p.z);
        const glm::dvec3 found = sampleAt(field, p);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], u[std::size_t(c)], tolerance);
    }
}

int maskedSamples(const GridField& field)
{
    int count = 0;
    for (std::size_t i = 0; i < field.sampleCount(); ++i) count += std::isnan(field.floats()[3 * i]);
    return count;
}

struct Format {
    const char* file;
    Encoding encoding;
    bool doubles, onCells;
    int legacyKind;
    double tolerance;
};

class EveryGridFormat : public testing::TestWithParam<Format> {};

TEST_P(EveryGridFormat, GivesTheSameLinearField)
{
    const TempFolder folder;
    GridSample sample;
    sample.encoding = GetParam().encoding;
    sample.doubles = GetParam().doubles;
    sample.legacyKind = GetParam().legacyKind;
    writeGridFile(folder.file(GetParam().file), sample);
    SceneDescription description = describe("sphere", folder.file(GetParam().file));
    description.field.resampleSpacing = 0.25;
    const Scene scene = loadScene(description);
    ASSERT_TRUE(scene.field);
    EXPECT_EQ(scene.field->name, "U");
    expectLinearField(*scene.field, GetParam().tolerance);
}

INSTANTIATE_TEST_SUITE_P(
    Files, EveryGridFormat,
    testing::Values(
        Format{"a.vti", Encoding::raw, false, false, 0, 1e-6}, Format{"a.vti", Encoding::zlib, false, false, 0, 1e-6},
        Format{"a.vti", Encoding::ascii, false, false, 0, 1e-5}, Format{"a.vti", Encoding::raw, true, false, 0, 1e-6},
        Format{"a.vtr", Encoding::raw, false, false, 0, 1e-6}, Format{"a.vts", Encoding::zlib, false, false, 0, 1e-5},
        Format{"a.vtu", Encoding::raw, false, false, 0, 1e-5}, Format{"a.vtk", Encoding::raw, false, false, 0, 1e-6},
        Format{"a.vtk", Encoding::ascii, true, false, 1, 1e-5}, Format{"a.vtk", Encoding::raw, false, false, 2, 1e-5},
        Format{"a.vtk", Encoding::raw, true, false, 3, 1e-5}, Format{"a.pvti", Encoding::raw, false, false, 0, 1e-6},
        Format{"a.pvtr", Encoding::zlib, false, false, 0, 1e-6}, Format{"a.pvts", Encoding::raw, false, false, 0, 1e-5},
        Format{"a.pvtu", Encoding::raw, false, false, 0, 1e-5}));

TEST(LoadField, ExtensionsInCapitals)
{
    const TempFolder folder;
    writeGridFile(folder.file("a.vti"));
    std::filesystem::rename(folder.file("a.vti"), folder.file("A.VTI"));
    EXPECT_TRUE(loadScene(describe("sphere", folder.file("A.VTI"))).field);
}

TEST(LoadField, UniformGridIsTakenAsItIs)
{
    const TempFolder folder;
    for (const char* name : {"a.vti", "a.vtr"}) {
        writeGridFile(folder.file(name));
        const Scene scene = loadScene(describe("sphere", folder.file(name)));
        EXPECT_EQ(scene.field->dims, (std::array<std::int64_t, 3>{9, 8, 7}));
        EXPECT_NEAR(glm::length(scene.field->originWorld - glm::dvec3(-1, -0.5, 0.25)), 0, 1e-12);
        EXPECT_NEAR(glm::length(scene.field->spacingWorld - glm::dvec3(0.25)), 0, 1e-12);
        // |U| is largest at (-1, 1.25, 1.75).
        EXPECT_NEAR(scene.maxVector, std::sqrt(0 + 6.25 + 7.5625), 1e-6);
        ASSERT_EQ(scene.warnings.size(), 1u);
        EXPECT_NE(scene.warnings[0].find("outside the field"), std::string::npos) << "the sphere is larger";
    }
}

TEST(LoadField, StretchedGridIsResampledWhereASpacingIsGiven)
{
    const TempFolder folder;
    GridSample sample;
    sample.dims = {17, 16, 15};
    sample.spacing = {0.125, 0.125, 0.125};
    sample.stretch = -0.2;
    writeGridFile(folder.file("a.vtr"), sample);
    SceneDescription description = describe("sphere", folder.file("a.vtr"));
    EXPECT_FALSE(loadScene(description).field);
    description.field.resampleSpacing = 0.1;
    const Scene scene = loadScene(description);
    EXPECT_GT(scene.field->sampleCount(), 15u * 14 * 13);
    EXPECT_EQ(maskedSamples(*scene.field), 0);
    expectLinearField(*scene.field, 1e-5);
}

TEST(LoadField, ResampleSpacingIsKeptTo)
{
    const TempFolder folder;
    writeGridFile(folder.file("a.vtu"));
    SceneDescription description = describe("sphere", folder.file("a.vtu"));
    description.field.resampleSpacing = 0.1;
    const Scene scene = loadScene(description);
    EXPECT_EQ(scene.field->dims, (std::array<std::int64_t, 3>{21, 19, 16}));  // 2 x 1.75 x 1.5 world units.
    EXPECT_LE(scene.field->spacingWorld.y, 0.1);
}

TEST(LoadField, CellValuesAreBroughtToThePoints)
{
    const TempFolder folder;
    GridSample sample;
    sample.onCells = true;
    for (const char* name : {"a.vti", "a.vtu"}) {
        writeGridFile(folder.file(name), sample);
        SceneDescription description = describe("sphere", folder.file(name));
        description.field.resampleSpacing = 0.25;
        const Scene scene = loadScene(description);
        // Away from the boundary the mean of a linear field around a point is the field there.
        const glm::dvec3 p(0.0, 0.5, 1.0), found = sampleAt(*scene.field, p);
        EXPECT_NEAR(found.x, 1.0, 0.08);
        EXPECT_NEAR(found.y, 1.0, 0.08);
        EXPECT_NEAR(found.z, -1.0, 0.08);
    }
}

TEST(LoadField, MaskedHiddenAndNonFiniteSamplesAreNanAndCounted)
{
    const TempFolder folder;
    GridSample sample;
    sample.nanPoints = {3, 4};
    sample.infinitePoints = {7};
    sample.maskedPoints = {10, 11, 12};
    sample.hiddenPoints = {20};
    writeGridFile(folder.file("a.vti"), sample);
    const Scene scene = loadScene(describe("sphere", folder.file("a.vti")));
    for (const std::size_t i : {3, 4, 7, 10, 11, 12, 20})
        for (std::size_t c = 0; c < 3; ++c) EXPECT_TRUE(std::isnan(scene.field->floats()[3 * i + c])) << i;
    EXPECT_EQ(maskedSamples(*scene.field), 7);
    ASSERT_EQ(scene.warnings.size(), 2u);  // And the sphere is larger than the grid.
    EXPECT_NE(scene.warnings[0].find("4 masked, 3 not finite of 504 points"), std::string::npos) << scene.warnings[0];
    EXPECT_TRUE(std::isfinite(scene.maxVector));
}

TEST(LoadField, OutsideTheCellsAResampledFieldIsNan)
{
    const TempFolder folder;
    GridSample sample;
    sample.maskedPoints = {0};  // Its cells give NaN as well.
    writeGridFile(folder.file("a.vts"), sample);
    SceneDescription description = describe("sphere", folder.file("a.vts"));
    description.field.resampleSpacing = 0.2;
    const Scene scene = loadScene(description);
    EXPECT_GE(maskedSamples(*scene.field), 1);
    EXPECT_LT(maskedSamples(*scene.field), 30);
}

TEST(LoadField, HalfPrecisionRoundsTheSameSamples)
{
    const TempFolder folder;
    writeGridFile(folder.file("a.vti"));
    SceneDescription description = describe("sphere", folder.file("a.vti"));
    const Scene whole = loadScene(description);
    description.field.precision = FieldPrecision::float16;
    const Scene half = loadScene(description);
    ASSERT_EQ(half.field->precision, FieldPrecision::float16);
    ASSERT_EQ(half.field->bytes(), whole.field->bytes() / 2);
    for (std::size_t i = 0; i < whole.field->sampleCount() * 3; ++i)
        ASSERT_EQ(half.field->halves()[i], halfFromFloat(whole.field->floats()[i])) << i;
    description.field.spec = "rotation";
    EXPECT_EQ(loadScene(description).field->precision, FieldPrecision::float16);
}

TEST(LoadField, TheChosenArrayIsTakenAndNoOther)
{
    const TempFolder folder;
    GridSample sample;
    sample.secondVectors = true;
    writeGridFile(folder.file("a.vti"), sample);
    SceneDescription description = describe("sphere", folder.file("a.vti"));
    description.field.vectors = "W";
    EXPECT_EQ(loadScene(description).field->name, "W");
    description.field.vectors.clear();
    EXPECT_THROW(loadScene(description), InputError);
}

TEST(Cut, SliceLiesInItsPlaneAndSpansTheBox)
{
    const TempFolder folder;
    for (const char* name : {"a.vti", "a.vtu"}) {
        writeGridFile(folder.file(name));
        const Scene scene = loadScene(describe("slice:0.3,0,1:1,0,0", folder.file(name)));
        for (const glm::vec3& p : scene.surface.positions) EXPECT_NEAR(p.x + scene.surface.originWorld.x, 0.3, 1e-6);
        EXPECT_NEAR(scene.boundsWorld.hi.y - scene.boundsWorld.lo.y, 1.75, 1e-3);
        EXPECT_NEAR(scene.boundsWorld.hi.z - scene.boundsWorld.lo.z, 1.5, 1e-3);
    }
}

TEST(Cut, SliceOnTheVeryFaceOfTheBoxIsThere)
{
    const TempFolder folder;
    for (const char* name : {"a.vti", "a.vtu"}) {
        writeGridFile(folder.file(name));
        for (const char* spec : {"slice:-1,0,1:1,0,0", "slice:1,0,1:1,0,0", "slice:0,0,0.25:0,0,-2"})
            EXPECT_GT(loadScene(describe(spec, folder.file(name))).surface.triangles.size(), 0u) << spec << name;
    }
}

TEST(Cut, OfCellsThatAreNotUniformTheSurfaceCarriesTheVectors)
{
    const TempFolder folder;
    writeGridFile(folder.file("a.vtu"));
    for (const char* spec : {"slice:0.3,0,1:1,1,0", "isosurface:p=100", "boundary"}) {
        const Scene scene = loadScene(describe(spec, folder.file("a.vtu"), "U:mag"));
        EXPECT_FALSE(scene.field) << spec;
        ASSERT_EQ(scene.surface.pointVectors.size(), scene.surface.positions.size()) << spec;
        for (std::size_t i = 0; i < scene.surface.positions.size(); ++i) {
            const glm::dvec3 p = scene.surface.originWorld + glm::dvec3(scene.surface.positions[i]);
            const auto u = sampleVector(p.x, p.y, p.z);
            ASSERT_NEAR(scene.surface.pointVectors[i].z, u[2], 1e-4) << spec;
            ASSERT_NEAR(scene.surface.pointScalars[i], std::hypot(u[0], u[1], u[2]), 1e-4) << spec;
        }
    }
}

TEST(Cut, WithASpacingTheFieldIsResampledAllTheSame)
{
    const TempFolder folder;
    writeGridFile(folder.file("a.vtu"));
    SceneDescription description = describe("slice:0.3,0,1:1,1,0", folder.file("a.vtu"));
    description.field.resampleSpacing = 0.2;
    const Scene scene = loadScene(description);
    EXPECT_TRUE(scene.field);
    EXPECT_TRUE(scene.surface.pointVectors.empty());
}

TEST(Cut, IsosurfaceOfALinearScalarIsItsPlane)
{
    const TempFolder folder;
    for (const char* name : {"a.vti", "a.vtr", "a.vtu"}) {
        writeGridFile(folder.file(name));
        const Scene scene = loadScene(describe("isosurface:p=104", folder.file(name)));
        ASSERT_GT(scene.surface.triangles.size(), 20u);
        for (const glm::vec3& local : scene.surface.positions) {
            const glm::dvec3 p = scene.surface.originWorld + glm::dvec3(local);
            ASSERT_NEAR(sampleScalar(p.x, p.y, p.z), 104, 1e-3) << name;
        }
    }
}

TEST(Cut, AnIsosurfaceHasItsOwnArrayToColourBy)
{
    const TempFolder folder;
    for (const char* name : {"a.vtr", "a.vts", "a.vtu"}) {
        GridSample sample;
        sample.stretch = 0.1;
        writeGridFile(folder.file(name), sample);
        for (const auto& [array, value] : {std::pair("p", 100.0F), std::pair("U:mag", 1.5F)}) {
            const std::string spec = "isosurface:" + std::string(array) + (value == 100 ? "=100" : "=1.5");
            const Scene scene = loadScene(describe(spec, folder.file(name), array));
            ASSERT_GT(scene.surface.triangles.size(), 20u) << name << spec;
            ASSERT_EQ(scene.surface.pointScalars.size(), scene.surface.positions.size()) << name << spec;
            for (const float found : scene.surface.pointScalars)
                ASSERT_NEAR(found, value, 0.05 * value) << name << spec;
        }
    }
}

TEST(Cut, IsosurfaceOfALength)
{
    const TempFolder folder;
    writeGridFile(folder.file("a.vti"));
    EXPECT_GT(loadScene(describe("isosurface:U:mag=1.5", folder.file("a.vti"))).surface.triangles.size(), 20u);
}

TEST(Cut, BoundaryOfAFlatImageCarriesItsVectors)
{
    const TempFolder folder;
    GridSample sample;
    sample.dims = {9, 8, 1};
    writeGridFile(folder.file("a.vti"), sample);
    const Scene scene = loadScene(describe("boundary", folder.file("a.vti")));
    EXPECT_EQ(scene.surface.triangles.size(), 2u * 8 * 7);
    EXPECT_EQ(scene.surface.pointVectors.size(), scene.surface.positions.size());
}

TEST(Ahmed, BodyHasItsPointsAndTriangles)
{
    const Scene scene = loadScene(describe(AEOLIC_SOURCE_DIR "/examples/ahmed/ahmed.vtp", "", "p"));
    EXPECT_EQ(scene.surface.triangles.size(), 76886u);
    EXPECT_GE(scene.surface.positions.size(), 38447u);  // Sharp edges have split points.
    EXPECT_EQ(scene.surface.pointVectors.size(), scene.surface.positions.size());
    EXPECT_EQ(scene.surface.normals.size(), scene.surface.positions.size());
    EXPECT_NEAR(scene.scalarRange[0], -1408.4932861, 1e-3);
    EXPECT_NEAR(scene.scalarRange[1], 802.92169189, 1e-3);
    EXPECT_NEAR(scene.maxVector, 9.8443699577, 1e-4);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(Ahmed, WakeIsMaskedInsideTheBody)
{
    const Scene scene = loadScene(describe("slice:1.3,0,0:1,0,0", AEOLIC_SOURCE_DIR "/examples/ahmed/ahmed_wake.vti"));
    EXPECT_EQ(scene.field->dims, (std::array<std::int64_t, 3>{127, 43, 34}));
    EXPECT_EQ(maskedSamples(*scene.field), 23050);
    EXPECT_NEAR(scene.maxVector, 58.056044009, 1e-4);
    EXPECT_EQ(scene.warnings.size(), 1u);
}

}  // namespace
}  // namespace aeolic
