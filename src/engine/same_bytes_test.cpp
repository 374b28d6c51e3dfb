#include <gtest/gtest.h>

#include "render_testing.h"
#include "same_bytes_testing.h"

/// The promise: a picture's bytes do not depend on how many ranks draw it, nor on how they share the work.
namespace aeolic {
namespace {

using namespace testkit;

/// Far from pixel to pixel: what cells vouch for reaches farther, and not equally far on all ranks.
LicOptions longSteps(LicMethod method, int steps)
{
    LicOptions lic = licOf(method, steps);
    lic.step = 3;
    return lic;
}

/// The ranks that hold the vectors say where no streaks show, and the ranks that hold the surface draw it.
LicOptions masked(LicOptions lic)
{
    lic.maskBelow = 1.3;
    return lic;
}

LicOptions oriented(LicOptions lic)
{
    lic.magnitude = Magnitude::contrast;
    lic.style = Style::oriented;
    return lic;
}

/// Depths of other ranks' rows darken this one's.
Case occluded(Case c)
{
    c.description.shading.occlusion = true;
    return c;
}

std::vector<Case> cases()
{
    return {makeCase("hierarchical", 160, 131, licOf(LicMethod::hierarchical, 40)),
            makeCase("hann with remainder", 160, 97, licOf(LicMethod::hierarchical, 77, Kernel::hann)),
            makeCase("oriented", 160, 97, oriented(licOf(LicMethod::hierarchical, 245))),
            occluded(makeCase("direct", 160, 131, licOf(LicMethod::direct, 30))),
            makeCase("by magnitude", 120, 101, licOf(LicMethod::hierarchical, 50, Kernel::box, false), "torus:3000",
                     "tornado:24,24,24"),
            makeCase("long steps", 160, 131, longSteps(LicMethod::hierarchical, 24)),
            makeCase("long direct steps", 120, 101, longSteps(LicMethod::direct, 12)),
            makeCase("masked", 120, 101, masked(licOf(LicMethod::hierarchical, 30)), "torus:3000", "tornado:24,24,24"),
            occluded(makeCase("no streaks", 64, 48, licOf(LicMethod::none, 8)))};
}

class SameBytes : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, SameBytes, allBackends, backendName);

TEST_P(SameBytes, FromAnyNumberOfRanksAndBalancer)
{
    for (const Case& c : cases()) {
        const std::vector<Picture> alone = draw(GetParam(), c, {}, 1, 3);
        // What a program on the processor plays the GPU in, it plays slowly.
        const bool slow = GetParam() == "gl";
        for (const int ranks : slow ? std::vector{2, 5} : std::vector{2, 3, 5})
            for (const char* balance :
                 slow ? std::vector{"static", "hybrid"} : std::vector{"static", "timing", "pixels", "hybrid"})
                expectSameBytes(GetParam(), c, alone, runOptions(balance, "bound", "auto"), ranks);
    }
}

TEST_P(SameBytes, FromAnyGuard)
{
    for (const Case& c : cases()) {
        const std::vector<Picture> alone = draw(GetParam(), c, {}, 1, 1);
        for (const int ranks : {2, 5}) {
            expectSameBytes(GetParam(), c, alone, runOptions("hybrid", "bound", "project"), ranks);
            expectSameBytes(GetParam(), c, alone, runOptions("hybrid", "bound", "receive"), ranks);
            expectSameBytes(GetParam(), c, alone, runOptions("hybrid", "estimate", "auto"), ranks);
        }
    }
}

/// Three and four levels; steps so short that traces end within the picture.
TEST_P(SameBytes, FromTracesOfJumpsOfJumps)
{
    for (const int steps : {300, 1024}) {
        LicOptions lic = licOf(LicMethod::hierarchical, steps);
        lic.step = 25.0 / steps;
        const Case c = makeCase(std::to_string(steps) + " steps", 90, 100, lic);
        const std::vector<Picture> alone = draw(GetParam(), c, {}, 1, 1);
        expectSameBytes(GetParam(), c, alone, runOptions("hybrid", "bound", "project"), 5);
        expectSameBytes(GetParam(), c, alone, runOptions("hybrid", "bound", "receive"), 5);
        expectSameBytes(GetParam(), c, alone, runOptions("hybrid", "estimate", "receive"), 5);
    }
}

TEST_P(SameBytes, FromBricks)
{
    for (const Case& c : cases()) {
        const std::vector<Picture> alone = draw(GetParam(), c, {}, 1, 2);
        for (const int ranks : GetParam() == "gl" ? std::vector{3} : std::vector{2, 3, 8})
            for (const char* guardRows : {"project", "receive"})
                expectSameBytes(GetParam(), c, alone, runOptions("hybrid", "bound", guardRows, "on"), ranks);
    }
}

TEST_P(SameBytes, FromMoreRanksThanRowsOrCells)
{
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
        const Case c = occluded(makeCase("seven rows", 40, 7, licOf(method, 20), "teapot:6000", "abc:2,2,3"));
        const std::vector<Picture> alone = draw(GetParam(), c, {}, 1, 1);
        for (const char* balance : {"static", "pixels", "hybrid"})
            for (const char* bricks : {"on", "off"})
                expectSameBytes(GetParam(), c, alone, runOptions(balance, "bound", "auto", bricks), 13);
    }
}

/// Two phases from one place, two from another: those behind the first are mixed from what the ranks have kept.
TEST_P(SameBytes, OfStreaksThatFlow)
{
    CameraOptions here, there;
    there.azimuth = 100;
    const std::vector<CameraOptions> cameras{here, here, there, there};
    for (const bool isOriented : {false, true})
        for (const bool bricks : {false, true}) {
            Case c = occluded(makeCase("flowing", 120, 101, licOf(LicMethod::hierarchical, isOriented ? 120 : 40)));
            c.description.lic.flow = FlowMotion::loop;
            if (isOriented) c.description.lic.style = Style::oriented;
            const std::vector<Picture> alone = draw(GetParam(), c, {}, 1, cameras);
            EXPECT_NE(alone[0].pixels, alone[1].pixels);
            for (const int ranks : {2, 5})
                for (const char* guardRows : {"project", "receive"}) {
                    const RunOptions options = runOptions("timing", "estimate", guardRows, bricks ? "on" : "off");
                    const std::vector<Picture> pictures = draw(GetParam(), c, options, ranks, cameras);
                    for (std::size_t i = 0; i < alone.size(); ++i)
                        EXPECT_TRUE(pictures[i].pixels == alone[i].pixels)
                            << ranks << " ranks, " << guardRows << ", bricks " << bricks << ", oriented " << isOriented
                            << ", frame " << i;
                }
        }
}

/// The camera inside the mesh: bricks reach behind the eye.
TEST_P(SameBytes, FromInsideTheSurface)
{
    Case c = makeCase("inside", 90, 70, licOf(LicMethod::hierarchical, 30), "torus:3000");
    c.camera.position = Vec3{0.7, 0, 0.02};
    c.camera.focal = Vec3{0.7, 1, 0};
    const std::vector<Picture> alone = draw(GetParam(), c, {}, 1, 2);
    expectSameBytes(GetParam(), c, alone, runOptions("pixels", "estimate", "auto", "on"), 5);
}

}  // namespace
}  // namespace aeolic
