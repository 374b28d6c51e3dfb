#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "data/scene.h"
#include "memory_testing.h"
#include "ranks/thread_communicator.h"

/// Scenes from the caller's memory draw what files with the same contents draw.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

class MemoryTest : public testing::Test {
protected:
    MemoryTest()
    {
        scene_.lic.steps = 12;
        scene_.output.width = 90;
        scene_.output.height = 70;
        scene_.run.backend = BackendChoice::cpu;
        scene_.camera.elevationDeg = 60;
    }
    std::string sheetFile(const SheetSample& sample = {}) const
    {
        writeSheetFile(folder_.file("sheet.vtp"), sample);
        return folder_.file("sheet.vtp");
    }
    std::string gridFile(const GridSample& sample = {}) const
    {
        writeGridFile(folder_.file("grid.vti"), sample);
        return folder_.file("grid.vti");
    }
    Picture ofFiles(SceneDescription scene, const std::string& surface, const std::string& field = "") const
    {
        if (!surface.empty()) scene.surface.spec = surface;
        scene.field.spec = field;
        return Renderer(scene).render(scene.camera);
    }
    static Picture ofMemory(const SceneDescription& scene, const Data& data)
    {
        return Renderer(scene, data).render(scene.camera);
    }
    std::string complaint(const Data& data) const
    {
        try {
            const Renderer renderer(scene_, data);
        } catch (const InputError& error) {
            return error.what();
        }
        return "taken";
    }

    SceneDescription scene_;
    TempFolder folder_;
};

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
                scene.surface.featureAngleDeg = angle;
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
        if (i % 3 == 2) padded.push_back(nan);
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
    for (const std::size_t i : {100u, 101u}) grid.u[3 * i + 1] = nan;
    grid.u[3 * 200 + 2] = std::numeric_limits<float>::infinity();
    scene_.surface.spec = "slice:0,0,1:0,0,1";
    const std::string file = gridFile(sample);
    for (const FieldPrecision precision : {FieldPrecision::float32, FieldPrecision::float16}) {
        scene_.field.precision = precision;
        const std::vector<float> before = grid.u;
        Renderer renderer(scene_, Data{{}, grid.grid()});
        EXPECT_EQ(renderer.render(scene_.camera).pixels, ofFiles(scene_, "", file).pixels);
        EXPECT_EQ(std::memcmp(grid.u.data(), before.data(), 4 * before.size()), 0);
        EXPECT_EQ(renderer.info().warnings.size(), 1u);
    }
    MemorySheet sheet(4);
    sheet.tau[7] = -std::numeric_limits<float>::infinity();
    sheet.points[3] = nan;
    const std::vector<float> before = sheet.tau;
    scene_.field.vectors = "tau";
    const Renderer renderer(scene_, Data{sheet.surface(), {}});
    EXPECT_EQ(sheet.tau, before);
    EXPECT_EQ(renderer.info().warnings.size(), 2u) << "cells with a corner that is nowhere, and a masked vector";
}

TEST_F(MemoryTest, GridOfFloatsIsSampledWhereItIs)
{
    const MemoryGrid grid;
    scene_.surface.spec = "slice:0,0,1:0,0,1";
    scene_.shading.colorBy = "p";
    const Renderer renderer(scene_, Data{{}, grid.grid()});
    EXPECT_EQ(renderer.scene().field->samples.get(), grid.u.data());
    EXPECT_EQ(renderer.scene().scalarField->samples.get(), grid.p.data());

    GridSample large;  // More than a cache holds: a file's samples would be put in another order.
    large.dims = {150, 150, 150};
    const MemoryGrid much(large);
    const std::vector<float> before = much.u;
    const Renderer other(scene_, Data{{}, much.grid()});
    EXPECT_EQ(other.scene().field->samples.get(), much.u.data());
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
        const Picture first = renderer.render(scene_.camera);
        const MemoryGrid other(sample);
        renderer.setData({{}, other.grid()});
        EXPECT_EQ(ofGrid.use_count(), 1);
        EXPECT_EQ(renderer.render(scene_.camera).pixels, first.pixels);
        renderer.setData(owned());
        EXPECT_EQ(ofSurface.use_count(), 1);
        EXPECT_GT(ofGrid.use_count(), 1);
    }
    EXPECT_EQ(ofGrid.use_count(), 1);
}

