#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "data/scene.h"
#include "engine/renderer_internals.h"
#include "memory_scenes_testing.h"

/// Scenes from the caller's memory draw what files with the same contents draw.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

TEST_F(MemoryTest, SurfaceDrawsWhatAFileDraws)
{
    SheetSample sample;
    sample.twist = 0.3;
    const std::string file = sheetFile(sample);
    const MemorySheet sheet(4, 0.3);
    for (const char* vectors : {"tau", "cellTau"})
        for (const char* colorBy : {"", "q", "cellQ", "tau:mag", "cellTau:mag"})
            for (const double angle : {0.0, 20.0, 180.0}) {
                SceneDescription scene = scene_;
                scene.field.vectors = vectors;
                scene.shading.colorBy = colorBy;
                scene.surface.featureAngle = angle;
                const Picture memory = ofMemory(scene, Data{sheet.surface(), {}});
                EXPECT_EQ(memory.pixels, ofFiles(scene, file).pixels) << vectors << " " << colorBy << " " << angle;
            }
}

TEST_F(MemoryTest, SurfaceMayHaveOtherTypesGapsAndTriangles)
{
    scene_.field.vectors = "tau";
    const MemorySheet sheet(4);
    const Picture expected = ofMemory(scene_, Data{sheet.surface(), {}});
    const std::vector<double> doubles(sheet.points.begin(), sheet.points.end());
    std::vector<float> padded;  // Four floats a vector.
    for (std::size_t i = 0; i < sheet.tau.size(); ++i) {
        padded.push_back(sheet.tau[i]);
        if (i % 3 == 2) padded.push_back(kNan);
    }
    Surface other = sheet.surface();
    other.points = ArrayView(doubles.data(), std::int64_t(doubles.size() / 3), 3);
    other.pointArrays[0].values = ArrayView(padded.data(), std::int64_t(padded.size() / 4), 3, 16);
    const std::vector<std::int32_t> corners(sheet.corners.begin(), sheet.corners.end());
    const std::vector<std::uint32_t> offsets(sheet.offsets.begin(), sheet.offsets.end());
    other.connectivity = ArrayView(corners.data(), std::int64_t(corners.size()));
    other.offsets = ArrayView(offsets.data(), std::int64_t(offsets.size()));
    EXPECT_EQ(ofMemory(scene_, Data{other, {}}).pixels, expected.pixels);

    std::vector<std::uint32_t> triangles;  // VTK cuts these flat quads from their second corner to their last.
    for (std::size_t quad = 0; quad < sheet.corners.size(); quad += 4)
        for (const std::size_t k : {0u, 1u, 2u, 0u, 2u, 3u})
            triangles.push_back(std::uint32_t(sheet.corners[quad + k]));
    const std::vector<std::int64_t> wide(triangles.begin(), triangles.end());
    const std::vector<std::int32_t> narrow(triangles.begin(), triangles.end());
    const auto count = std::int64_t(triangles.size() / 3);
    std::vector<Picture> pictures;
    for (const ArrayView& view : {ArrayView(triangles.data(), count, 3), ArrayView(wide.data(), count, 3),
                                  ArrayView(narrow.data(), count, 3)}) {
        Surface surface = sheet.surface();
        surface.offsets = surface.connectivity = {};
        surface.cellArrays.clear();
        surface.triangles = view;
        pictures.push_back(ofMemory(scene_, Data{surface, {}}));
    }
    EXPECT_EQ(pictures[1].pixels, pictures[0].pixels);
    EXPECT_EQ(pictures[2].pixels, pictures[0].pixels);
    EXPECT_NE(pictures[0].pixels, std::vector<std::uint8_t>(pictures[0].pixels.size(), 255));
}

TEST_F(MemoryTest, GridDrawsWhatAFileDraws)
{
    const std::string file = gridFile();
    const MemoryGrid grid;
    for (const char* surface : {"slice:0,0,1:0,0.3,1", "isosurface:p=90", "isosurface:U:mag=2", "boundary", "sphere"})
        for (const char* colorBy : {"", "p", "U:mag"})
            for (const FieldPrecision precision : {FieldPrecision::float32, FieldPrecision::float16}) {
                SceneDescription scene = scene_;
                scene.shading.colorBy = colorBy;
                scene.field.precision = precision;
                scene.surface.spec = surface;
                EXPECT_EQ(ofMemory(scene, Data{{}, grid.grid()}).pixels, ofFiles(scene, "", file).pixels)
                    << surface << " " << colorBy << " " << int(precision);
            }
}

TEST_F(MemoryTest, SurfaceAndGridGoTogether)
{
    GridSample sample;
    sample.origin = {-1, -1, -1};
    const MemoryGrid grid(sample);
    scene_.shading.colorBy = "p";
    const Picture expected = ofFiles(scene_, sheetFile(), gridFile(sample));
    EXPECT_EQ(ofMemory(scene_, Data{MemorySheet(4).surface(), grid.grid()}).pixels, expected.pixels);
    scene_.field.spec = gridFile(sample);
    EXPECT_EQ(ofMemory(scene_, Data{MemorySheet(4).surface(), {}}).pixels, expected.pixels);
}

