#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "data/scene.h"
#include "engine/renderer_internals.h"
#include "memory_scenes_testing.h"
#include "ranks/thread_communicator.h"

/// Cells in the caller's memory draw what a .vtu with the same contents draws.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

class MemoryVolumeTest : public MemoryTest {
protected:
    MemoryVolumeTest()
    {
        scene_.field.vectors = "U";
        scene_.surface.spec = "boundary";
    }
    std::string write(const MemoryVolume& cells, const char* name = "cells.vtu") const
    {
        cells.write(folder_.file(name));
        return folder_.file(name);
    }

    MemoryVolume cells_;
};

TEST_F(MemoryVolumeTest, DrawsWhatAFileDraws)
{
    const std::string file = write(cells_), sheet = sheetFile();
    std::vector<std::vector<std::uint8_t>> pictures;
    for (const std::string& surface : {std::string("slice:0.3,0,0.1:0,0.3,1"), std::string("isosurface:p=30"),
                                       std::string("boundary"), std::string("sphere"), sheet})
        for (const char* colorBy : {"", "field:p", "field:U:mag", "field:cellP"}) {
            SceneDescription scene = scene_;
            scene.surface.spec = surface;
            scene.shading.colorBy = colorBy;
            const Picture picture = ofMemory(scene, dataOf(cells_.volume()));
            EXPECT_EQ(picture.pixels, ofFiles(scene, "", file).pixels) << surface << " " << colorBy;
            EXPECT_EQ(std::count(pictures.begin(), pictures.end(), picture.pixels), 0) << surface << " " << colorBy;
            pictures.push_back(picture.pixels);
        }
}

TEST_F(MemoryVolumeTest, OptionsOfFieldsWorkAsWithFiles)
{
    const std::string file = write(cells_), sheet = sheetFile();
    const auto expectSame = [&](const char* what, const auto& change) {
        SceneDescription scene = scene_;
        scene.surface.spec = sheet;
        const Picture plain = ofMemory(scene, dataOf(cells_.volume()));
        change(scene);
        const Picture picture = ofMemory(scene, dataOf(cells_.volume()));
        EXPECT_EQ(picture.pixels, ofFiles(scene, "", file).pixels) << what;
        EXPECT_NE(picture.pixels, plain.pixels) << what;
    };
    expectSame("vectors on cells", [](SceneDescription& scene) { scene.field.vectors = "cellU"; });
    expectSame("resampled",
               [](SceneDescription& scene) { scene.field.resampleSpacing = 0.3, scene.shading.colorBy = "field:p"; });
    expectSame("offset", [](SceneDescription& scene) { scene.field.offset = 0.15; });
    expectSame("halves", [](SceneDescription& scene) {
        scene.field.precision = FieldPrecision::float16, scene.field.resampleSpacing = 0.3;
    });
}

TEST_F(MemoryVolumeTest, IsLookedUpInItsOwnCells)
{
    scene_.surface.spec = "sphere";
    const Renderer renderer(scene_, dataOf(cells_.volume()));
    EXPECT_FALSE(RendererInternals::scene(renderer).field) << "no grid was made of it";
}

TEST_F(MemoryVolumeTest, ArraysMayHaveOtherTypesAndGaps)
{
    const Picture expected = ofMemory(scene_, dataOf(cells_.volume()));
    const auto count = std::int64_t(cells_.p.size()), cellCount = std::int64_t(cells_.types.size());
    const std::vector<double> points(cells_.points.begin(), cells_.points.end());
    const std::vector<std::int32_t> types(cells_.types.begin(), cells_.types.end()),
        corners(cells_.corners.begin(), cells_.corners.end()), faces(cells_.faces.begin(), cells_.faces.end());
    const std::vector<std::uint32_t> offsets(cells_.offsets.begin(), cells_.offsets.end());
    std::vector<std::int64_t> locations;  // Every second.
    for (const std::int64_t at : cells_.faceLocations) locations.insert(locations.end(), {at, 7});
    std::vector<double> padded;
    for (std::size_t i = 0; i < cells_.u.size(); ++i) {
        padded.push_back(double(cells_.u[i]));
        if (i % 3 == 2) padded.push_back(double(kNan));
    }
    Volume other = cells_.volume();
    other.points = ArrayView(points.data(), count, 3);
    other.types = ArrayView(types.data(), cellCount);
    other.offsets = ArrayView(offsets.data(), cellCount + 1);
    other.connectivity = ArrayView(corners.data(), std::int64_t(corners.size()));
    other.faces = ArrayView(faces.data(), std::int64_t(faces.size()));
    other.faceLocations = ArrayView(locations.data(), cellCount, 1, 16);
    other.pointArrays[0].values = ArrayView(padded.data(), count, 3, 32);
    EXPECT_EQ(ofMemory(scene_, dataOf(other)).pixels, expected.pixels);
}