TEST_F(MemoryTest, WrongSurfacesGetAFilesWords)
{
    const MemorySheet sheet(4);
    const auto changed = [&](const auto& change) {
        Surface surface = sheet.surface();
        change(surface);
        return complaint({surface, {}});
    };
    scene_.field.vectors = "tau";
    EXPECT_EQ(complaint({Surface{}, {}}), "surface in memory: no array 'tau'; expected one of: none");
    EXPECT_EQ(changed([](Surface& s) { s.pointArrays[0].values.count = 7; }),
              "surface in memory: array 'tau' has 7 values; expected 25, one for each of the points");
    EXPECT_EQ(changed([](Surface& s) { s.cellArrays[0].values.count = 7; }),
              "surface in memory: array 'cellTau' has 7 values; expected 16, one for each of the cells");
    EXPECT_EQ(changed([](Surface& s) { s.points.count = 24; }),
              "surface in memory: a cell refers to a point that does not exist; expected indices below the number of "
              "points");
    EXPECT_EQ(changed([](Surface& s) { s.points.components = 2; }),
              "surface in memory: points: 2 components; expected 3");
    EXPECT_EQ(changed([](Surface& s) { s.points.data = nullptr; }),
              "surface in memory: points: a null pointer; expected values");
    EXPECT_EQ(changed([](Surface& s) { s.points.type = ValueType::int32; }),
              "surface in memory: points: whole numbers; expected float or double");
    EXPECT_EQ(changed([](Surface& s) { s.points.strideBytes = 8; }),
              "surface in memory: points: tuples 8 bytes apart; expected at least 12, what a tuple takes");
    EXPECT_EQ(changed([](Surface& s) { s.connectivity.type = ValueType::float64; }),
              "surface in memory: connectivity: indices that are no int32, uint32 or int64; expected whole numbers");
    EXPECT_EQ(changed([](Surface& s) { s.offsets.count = 16; }),
              "surface in memory: offsets: they do not rise from 0 to the number of indices; expected where each "
              "polygon begins, and 64 at the end");
    EXPECT_EQ(changed([](Surface& s) { s.triangles = ArrayView(static_cast<const std::int32_t*>(nullptr), 4, 3); }),
              "surface in memory: triangles and polygons; expected one or the other");
    EXPECT_EQ(changed([](Surface& s) { s.pointArrays[1].name = "tau"; }),
              "surface in memory: array 'tau' is given twice; expected each name once");
    EXPECT_EQ(changed([](Surface& s) { s.offsets = s.connectivity = {}, s.cellArrays.clear(); }),
              "surface in memory: 25 points, 0 lines and no polygons; expected a surface of at least one triangle");
    scene_.field.vectors = "tua";
    EXPECT_EQ(
        complaint({sheet.surface(), {}}),
        "surface in memory: no array 'tua'; expected one of: tau (points, 3 components), q (points, 1 component), "
        "cellTau (cells, 3 components), cellQ (cells, 1 component); did you mean tau?");
    scene_.field.vectors = "tau";
    scene_.shading.colorBy = "heat";
    EXPECT_EQ(complaint({sheet.surface(), {}}).substr(0, 55),
              "surface in memory: no array 'heat' to colour by; expect");
    MemorySheet nowhere(2);
    for (float& c : nowhere.points) c = nan;
    scene_.shading.colorBy = "";
    EXPECT_EQ(complaint({nowhere.surface(), {}}),
              "surface in memory: all 4 cells have a corner that is not finite; expected finite coordinates");
}

TEST_F(MemoryTest, WrongGridsGetAFilesWords)
{
    const MemoryGrid grid;
    const auto changed = [&](const auto& change) {
        Grid other = grid.grid();
        change(other);
        return complaint({{}, other});
    };
    EXPECT_EQ(changed([](Grid& g) {
                  g.dims = {0, 0, 0}, g.pointArrays.clear();
              }),
              "grid in memory: 0 points and 0 cells; expected a grid with cells");
    EXPECT_EQ(changed([](Grid& g) { g.dims[0] = 8; }),
              "grid in memory: array 'U' has 504 values; expected 448, one for each of the points");
    EXPECT_EQ(changed([](Grid& g) { g.dims[0] = -9; }),
              "grid in memory: -9 x 8 x 7 samples; expected how many there are in x, y and z");
    EXPECT_EQ(changed([](Grid& g) { g.spacing[1] = 0; }),
              "grid in memory: its spacing is 0.25,0,0.25; expected positive numbers");
    EXPECT_EQ(changed([](Grid& g) { g.pointArrays.erase(g.pointArrays.begin()); }),
              "grid in memory: no array of vectors; expected an array of 3 components; there are: p (points, 1 "
              "component)");
    EXPECT_EQ(changed([](Grid& g) {
                  g.origin = {100, 0, 0};
              }).substr(0, 61),
              "grid in memory: the field, from 100,0,0 to 102,1.75,1.5, does");
}