TEST_F(MemoryTest, IsNotWrittenToAndMaskedAsFilesAre)
{
    GridSample sample;
    sample.nanPoints = {100, 101};
    sample.infinitePoints = {200};
    MemoryGrid grid(sample);
    for (const std::size_t i : {100u, 101u}) grid.u[3 * i + 1] = kNan;
    grid.u[3 * 200 + 2] = std::numeric_limits<float>::infinity();
    scene_.surface.spec = "slice:0,0,1:0,0,1";
    const std::string file = gridFile(sample);
    for (const FieldPrecision precision : {FieldPrecision::float32, FieldPrecision::float16}) {
        scene_.field.precision = precision;
        const std::vector<float> before = grid.u;
        Renderer renderer(scene_, Data{{}, grid.grid()});
        EXPECT_EQ(renderer.render({scene_.camera}).pixels, ofFiles(scene_, "", file).pixels);
        EXPECT_EQ(std::memcmp(grid.u.data(), before.data(), 4 * before.size()), 0);
        EXPECT_EQ(renderer.info().warnings.size(), 1u);
    }
    MemorySheet sheet(4);
    sheet.tau[7] = -std::numeric_limits<float>::infinity();
    sheet.points[3] = kNan;
    const std::vector<float> before = sheet.tau;
    scene_.field.vectors = "tau";
    const Renderer renderer(scene_, Data{sheet.surface(), {}});
    EXPECT_EQ(sheet.tau, before);
    EXPECT_EQ(renderer.info().warnings.size(), 2u) << "cells with a corner that is nowhere, and a masked vector";
}

/// Not the triangles that polygons are cut into.
TEST_F(MemoryTest, MaskedCellsAreCountedAsTheyWereGiven)
{
    MemorySheet sheet(4);
    Surface surface = sheet.surface();
    const std::int64_t cells = surface.cellArrays.at(0).values.count;
    std::vector<float> values(std::size_t(cells), 1.0f);
    values[2] = kNan;
    values[5] = std::numeric_limits<float>::infinity();
    surface.cellArrays.push_back({"c", ArrayView(values.data(), cells)});
    scene_.field.vectors = "tau";
    scene_.shading.colorBy = "c";
    scene_.shading.scalarBar = false;  // It has no room.
    const Renderer renderer(scene_, Data{surface, {}});
    EXPECT_EQ(renderer.info().triangles, 2 * std::uint64_t(cells));
    EXPECT_EQ(RendererInternals::scene(renderer).warnings,
              std::vector<std::string>{"surface in memory: array 'c': 2 not finite of " + std::to_string(cells) +
                                       " cells, left blank"});
    EXPECT_TRUE(std::isnan(values[2])) << "it is not written to";
    EXPECT_TRUE(std::isinf(values[5]));
}

TEST_F(MemoryTest, GridOfFloatsIsSampledWhereItIs)
{
    const MemoryGrid grid;
    scene_.surface.spec = "slice:0,0,1:0,0,1";
    scene_.shading.colorBy = "p";
    const Renderer renderer(scene_, Data{{}, grid.grid()});
    EXPECT_EQ(RendererInternals::scene(renderer).field->samples.get(), grid.u.data());
    EXPECT_EQ(RendererInternals::scene(renderer).scalarField->samples.get(), grid.p.data());

    GridSample large;  // More than a cache holds: a file's samples would be put in another order.
    large.dims = {150, 150, 150};
    const MemoryGrid much(large);
    const std::vector<float> before = much.u;
    const Renderer other(scene_, Data{{}, much.grid()});
    EXPECT_EQ(RendererInternals::scene(other).field->samples.get(), much.u.data());
    EXPECT_EQ(much.u, before);
}

TEST_F(MemoryTest, OwnersLetGoWhenTheirMemoryIsNoLongerNeeded)
{
    const auto ofSurface = std::make_shared<MemorySheet>(4);
    GridSample sample;
    sample.origin = {-1, -1, -1};
    const auto ofGrid = std::make_shared<MemoryGrid>(sample);
    const auto owned = [&] {
        Data data{ofSurface->surface(), ofGrid->grid()};
        data.surface->points.owner = ofSurface;
        data.grid->pointArrays[0].values.owner = ofGrid;
        return data;
    };
    {
        Renderer renderer(scene_, owned());
        EXPECT_EQ(ofSurface.use_count(), 1) << "the renderer has its own copy";
        EXPECT_GT(ofGrid.use_count(), 1);
        const Picture first = renderer.render({scene_.camera});
        const MemoryGrid other(sample);
        renderer.setData({{}, other.grid()});
        EXPECT_EQ(ofGrid.use_count(), 1);
        EXPECT_EQ(renderer.render({scene_.camera}).pixels, first.pixels);
        renderer.setData(owned());
        EXPECT_EQ(ofSurface.use_count(), 1);
        EXPECT_GT(ofGrid.use_count(), 1);
    }
    EXPECT_EQ(ofGrid.use_count(), 1);
}

}  // namespace
}  // namespace aeolic
