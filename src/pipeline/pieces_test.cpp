#include <gtest/gtest.h>

#include <mutex>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "cluster/thread_communicator.h"
#include "data/scene.h"
#include "data/vtk/sample_files.h"
#include "pieces_testing.h"
#include "pipeline/unify.h"
#include "same_bytes_testing.h"

/// Ranks that hold different pieces of the surface draw the picture of one that holds all, byte for byte.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

class Pieces : public testing::Test {
protected:
    Case make(const std::string& name, const std::string& surface, const std::string& field, const LicOptions& lic,
              const std::string& colorBy) const
    {
        Case c = makeCase(name, 130, 101, lic);
        c.description.surface.spec = surface;
        c.description.field.spec = field;
        c.description.shading.colorBy = colorBy;
        c.camera.elevationDeg = 35;
        return c;
    }
    Case torus(const LicOptions& lic, const TorusPieces& torus = {}, const std::string& colorBy = "q") const
    {
        return make("torus", writeTorusPieces(folder_.path().string(), "torus", torus), "", lic, colorBy);
    }
    Case winding(const LicOptions& lic, bool masked = false, const std::string& colorBy = "U:mag") const
    {
        writeWindingField(folder_.file("f.vti"), masked);
        return make("isosurface", "isosurface:p=0.1", folder_.file("f.vti"), lic, colorBy);
    }
    void expectSame(const Case& c, const std::vector<int>& ranks, const std::vector<RunOptions>& options,
                    int frames = 2) const
    {
        const std::vector<Tile> alone = draw("cpu", c, {}, 1, frames);
        for (const int n : ranks)
            for (const RunOptions& o : options) expectSameBytes("cpu", c, alone, o, n);
    }
    TempFolder folder_;
};

const RunOptions kHybrid = runOptions("hybrid", "bound", "auto", "on");

TEST_F(Pieces, OfATorusThatCarriesItsVectors)
{
    expectSame(torus(licOf(LicMethod::hierarchical, 40)), {2, 3, 5},
               {kHybrid, runOptions("static", "estimate", "receive", "on"),
                runOptions("pixels", "bound", "project", "on"), runOptions("timing", "bound", "auto", "on")});
}

TEST_F(Pieces, OfAnIsosurfaceInBricks)
{
    expectSame(
        winding(licOf(LicMethod::hierarchical, 40)), {2, 3, 5, 8},
        {kHybrid, runOptions("pixels", "estimate", "receive", "on"), runOptions("static", "bound", "project", "on")});
}

TEST_F(Pieces, DirectlyAndWithVectorsOfAnyLength)
{
    const LicOptions lic = licOf(LicMethod::direct, 30, Kernel::hann, false);
    expectSame(torus(lic), {3}, {kHybrid});
    expectSame(winding(lic, true, "p"), {3}, {kHybrid});
    Case half = winding(lic);
    half.description.field.precision = "half";
    expectSame(half, {3, 8}, {kHybrid});
}

TEST_F(Pieces, OfPiecesThatAreEmptyOrComeAsStrips)
{
    TorusPieces odd;
    odd.empty = {2};
    odd.strips = 1;
    odd.onCells = true;
    odd.noArea = 0;
    expectSame(torus(licOf(LicMethod::hierarchical, 20), odd), {2, 4}, {kHybrid});
}

/// Every rank samples the field on its own piece.
TEST_F(Pieces, InAFieldThatEveryRankHolds)
{
    Case c = torus(licOf(LicMethod::hierarchical, 30), {}, "abc:mag");
    c.description.field.spec = "abc:20,20,20";
    c.split = Split{false, true};
    expectSame(c, {2, 3, 7}, {runOptions("pixels", "bound", "auto")});
    writeWindingField(folder_.file("far.vti"));
    c.description.field.spec = folder_.file("far.vti");
    c.description.shading.colorBy = "";
    const auto complaint = [&](int ranks) {
        std::string found;
        try {
            draw("cpu", c, runOptions("pixels", "bound", "auto"), ranks, 1);
        } catch (const std::exception& error) {
            found = error.what();
        }
        return found.substr(found.find("the field"));
    };
    EXPECT_EQ(complaint(3), complaint(1)) << "with the bounds of all pieces";
}

