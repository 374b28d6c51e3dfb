#include <gtest/gtest.h>

#include <mutex>

#include "description/choices.h"
#include "engine/renderer_internals.h"
#include "load_testing.h"
#include "pieces_scenes_testing.h"

/// What each rank holds of a surface in pieces, and what all ranks say of it.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

class PiecesLoaded : public PiecesTest {};

TEST_F(PiecesLoaded, InAFieldInBricksAreWhatEachBrickNeeds)
{
    TorusPieces fine;
    fine.pieces = 8;
    fine.aroundWedge = 20;
    fine.aroundTube = 60;
    SceneDescription description = torus(licOf(LicMethod::none, 8), fine).description;
    description.field.spec = "abc:65,65,65";
    const Scene whole = loadScene(description);
    description.run.bricks = BrickChoice::on;
    description.run.threads = 1;
    std::mutex mutex;
    std::size_t held = 0, most = 0;
    runRanks(4, [&](Communicator& communicator) {
        const Scene scene = loadOnRank(communicator, description);
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

TEST_F(PiecesLoaded, AreSplitAsBricksAreButForAGpu)
{
    SceneDescription description = torus(licOf(LicMethod::none, 8)).description;
    description.run.bricks = BrickChoice::on;
    const auto expectSplit = [&](const std::string& field, BackendChoice backend, bool ofField, bool ofSurface) {
        description.field.spec = field;
        description.run.backend = backend;
        runRanks(2, [&](Communicator& communicator) {
            CommunicatorAgreement agreement(communicator);
            const Split split = splitOf(description, agreement, 2);
            EXPECT_EQ(split.field, ofField) << field << ", " << nameOf(backend);
            EXPECT_EQ(split.surface, ofSurface) << field << ", " << nameOf(backend);
        });
    };
    expectSplit("abc:9,9,9", BackendChoice::cpu, true, true);
    expectSplit("abc:9,9,9", BackendChoice::automatic, true, true);
    expectSplit("abc:9,9,9", BackendChoice::gl, true, false);
    expectSplit("", BackendChoice::cpu, false, true);
    description.run.bricks = BrickChoice::automatic;
    expectSplit("abc:9,9,9", BackendChoice::cpu, false, false);
}

/// To the last bit: the camera's fit goes by them.
TEST_F(PiecesLoaded, HaveBoundsAndRadiusOfTheWhole)
{
    TorusPieces some;
    some.noArea = 2;
    SceneDescription description = torus(licOf(LicMethod::none, 8), some).description;
    const Scene whole = loadScene(description);
    description.run.bricks = BrickChoice::on;
    for (const char* field : {"", "abc:9,9,9"}) {
        description.field.spec = field;
        runRanks(3, [&](Communicator& communicator) {
            const Scene scene = loadOnRank(communicator, description);
            EXPECT_EQ(scene.boundsWorld.lo, whole.boundsWorld.lo) << field;
            EXPECT_EQ(scene.boundsWorld.hi, whole.boundsWorld.hi) << field;
            EXPECT_EQ(scene.fitRadius, whole.fitRadius) << field;
            EXPECT_EQ(scene.reach.radius, whole.fitRadius) << field;
        });
    }
}

TEST_F(PiecesLoaded, AreHeldByTheirRankAlone)
{
    TorusPieces fine;
    fine.pieces = 8;
    const Case c = torus(licOf(LicMethod::hierarchical, 20), fine);
    const std::uint64_t all = Renderer(c.description).info().triangles;
    SceneDescription description = c.description;
    description.run.bricks = BrickChoice::on;
    description.run.threads = 1;
    runRanks(4, [&](Communicator& communicator) {
        const Renderer renderer(description, std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
        EXPECT_EQ(renderer.info().triangles, all) << "counts are of the whole scene, not of a piece";
        EXPECT_EQ(RendererInternals::scene(renderer).surface.triangles.size(), all / 4);
    });
}

TEST_F(PiecesLoaded, WhatIsWrongIsOneLineOnAllRanks)
{
    SceneDescription iso = winding(licOf(LicMethod::none, 8)).description;
    iso.run.bricks = BrickChoice::on;
    iso.run.threads = 1;
    iso.surface.spec = "isosurface:p=77";
    const std::string outside = complaintOf(iso, 3);
    SceneDescription alone = iso;
    alone.run.bricks = BrickChoice::off;
    EXPECT_EQ(outside, complaintOf(alone, 1)) << "with the range of all bricks";
    EXPECT_NE(outside.find("a value between"), std::string::npos) << outside;

    SceneDescription pieces = torus(licOf(LicMethod::none, 8)).description;
    pieces.run.bricks = BrickChoice::on;
    pieces.run.threads = 1;
    EXPECT_EQ(complaintOf(pieces, 3), "");
    pieces.run.backend = BackendChoice::gl;
    EXPECT_EQ(
        complaintOf(pieces, 2),
        "--backend: gl, but a surface in pieces is drawn by processors alone; expected cpu or auto, or --bricks off");
    pieces.run.backend = BackendChoice::automatic;
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

TEST_F(PiecesLoaded, AWarningOfAPieceIsEveryRanks)
{
    TorusPieces bad;
    bad.noArea = 3;
    SceneDescription description = torus(licOf(LicMethod::none, 8), bad).description;
    description.run.bricks = BrickChoice::on;
    runRanks(3, [&](Communicator& communicator) {
        const Scene scene = loadOnRank(communicator, description);
        ASSERT_EQ(scene.warnings.size(), 1u);
        EXPECT_NE(scene.warnings[0].find("torus.pvtp: 1 of 673 triangles left out"), std::string::npos)
            << scene.warnings[0];
    });
}

}  // namespace
}  // namespace aeolic
