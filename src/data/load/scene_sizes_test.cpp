#include "data/load/scene_sizes.h"

#include <gtest/gtest.h>

#include <fstream>

#include "aeolic/error.h"
#include "data/vtk/testing/sample_files.h"
#include "describe_testing.h"
#include "load_testing.h"
#include "sparse_grid_testing.h"

/// What headers tell of a scene before it is read.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

void expectSameSizes(const std::optional<GridField>& announced, const std::shared_ptr<const GridField>& read)
{
    ASSERT_EQ(announced.has_value(), read != nullptr);
    if (!read) return;
    EXPECT_EQ(announced->dims, read->dims);
    EXPECT_EQ(announced->brick, read->brick);
    EXPECT_EQ(announced->components, read->components);
    EXPECT_EQ(announced->precision, read->precision);
    EXPECT_EQ(announced->bytes(), read->bytes());
    EXPECT_EQ(announced->name, read->name);
    EXPECT_FALSE(announced->samples);
}

/// What a rank that loads with others holds where the field is split.
Scene partOf(const SceneDescription& description, const FieldPart& part)
{
    return testkit::loadParts(description, {part.split(), false}, part.ranks).at(std::size_t(part.rank));
}

TEST(SceneSizes, AFieldsHeaderTellsWhatReadingItGives)
{
    const TempFolder folder;
    writeGridFile(folder.file("a.vti"));
    writeGridFile(folder.file("p.pvti"));
    for (const char* file : {"a.vti", "p.pvti"})
        for (const char* colorBy : {"", "p", "U:mag"})
            for (const FieldPrecision precision : {FieldPrecision::float32, FieldPrecision::float16})
                for (const FieldPart& part : {FieldPart{0, 1}, FieldPart{1, 3}}) {
                    SceneDescription description = describe("slice:0,0,1:0,0,1", folder.file(file), colorBy);
                    description.field.precision = precision;
                    const SceneSizes sizes = sizesOf(description, part);
                    const Scene scene = partOf(description, part);
                    expectSameSizes(sizes.field, scene.field);
                    expectSameSizes(sizes.scalarField, scene.scalarField);
                    EXPECT_FALSE(sizes.surface) << "it is cut out";
                }
}

TEST(SceneSizes, ABuiltinFlowsBricksAreAsThoseOfACube)
{
    const SceneDescription description = describe("sphere:200", "abc:20,20,21");
    expectSameSizes(sizesOf(description, {}).field, loadScene(description).field);
    expectSameSizes(sizesOf(description, {2, 3}).field, partOf(description, {2, 3}).field);
}

TEST(SceneSizes, BuiltinSurfacesHaveNoFewerThanToldBeforehand)
{
    for (const char* name : {"teapot:2000", "sphere:1000", "torus:5000", "plane", "wave:300", "teapot"}) {
        const SceneDescription description = describe(name, "abc:4,4,4");
        const auto announced = sizesOf(description, {}).surface, made = sizesOf(loadScene(description)).surface;
        ASSERT_TRUE(announced) << name;
        EXPECT_LE(announced->points, made->points) << name;
        EXPECT_LE(announced->triangles, made->triangles) << name;
        EXPECT_GE(1.4 * double(announced->triangles), double(made->triangles)) << name;
    }
}

TEST(SceneSizes, ASurfacesHeaderTellsItsPolygons)
{
    const TempFolder folder;
    SheetSample sheet;
    sheet.cells = SheetSample::Cells::triangles;
    writeSheetFile(folder.file("a.vtp"), sheet);
    const auto announced = sizesOf(describe(folder.file("a.vtp"), ""), {}).surface;
    ASSERT_TRUE(announced);
    EXPECT_EQ(announced->points, 25u);
    EXPECT_EQ(announced->triangles, 32u);
    std::ofstream(folder.file("a.ply")) << "ply\nformat ascii 1.0\nelement vertex 7\nproperty float x\n"
                                           "property float y\nproperty float z\nelement face 9\n"
                                           "property list uchar int vertex_indices\nend_header\n";
    EXPECT_EQ(sizesOf(describe(folder.file("a.ply"), "abc:4,4,4"), {}).surface->triangles, 9u);
    EXPECT_EQ(sizesOf(describe(folder.file("a.ply"), "abc:4,4,4"), {}).surface->points, 7u);
    std::ofstream stl(folder.file("a.stl"), std::ios::binary);
    stl << std::string(80, ' ') << '\x02' << std::string(3, '\0') << std::string(100, '\0');
    stl.close();
    EXPECT_EQ(sizesOf(describe(folder.file("a.stl"), "abc:4,4,4"), {}).surface->triangles, 2u);
}