/// Whoever reads a triangle, it is drawn by those into whose bricks it reaches.
TEST_F(Pieces, InAFieldInBricks)
{
    const std::vector<RunOptions> options{kHybrid, runOptions("static", "estimate", "receive", "on"),
                                          runOptions("pixels", "bound", "project", "on")};
    Case c = torus(licOf(LicMethod::hierarchical, 40), {}, "abc:mag");
    c.description.field.spec = "abc:20,20,20";
    expectSame(c, {2, 3, 5, 8}, options);
    c.description.shading.colorBy = "q";
    expectSame(c, {3, 13}, {kHybrid});
    c = torus(licOf(LicMethod::direct, 30, Kernel::hann, false), {}, "");
    c.description.field.spec = "tornado:9,10,11";
    c.description.field.precision = "half";
    expectSame(c, {5}, {kHybrid});
}

/// Large triangles reach across several bricks, and some are beyond the field, where nothing flows.
TEST_F(Pieces, InAFieldThatTheyReachOutOf)
{
    TorusPieces coarse;
    coarse.pieces = 5;
    coarse.aroundWedge = 1;
    coarse.aroundTube = 3;
    coarse.strips = 1;
    coarse.onCells = true;
    coarse.noArea = 3;
    GridSample small;
    small.dims = {13, 12, 9};
    small.origin = {1000.1, -20.9, 4.3};
    small.spacing = {0.11, 0.12, 0.1};
    small.nanPoints = {600, 601, 602, 620, 700};
    writeGridFile(folder_.file("small.vti"), small);
    for (const char* colorBy : {"q", "p", "U:mag"}) {
        Case c = torus(licOf(LicMethod::hierarchical, 30), coarse, colorBy);
        c.description.field.spec = folder_.file("small.vti");
        c.description.shading.background = "ff00ff";
        expectSame(c, {2, 5, 13}, {kHybrid});
    }
    Case c = torus(licOf(LicMethod::hierarchical, 30));
    c.description.field.spec = folder_.file("small.vti");
    c.camera.position = Vec3{1001.3, -20, 5.02};  // Inside the tube.
    c.camera.focal = Vec3{1001.3, -19, 5};
    expectSame(c, {3, 8}, {kHybrid}, 1);
}

/// As a rank alone says it: a field far away, and a moving one.
TEST_F(Pieces, InAFieldInBricksThatMovesOrIsElsewhere)
{
    Case c = torus(licOf(LicMethod::hierarchical, 20), {}, "U:mag");
    for (int i = 0; i < 3; ++i) {
        GridSample sample;
        sample.dims = {11, 12, 9};
        sample.origin = {998.8, -21.5, 4.5};
        sample.spacing = {0.3, 0.3, 0.2};
        sample.scale = 1 + i;
        writeGridFile(folder_.file("g_" + std::to_string(i) + ".vti"), sample);
    }
    c.description.field.spec = folder_.file("g_*.vti");
    for (const double moment : {0.0, 1.5}) {
        c.description.time.moment = moment;
        expectSame(c, {3, 5}, {kHybrid}, 1);
    }
    SceneDescription description = c.description;
    description.time = {};
    writeWindingField(folder_.file("far.vti"));
    description.field.spec = folder_.file("far.vti");
    description.run.bricks = "on";
    description.run.threads = 1;
    EXPECT_EQ(complaintOf(description, 3), complaintOf(description, 1));
    EXPECT_NE(complaintOf(description, 3).find("does not meet the surface"), std::string::npos);
}

TEST_F(Pieces, InAFieldInBricksEachRankHoldsWhatItsBrickNeeds)
{
    TorusPieces fine;
    fine.pieces = 8;
    fine.aroundWedge = 20;
    fine.aroundTube = 60;
    SceneDescription description = torus(licOf(LicMethod::none, 8), fine).description;
    description.field.spec = "abc:65,65,65";
    const Scene whole = loadScene(description);
    description.run.bricks = "on";
    description.run.threads = 1;
    std::mutex mutex;
    std::size_t held = 0, most = 0;
    runRanks(4, [&](Communicator& communicator) {
        const Scene scene = loadTogether(communicator, description, 4);
        EXPECT_TRUE(scene.bricked() && scene.inPieces);
        EXPECT_EQ(scene.allTriangles, whole.surface.triangles.size()) << "each once";
        EXPECT_EQ(scene.scalarRange, whole.scalarRange);
        const std::lock_guard lock(mutex);
        held += scene.surface.triangles.size();
        most = std::max(most, scene.surface.triangles.size());
    });
    EXPECT_GE(held, whole.surface.triangles.size());
    EXPECT_LT(held, whole.surface.triangles.size() * 5 / 4) << "few reach into several bricks";
    EXPECT_LT(most, whole.surface.triangles.size() / 2);
}