TEST_F(MemoryVolumeTest, ItsMemoryIsNeitherKeptNorWritten)
{
    cells_.u[10] = kNan;  // Is masked: nobody may write into the caller's array for that.
    const MemoryVolume before = cells_;
    Renderer renderer(scene_, dataOf(cells_.volume()));
    EXPECT_EQ(cells_.points, before.points);
    EXPECT_EQ(cells_.corners, before.corners);
    EXPECT_TRUE(std::equal(cells_.u.begin(), cells_.u.end(), before.u.begin(),
                           [](float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }));
    const Picture picture = renderer.render({scene_.camera});
    std::fill(cells_.u.begin(), cells_.u.end(), kNan);
    std::fill(cells_.points.begin(), cells_.points.end(), kNan);
    std::fill(cells_.corners.begin(), cells_.corners.end(), -1);
    EXPECT_EQ(renderer.render({scene_.camera}).pixels, picture.pixels);
    EXPECT_EQ(picture.pixels, ofFiles(scene_, "", write(before)).pixels);
}

TEST_F(MemoryVolumeTest, NewDataAreDrawnAsTheNextStepOfASeriesIs)
{
    const MemoryVolume other(0.12, 0.7);
    write(cells_, "v_0.vtu");
    write(other, "v_1.vtu");
    for (const char* surface : {"boundary", "isosurface:p=30", "sphere"}) {
        scene_.surface.spec = surface;
        scene_.shading.colorBy = "p";
        SceneDescription series = scene_;
        series.field.spec = folder_.file("v_%d.vtu");
        Renderer files(series), memory(scene_, dataOf(cells_.volume()));
        const Picture before = memory.render({scene_.camera});
        EXPECT_EQ(before.pixels, files.render({scene_.camera}).pixels) << surface;
        files.setTime(1);
        memory.setData(dataOf(other.volume()));
        const Picture after = memory.render({scene_.camera});
        EXPECT_EQ(after.pixels, files.render({scene_.camera}).pixels) << surface;
        EXPECT_NE(after.pixels, before.pixels) << surface;

        Volume wrong = other.volume();
        wrong.pointArrays.pop_back();
        EXPECT_THROW(memory.setData(dataOf(wrong)), InputError) << "no array to colour by";
        EXPECT_THROW(memory.setData({{}, MemoryGrid().grid()}), InputError) << "it was made without a grid";
        EXPECT_EQ(memory.render({scene_.camera}).pixels, after.pixels) << "what fails changes nothing";
        memory.setData(dataOf(cells_.volume()));
        EXPECT_EQ(memory.render({scene_.camera}).pixels, before.pixels) << surface;
    }
}

TEST_F(MemoryVolumeTest, EitherMayBeReplaced)
{
    const MemorySheet flat(4), finer(6);  // Of the same size: the camera fits the first surface.
    const MemoryVolume other(0.12, 2);
    scene_.shading.colorBy = "field:p";
    scene_.shading.colorRange = {0, 50};
    const auto both = [](const MemorySheet& sheet, const MemoryVolume& cells) {
        return Data{sheet.surface(), {}, cells.volume()};
    };
    Renderer renderer(scene_, both(flat, cells_));
    const auto expect = [&](const MemorySheet& sheet, const MemoryVolume& cells, const char* what) {
        EXPECT_EQ(renderer.render({scene_.camera}).pixels, ofMemory(scene_, both(sheet, cells)).pixels) << what;
    };
    renderer.setData(dataOf(other.volume()));
    expect(flat, other, "other cells");
    renderer.setData({finer.surface(), {}});
    expect(finer, other, "another surface, with the other cells");
    renderer.setData(both(flat, cells_));
    expect(flat, cells_, "both");
}

