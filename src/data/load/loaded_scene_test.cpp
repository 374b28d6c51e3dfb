#include "data/load/loaded_scene.h"

#include <gtest/gtest.h>

#include <mutex>

#include "aeolic/error.h"
#include "data/fingerprint.h"
#include "data/vtk/testing/sample_files.h"
#include "describe_testing.h"
#include "load_testing.h"
#include "pieces_testing.h"

/// One loader for one rank and for many: both say the same of the whole scene.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

/// Without its last line, the hash of what a rank holds.
std::string factsIn(const std::string& fingerprint)
{
    return fingerprint.substr(0, fingerprint.find("values with the hash"));
}

void expectSameFacts(const Scene& part, const Scene& whole, const std::string& what)
{
    EXPECT_EQ(factsIn(fingerprint(part)), factsIn(fingerprint(whole))) << what;
    EXPECT_EQ(part.boundsWorld.lo, whole.boundsWorld.lo) << what;
    EXPECT_EQ(part.boundsWorld.hi, whole.boundsWorld.hi) << what;
    EXPECT_EQ(part.fitRadius, whole.fitRadius) << what;
    EXPECT_EQ(part.reach.boundsWorld.lo, whole.reach.boundsWorld.lo) << what;
    EXPECT_EQ(part.reach.boundsWorld.hi, whole.reach.boundsWorld.hi) << what;
    EXPECT_EQ(part.reach.radius, whole.reach.radius) << what;
    EXPECT_EQ(part.warnings, whole.warnings) << what;
}

class LoadedSceneTest : public testing::Test {
protected:
    std::string torus() const
    {
        TorusPieces bad;
        bad.noArea = 2;
        return writeTorusPieces(folder_.path().string(), "torus", bad);
    }
    std::string winding(const std::string& name = "f.vti", double phase = 0) const
    {
        writeWindingField(folder_.file(name), false, phase);
        return folder_.file(name);
    }
    TempFolder folder_;
};

TEST_F(LoadedSceneTest, IsTheSameOnOneRankAndOnMany)
{
    const std::vector<SceneDescription> scenes{describe("teapot:600", "abc:9,9,9", "abc:mag"),
                                               describe(torus(), "", "q"),
                                               describe("isosurface:p=0.1", winding(), "p")};
    for (const SceneDescription& description : scenes) {
        const std::string alone = fingerprint(loadScene(description));
        for (const int ranks : {1, 2, 3, 5})
            for (const Scene& scene : loadParts(description, {}, ranks))
                EXPECT_EQ(fingerprint(scene), alone) << description.surface.spec << ", " << ranks << " ranks";
    }
}

TEST_F(LoadedSceneTest, SaysOfItsPartsWhatItSaysOfTheWhole)
{
    const auto expect = [](const SceneDescription& description, const Split& split) {
        const Scene whole = loadScene(description);
        for (const int ranks : {2, 3, 5})
            for (const Scene& part : loadParts(description, split, ranks))
                expectSameFacts(part, whole, description.surface.spec + " on " + std::to_string(ranks));
    };
    expect(describe("teapot:600", "abc:9,9,9", "abc:mag"), {true, false});
    expect(describe("isosurface:p=0.1", winding(), "p"), {true, false});
    expect(describe(torus(), "", "q"), {false, true});
    expect(describe(torus(), "abc:9,9,9", "abc:mag"), {false, true});
    expect(describe(torus(), "abc:9,9,9", "abc:mag"), {true, true});
}

TEST_F(LoadedSceneTest, GoesToTheSameMomentsOnOneRankAndOnMany)
{
    for (int i = 0; i < 3; ++i) winding("f_" + std::to_string(i) + ".vti", 0.3 * i);
    const SceneDescription description = describe("isosurface:p=0.1", folder_.file("f_*.vti"), "p");
    for (const double moment : {0.5, 2.0, 0.0}) {
        OneRank one;
        LoadedScene alone(description, {}, one);
        alone.moveTo(moment);
        runRanks(3, [&](Communicator& communicator) {
            CommunicatorAgreement agreement(communicator);
            LoadedScene whole(description, {}, agreement), parts(description, {true, false}, agreement);
            whole.moveTo(moment);
            parts.moveTo(moment);
            EXPECT_EQ(fingerprint(whole.scene()), fingerprint(alone.scene())) << moment;
            expectSameFacts(parts.scene(), alone.scene(), "at " + std::to_string(moment));
        });
    }
}

TEST_F(LoadedSceneTest, WhatOneRankCannotReadIsAnErrorOnAll)
{
    TorusPieces other;
    other.otherArrays = 2;
    const SceneDescription description = describe(writeTorusPieces(folder_.path().string(), "torus", other), "", "q");
    std::mutex mutex;
    std::vector<std::string> errors;
    runRanks(4, [&](Communicator& communicator) {
        CommunicatorAgreement agreement(communicator);
        try {
            const LoadedScene loaded(description, {false, true}, agreement);
        } catch (const InputError& error) {
            const std::lock_guard lock(mutex);
            errors.emplace_back(error.what());
        }
    });
    ASSERT_EQ(errors.size(), 4u);
    for (const std::string& error : errors) EXPECT_EQ(error, errors[0]);
    EXPECT_NE(errors[0].find("rank 2: "), std::string::npos) << errors[0];
}

TEST(Agreement, IsOfAllRanks)
{
    runRanks(3, [](Communicator& communicator) {
        CommunicatorAgreement agreement(communicator);
        const int rank = communicator.rank();
        EXPECT_EQ(agreement.part().rank, rank);
        EXPECT_EQ(agreement.part().ranks, 3);
        EXPECT_EQ(agreement.least(1.5 * rank), 0);
        EXPECT_EQ(agreement.greatest(1.5 * rank), 3);
        EXPECT_EQ(agreement.sum(rank + 1), 6);
        EXPECT_TRUE(agreement.any(rank == 1) && !agreement.any(false));
        EXPECT_TRUE(agreement.all(true) && !agreement.all(rank != 2));
        EXPECT_EQ(agreement.distinct({"same", std::to_string(rank)}),
                  (std::vector<std::string>{"same", "0", "1", "2"}));
        EXPECT_THROW(agreement.together([&] {
            if (rank == 2) throw InputError("x", "y", "z");
        }),
                     InputError);
        agreement.requireSame("all", "alike");
        EXPECT_THROW(agreement.requireSame("the rank", std::to_string(rank)), InputError);
    });
}

TEST(Agreement, OfOneRankIsWhatItSays)
{
    OneRank alone;
    EXPECT_FALSE(alone.part().split());
    EXPECT_EQ(alone.least(2.5), 2.5);
    EXPECT_EQ(alone.greatest(2.5), 2.5);
    EXPECT_EQ(alone.sum(7), 7);
    EXPECT_TRUE(alone.any(true) && alone.all(true) && !alone.any(false) && !alone.all(false));
    EXPECT_THROW(alone.together([] { throw InputError("x", "y", "z"); }), InputError);
}

}  // namespace
}  // namespace aeolic