TEST_F(Pieces, AndBricksAreSplitTogetherButForAGpu)
{
    SceneDescription description = torus(licOf(LicMethod::none, 8)).description;
    description.run.bricks = "on";
    const auto expectSplit = [&](const std::string& field, const std::string& backend, bool ofField, bool ofSurface) {
        description.field.spec = field;
        description.run.backend = backend;
        runRanks(2, [&](Communicator& communicator) {
            const Split split = splitOf(communicator, description, 2);
            EXPECT_EQ(split.field, ofField) << field << ", " << backend;
            EXPECT_EQ(split.surface, ofSurface) << field << ", " << backend;
        });
    };
    expectSplit("abc:9,9,9", "cpu", true, true);
    expectSplit("abc:9,9,9", "auto", true, true);
    expectSplit("abc:9,9,9", "gl", true, false);
    expectSplit("", "cpu", false, true);
    description.run.bricks = "auto";
    expectSplit("abc:9,9,9", "cpu", false, false);
}

TEST_F(Pieces, MoreRanksThanPiecesOrRows)
{
    Case c = torus(licOf(LicMethod::hierarchical, 20));
    c.description.output.height = 9;
    expectSame(c, {13}, {kHybrid, runOptions("pixels", "bound", "receive", "on")});
    c = winding(licOf(LicMethod::direct, 20));
    c.description.output.height = 7;
    expectSame(c, {13}, {kHybrid});
}

/// Pieces reach behind the eye, and some are nowhere in the picture.
TEST_F(Pieces, FromInsideTheSurface)
{
    Case c = torus(licOf(LicMethod::hierarchical, 30));
    c.camera.position = Vec3{1001.3, -20, 5.02};
    c.camera.focal = Vec3{1001.3, -19, 5};
    expectSame(c, {3, 5}, {kHybrid}, 1);
    c = winding(licOf(LicMethod::hierarchical, 30));
    c.camera.position = Vec3{9.9, -6.2, 3.6};
    c.camera.focal = Vec3{10.5, -5.5, 3.9};
    expectSame(c, {5}, {kHybrid}, 1);
}

/// As many pixels are covered as by one rank, lit and unlit: no crack at any brick's face, nothing drawn twice.
TEST_F(Pieces, LeaveNoCracks)
{
    Case c = winding(licOf(LicMethod::none, 8), false, "");
    c.description.output.width = 400, c.description.output.height = 300;
    c.description.shading.background = "ff00ff";
    expectSame(c, {8, 13}, {kHybrid}, 3);
}

/// To the last bit: the camera's fit goes by them.
TEST_F(Pieces, BoundsAndRadiusAreThoseOfTheWhole)
{
    TorusPieces some;
    some.noArea = 2;
    SceneDescription description = torus(licOf(LicMethod::none, 8), some).description;
    const Scene whole = loadScene(description);
    description.run.bricks = "on";
    for (const char* field : {"", "abc:9,9,9"}) {
        description.field.spec = field;
        runRanks(3, [&](Communicator& communicator) {
            const Scene scene = loadTogether(communicator, description, 3);
            EXPECT_EQ(scene.boundsWorld.lo, whole.boundsWorld.lo) << field;
            EXPECT_EQ(scene.boundsWorld.hi, whole.boundsWorld.hi) << field;
            EXPECT_EQ(scene.fitRadius, whole.fitRadius) << field;
            EXPECT_EQ(reachOf(communicator, scene).radius, whole.fitRadius) << field;
        });
    }
}