TEST_F(MemoryVolumeTest, EveryRankGivesTheWhole)
{
    scene_.run.threads = 1;
    const Picture expected = ofMemory(scene_, dataOf(cells_.volume()));
    runRanks(3, [&](Communicator& communicator) {
        Renderer renderer(scene_, dataOf(cells_.volume()),
                          std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
        const Picture picture = renderer.render({scene_.camera});
        if (communicator.rank() != 0) return;
        EXPECT_EQ(picture.pixels, expected.pixels);
    });
}

TEST_F(MemoryVolumeTest, WhatIsWrongGetsAFilesWords)
{
    const auto changed = [&](const auto& change) {
        Volume other = cells_.volume();
        change(other);
        return complaint(dataOf(other));
    };
    const std::string here = "volume in memory: ";
    EXPECT_EQ(changed([](Volume&) {}), "taken");
    EXPECT_EQ(changed([](Volume& v) { v = {}; }), here + "0 points and 0 cells; expected a grid with cells");
    EXPECT_EQ(changed([](Volume& v) { v.points.count = 100; }),
              here + "cell 93 refers to point 100, which does not exist; expected points from 0 to 99");
    EXPECT_EQ(changed([](Volume& v) { v.points.components = 2; }), here + "points: 2 components; expected 3");
    EXPECT_EQ(changed([](Volume& v) { v.points = v.types; }), here + "points: whole numbers; expected float or double");
    EXPECT_EQ(changed([](Volume& v) { --v.types.count; }),
              here + "types: 131 values; expected 132, one for each of the cells");
    EXPECT_EQ(changed([](Volume& v) { v.types = v.pointArrays[1].values, v.types.count = 132; }),
              here + "types: indices that are not int32, uint32 or int64; expected whole numbers");
    EXPECT_EQ(changed([](Volume& v) { v.connectivity = {}; }),
              here + "connectivity: it is empty; expected 717 indices, as the offsets say");
    EXPECT_EQ(changed([](Volume& v) { --v.offsets.count; }),
              here +
                  "offsets: they do not rise from 0 to the number of indices; expected where each cell begins, and "
                  "717 at the end");
    EXPECT_EQ(changed([](Volume& v) { --v.faceLocations.count; }),
              here + "faceLocations: 131 values; expected 132, one for each of the cells");
    const auto expectFaces = [&](const std::string& said) {
        EXPECT_EQ(said.substr(0, 23), here + "cell ");
        EXPECT_NE(said.find(" is a polyhedron without sound faces; expected faces of points"), std::string::npos)
            << said;
    };
    expectFaces(changed([](Volume& v) { v.faces = v.faceLocations = {}; }));
    expectFaces(changed([](Volume& v) { v.faces.count -= 3; }));
    expectFaces(changed([](Volume& v) { v.faces = {}; }));
    for (const std::int64_t wrong : {std::int64_t{-1}, std::int64_t{0}, std::int64_t{1} << 40}) {
        std::vector<std::int64_t> faces = cells_.faces;
        faces[0] = wrong;  // How many faces the first has.
        expectFaces(changed([&](Volume& v) { v.faces.data = faces.data(); }));
        faces = cells_.faces;
        faces[1] = wrong;  // How many corners its first face has.
        expectFaces(changed([&](Volume& v) { v.faces.data = faces.data(); }));
        faces = cells_.faces;
        faces[2] = wrong == 0 ? 120 : wrong;  // Its first corner.
        expectFaces(changed([&](Volume& v) { v.faces.data = faces.data(); }));
        std::vector<std::int64_t> places = cells_.faceLocations;
        *std::find(places.begin(), places.end(), 0) = wrong == 0 ? 3 : wrong;
        expectFaces(changed([&](Volume& v) { v.faceLocations.data = places.data(); }));
    }
    EXPECT_EQ(changed([](Volume& v) { --v.pointArrays[0].values.count; }),
              here + "array 'U' has 119 values; expected 120, one for each of the points");
    EXPECT_EQ(changed([](Volume& v) { ++v.cellArrays[1].values.count; }),
              here + "array 'cellP' has 133 values; expected 132, one for each of the cells");
    EXPECT_EQ(changed([](Volume& v) { v.points.data = nullptr; }), here + "points: a null pointer; expected values");

    std::vector<std::int64_t> elsewhere = cells_.corners;
    const auto withCorner = [&](std::int64_t corner) {
        elsewhere[5] = corner;
        return changed([&](Volume& v) { v.connectivity.data = elsewhere.data(); });
    };
    for (const std::int64_t corner : {std::int64_t{-1}, std::int64_t{120}, std::int64_t{1} << 40})
        EXPECT_EQ(withCorner(corner),
                  here + fmt::format("cell 0 refers to point {}, which does not exist; expected points "
                                     "from 0 to 119",
                                     corner));
    std::vector<std::int32_t> types(cells_.types.begin(), cells_.types.end());
    const auto withType = [&](std::int32_t type) {
        types[0] = type;
        return changed([&](Volume& v) { v.types = ArrayView(types.data(), 132); });
    };
    EXPECT_EQ(withType(10), here + "cell 0 of type 10 has 8 corners; expected 4");
    for (const std::int32_t type : {-1, 99, 255, 268, 1000})
        EXPECT_EQ(withType(type), here + "cell 0 has the type " + std::to_string(type) +
                                      "; expected a linear or quadratic cell of VTK");
    const std::vector<std::uint8_t> flat(132, 7);  // Polygons.
    EXPECT_EQ(changed([&](Volume& v) { v.types.data = flat.data(); }), "taken") << "a boundary may be flat";
    scene_.surface.spec = "sphere";
    EXPECT_NE(changed([&](Volume& v) { v.types.data = flat.data(); }), "taken");
    std::vector<float> nowhere(cells_.points.size(), kNan);
    EXPECT_NE(changed([&](Volume& v) { v.points.data = nowhere.data(); }), "taken");
    EXPECT_EQ(complaint(Data{{}, MemoryGrid().grid(), cells_.volume()}),
              "data in memory: found a grid and a volume; expected one or the other");
}

}  // namespace
}  // namespace aeolic