TEST_F(MemoryTest, NewDataAreDrawnAsTheNextStepOfASeriesIs)
{
    SheetSample first, second;
    second.twist = 0.2;
    writeSheetFile(folder_.file("s_0.vtp"), first);
    writeSheetFile(folder_.file("s_1.vtp"), second);
    scene_.field.vectors = "tau";
    scene_.shading.colorBy = "q";
    SceneDescription series = scene_;
    series.surface.spec = folder_.file("s_%d.vtp");
    Renderer files(series);
    const MemorySheet flat(4), bent(4, 0.2);
    Renderer memory(scene_, Data{flat.surface(), {}});
    const Picture before = memory.render(scene_.camera);
    EXPECT_EQ(before.pixels, files.render(scene_.camera).pixels);
    files.setTime(1);
    memory.setData({bent.surface(), {}});
    const Picture after = memory.render(scene_.camera);
    EXPECT_EQ(after.pixels, files.render(scene_.camera).pixels);
    EXPECT_NE(after.pixels, before.pixels);

    const MemorySheet finer(6);  // Other triangles, too.
    memory.setData({finer.surface(), {}});
    EXPECT_EQ(memory.info().triangles, 72u);
    Surface wrong = flat.surface();
    wrong.pointArrays.erase(wrong.pointArrays.begin() + 1);
    EXPECT_THROW(memory.setData({wrong, {}}), InputError) << "no array to colour by";
    EXPECT_EQ(memory.info().triangles, 72u);
    EXPECT_THROW(memory.setData({{}, MemoryGrid().grid()}), InputError) << "it was made without a grid";
    memory.setData({flat.surface(), {}});
    EXPECT_EQ(memory.render(scene_.camera).pixels, before.pixels);
}

TEST_F(MemoryTest, NewGridsCutOtherSurfaces)
{
    scene_.surface.spec = "isosurface:p=90";
    GridSample shifted;
    shifted.origin[2] += 0.1;
    shifted.dims[0] = 8;
    const MemoryGrid first, second(shifted);
    writeGridFile(folder_.file("g_0.vti"), {});
    writeGridFile(folder_.file("g_1.vti"), shifted);
    SceneDescription series = scene_;
    series.field.spec = folder_.file("g_%d.vti");
    Renderer files(series), memory(scene_, Data{{}, first.grid()});
    files.setTime(1);
    memory.setData({{}, second.grid()});
    EXPECT_EQ(memory.render(scene_.camera).pixels, files.render(scene_.camera).pixels);
    EXPECT_EQ(memory.scene().field->samples.get(), second.u.data());
}

TEST_F(MemoryTest, EveryRankGivesItsPiece)
{
    scene_.shading.colorBy = "q";
    scene_.field.vectors = "tau";
    scene_.run.threads = 1;
    const MemorySheet whole(8, 0.2);
    // The pieces' points at common borders are others than the whole's: normals there are those of each piece's cells.
    scene_.surface.featureAngleDeg = 0;
    Renderer alone(scene_, Data{whole.surface(), {}});
    const Picture expected = alone.render(scene_.camera);
    alone.setData({MemorySheet(8, 0.1).surface(), {}});
    const Picture next = alone.render(scene_.camera);
    const int cut[5] = {0, 3, 3, 7, 8};  // The second rank has none.
    runRanks(4, [&](Communicator& communicator) {
        const int rank = communicator.rank();
        const auto piece = [&](double twist) { return MemorySheet(8, twist, cut[rank], cut[rank + 1]); };
        const MemorySheet mine = piece(0.2), later = piece(0.1);
        Renderer renderer(scene_, Data{mine.surface(), {}},
                          std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
        const Picture picture = renderer.render(scene_.camera);
        EXPECT_EQ(renderer.info().triangles, 128u);
        renderer.setData({later.surface(), {}});
        const Picture moved = renderer.render(scene_.camera);
        if (rank != 0) return;
        EXPECT_EQ(picture.pixels, expected.pixels);
        EXPECT_EQ(moved.pixels, next.pixels);
    });
}

TEST_F(MemoryTest, RanksMustGiveTheSameArrays)
{
    scene_.field.vectors = "tau";
    const auto complaintOn = [&](const auto& change) {
        std::string said;
        runRanks(2, [&](Communicator& communicator) {
            const MemorySheet sheet(4, 0, 2 * communicator.rank(), 2 * communicator.rank() + 2);
            Data data{sheet.surface(), {}};
            if (communicator.rank() == 1) change(data);
            try {
                Renderer renderer(scene_, data, std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
            } catch (const InputError& error) {
                if (communicator.rank() == 0) said = error.what();
            }
        });
        return said;
    };
    EXPECT_EQ(complaintOn([](Data&) {}), "");
    EXPECT_NE(complaintOn([](Data& data) { data.surface->pointArrays.pop_back(); }).find("the data in memory"),
              std::string::npos);
    EXPECT_NE(complaintOn([](Data& data) { data.surface->points.count = 3; }).find("does not exist"),
              std::string::npos);
}

}  // namespace
}  // namespace aeolic