TEST_F(Pieces, EachRankHoldsItsOwnAlone)
{
    TorusPieces fine;
    fine.pieces = 8;
    const Case c = torus(licOf(LicMethod::hierarchical, 20), fine);
    const std::uint64_t all = Renderer(c.description).info().triangles;
    SceneDescription description = c.description;
    description.run.bricks = "on";
    description.run.threads = 1;
    runRanks(4, [&](Communicator& communicator) {
        const Renderer renderer(description, std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
        EXPECT_EQ(renderer.info().triangles, all) << "what is said of the scene is said of all of it";
        EXPECT_EQ(renderer.scene().surface.triangles.size(), all / 4);
    });
}

TEST_F(Pieces, WhatIsWrongIsOneLineOnAllRanks)
{
    SceneDescription iso = winding(licOf(LicMethod::none, 8)).description;
    iso.run.bricks = "on";
    iso.run.threads = 1;
    iso.surface.spec = "isosurface:p=77";
    const std::string outside = complaintOf(iso, 3);
    SceneDescription alone = iso;
    alone.run.bricks = "off";
    EXPECT_EQ(outside, complaintOf(alone, 1)) << "with the range of all bricks";
    EXPECT_NE(outside.find("a value between"), std::string::npos) << outside;

    SceneDescription pieces = torus(licOf(LicMethod::none, 8)).description;
    pieces.run.bricks = "on";
    pieces.run.threads = 1;
    EXPECT_EQ(complaintOf(pieces, 3), "");
    pieces.run.backend = "gl";
    EXPECT_EQ(
        complaintOf(pieces, 2),
        "--backend: gl, but a surface in pieces is drawn by processors alone; expected cpu or auto, or --bricks off");
    pieces.run.backend = "auto";
    TorusPieces other;
    other.otherArrays = 2;
    pieces.surface.spec = torus(licOf(LicMethod::none, 8), other).description.surface.spec;
    EXPECT_NE(complaintOf(pieces, 3).find("torus.pvtp"), std::string::npos) << complaintOf(pieces, 3);
    EXPECT_EQ(complaintOf(pieces, 3).find("not an"), std::string::npos);
    TorusPieces nothing;
    nothing.empty = {0, 1, 2, 3};
    pieces.surface.spec = torus(licOf(LicMethod::none, 8), nothing).description.surface.spec;
    EXPECT_NE(complaintOf(pieces, 3).find("no polygons in any of its pieces"), std::string::npos);
    SceneDescription single = pieces;
    single.surface.spec = folder_.file("torus_1.vtp");
    EXPECT_NE(complaintOf(single, 2).find("a surface that is not in pieces"), std::string::npos);
    std::filesystem::remove(folder_.file("torus_1.vtp"));
    EXPECT_NE(complaintOf(pieces, 3).find("torus_1.vtp is not there"), std::string::npos);
}

TEST_F(Pieces, AWarningOfAPieceIsEveryRanks)
{
    TorusPieces bad;
    bad.noArea = 3;
    SceneDescription description = torus(licOf(LicMethod::none, 8), bad).description;
    description.run.bricks = "on";
    runRanks(3, [&](Communicator& communicator) {
        const Scene scene = loadTogether(communicator, description, 3);
        ASSERT_EQ(scene.warnings.size(), 1u);
        EXPECT_NE(scene.warnings[0].find("torus.pvtp: 1 of 673 triangles left out"), std::string::npos)
            << scene.warnings[0];
    });
}

TEST_F(Pieces, AMovingIsosurfaceAtAnyMoment)
{
    for (int i = 0; i < 3; ++i) writeWindingField(folder_.file("f_" + std::to_string(i) + ".vti"), false, 0.3 * i);
    Case c = make("moving", "isosurface:p=0.1", folder_.file("f_*.vti"), licOf(LicMethod::hierarchical, 20), "p");
    for (const double moment : {0.0, 1.5, 2.0}) {
        c.description.time.moment = moment;
        expectSame(c, {3, 5}, {kHybrid}, 1);
    }
}

class PiecesLong : public Pieces {};

TEST_F(PiecesLong, AnyRanksBalancersGuardsAndMethods)
{
    std::vector<RunOptions> options;
    for (const char* balance : {"static", "timing", "pixels", "hybrid"})
        for (const char* guard : {"bound", "estimate"})
            for (const char* rows : {"project", "receive"})
                for (const char* bricks : {"on", "off"}) options.push_back(runOptions(balance, guard, rows, bricks));
    TorusPieces odd;
    odd.pieces = 9;
    odd.empty = {4};
    odd.strips = 6;
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
        const LicOptions lic = licOf(method, 45);
        const std::vector<int> ranks{2, 3, 5, 8, 13};  // One after the other: files of the same name.
        expectSame(torus(lic), ranks, options);
        expectSame(torus(lic, odd), ranks, options);
        expectSame(winding(lic), ranks, options);
        expectSame(winding(lic, true, "p"), ranks, options);
        for (const char* colorBy : {"q", "abc:mag"}) {
            Case both = torus(lic, odd, colorBy);
            both.description.field.spec = "abc:24,20,22";
            expectSame(both, ranks, options);
        }
    }
}

}  // namespace
}  // namespace aeolic