TEST(SceneSizes, WhatAHeaderCannotTellIsMissing)
{
    const TempFolder folder;
    writeGridFile(folder.file("a.vtu"));
    GridSample flat;
    flat.dims = {9, 8, 1};
    writeGridFile(folder.file("flat.vti"), flat);
    for (const char* file : {"a.vtu", "flat.vti"}) {
        const SceneSizes sizes = sizesOf(describe("boundary", folder.file(file), "p"), {});
        EXPECT_FALSE(sizes.field || sizes.scalarField || sizes.surface) << file;
    }
    writeGridFile(folder.file("a.vti"));
    writeSheetFile(folder.file("a.vtp"), {});
    EXPECT_TRUE(sizesOf(describe(folder.file("a.vtp"), folder.file("a.vti"), "p"), {}).scalarField);
    EXPECT_FALSE(sizesOf(describe(folder.file("a.vtp"), folder.file("a.vti"), "surface:p"), {}).scalarField);
}

std::vector<SceneSizes> shownBy(const SceneDescription& description, const FieldPart& part = {})
{
    std::vector<SceneSizes> steps;
    forEachStepShown(description, part, [&](const SceneSizes& sizes) { steps.push_back(sizes); });
    return steps;
}

/// Steps of 4, 5, 6 and 7 samples along x, at the moments 0 to 3.
class SceneSizesOfSteps : public testing::Test {
protected:
    void SetUp() override
    {
        for (int i = 0; i < 4; ++i) {
            GridSample grid;
            grid.dims[0] = 4 + i;
            writeGridFile(folder_.file("f_" + std::to_string(i) + ".vti"), grid);
        }
    }
    SceneDescription animated(double from, double to, int frames) const
    {
        SceneDescription description = describe("sphere:200", folder_.file("f_*.vti"));
        description.time.range = {from, to};
        description.output.frames = frames;
        return description;
    }
    static std::vector<std::int64_t> widths(const std::vector<SceneSizes>& steps)
    {
        std::vector<std::int64_t> all;
        for (const SceneSizes& sizes : steps) all.push_back(sizes.field->dims[0]);
        return all;
    }

    const TempFolder folder_;
};

TEST_F(SceneSizesOfSteps, OnesThatFramesShowEachOnce)
{
    using Widths = std::vector<std::int64_t>;
    EXPECT_EQ(widths(shownBy(animated(0, 3, 100))), (Widths{4, 5, 6, 7}));
    EXPECT_EQ(widths(shownBy(animated(3, 0, 4))), (Widths{7, 6, 5, 4}));
    EXPECT_EQ(widths(shownBy(animated(0.5, 2.5, 3))), (Widths{4, 5, 6})) << "on different grids the earlier is shown";
    EXPECT_EQ(widths(shownBy(animated(0, 3, 2))), (Widths{4, 7})) << "what lies between is not shown";
    EXPECT_EQ(widths(shownBy(animated(-9, 9, 2))), (Widths{4, 7}));
    SceneDescription still = describe("sphere:200", folder_.file("f_*.vti"));
    EXPECT_EQ(widths(shownBy(still)), Widths{4});
    still.time.moment = 2;
    EXPECT_EQ(widths(shownBy(still)), Widths{6});
    EXPECT_EQ(sizesOf(still, {}).field->dims[0], 6);
    EXPECT_EQ(shownBy(animated(0, 3, 100), {1, 3}).back().field->brick,
              sizesOf(animated(3, 0, 4), {1, 3}).field->brick);
}

TEST_F(SceneSizesOfSteps, SurfacesWithTheFieldOfTheirMoment)
{
    SheetSample sheet;
    sheet.cells = SheetSample::Cells::triangles;
    writeSheetFile(folder_.file("s_0.vtp"), sheet);
    sheet.n = 8;
    writeSheetFile(folder_.file("s_1.vtp"), sheet);
    SceneDescription description = animated(0, 1, 2);
    description.surface.spec = folder_.file("s_*.vtp");
    const std::vector<SceneSizes> steps = shownBy(description);
    EXPECT_EQ(widths(steps), (std::vector<std::int64_t>{4, 5}));
    ASSERT_EQ(steps.size(), 2u);
    EXPECT_EQ(steps[0].surface->triangles, 32u);
    EXPECT_EQ(steps[1].surface->triangles, 128u);
}

TEST_F(SceneSizesOfSteps, TheOnesBeforeADamagedHeaderAreTold)
{
    std::ofstream(folder_.file("f_2.vti")) << "no header";
    std::vector<SceneSizes> steps;
    EXPECT_THROW(forEachStepShown(animated(0, 3, 4), {}, [&](const SceneSizes& sizes) { steps.push_back(sizes); }),
                 InputError);
    EXPECT_EQ(widths(steps), (std::vector<std::int64_t>{4, 5}));
}

/// A terabyte that is not there: who read it would be found out.
TEST(SceneSizes, NothingButTheHeaderIsRead)
{
    const TempFolder folder;
    testkit::writeSparseGrid(folder.file("large.vti"), {4096, 4096, 4096});
    const SceneSizes sizes = sizesOf(describe("boundary", folder.file("large.vti")), {});
    ASSERT_TRUE(sizes.field);
    EXPECT_EQ(sizes.field->bytes(), std::uint64_t(12) << 36);
    EXPECT_THROW(sizesOf(describe("boundary", folder.file("none.vti")), {}), InputError);
}

}  // namespace
}  // namespace aeolic
