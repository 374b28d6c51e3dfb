#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <mutex>

#include "cluster/serial_communicator.h"
#include "cluster/thread_communicator.h"
#include "pipeline/frame.h"
#include "render_testing.h"

/// The promise: a picture's bytes do not depend on how many ranks draw it, nor on how they share the work.
namespace aeolic {
namespace {

using namespace testkit;

struct Case {
    std::string name;
    Scene scene;
    FrameRequest request;
};

Scene teapot()
{
    Scene scene = makeBuiltinScene("teapot:6000", "abc:32,32,32");
    scene.hasScalar = scene.colorByFieldMagnitude = true;
    return scene;
}

Case makeCase(const std::string& name, Scene scene, int width, int height, const CameraOptions& camera,
              const LicOptions& lic)
{
    Case c{name, std::move(scene), {}};
    c.request = {fitCamera(c.scene, camera, width, height), lic, {}};
    return c;
}

LicOptions licOf(LicMethod method, int steps, Kernel kernel = Kernel::box, bool normalize = true)
{
    LicOptions lic;
    lic.method = method;
    lic.steps = steps;
    lic.kernel = kernel;
    lic.phaseRad = 0.7;
    lic.normalize = normalize;
    return lic;
}

/// Frames of a turning camera, so that balancers that look back have something to look at.
std::vector<Tile> draw(const Case& c, const RunOptions& options, int ranks, int frames)
{
    std::vector<Tile> pictures;
    runRanks(ranks, [&](Communicator& communicator) {
        // A group shares its communicator; this one belongs to runRanks.
        FrameGroup group(std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}), options);
        tbb::task_arena arena(1);
        arena.execute([&] {
            const auto backend = makeBackend("cpu", c.scene);
            FrameTiles tiles;
            FrameStats stats;
            for (int frame = 0; frame < frames; ++frame) {
                FrameRequest request = c.request;
                CameraOptions turned;
                turned.azimuthDeg += 25.0 * frame;
                turned.zoom = 1.5;
                request.camera = fitCamera(c.scene, turned, c.request.camera.width, c.request.camera.height);
                renderFrame(request, c.scene, *backend, group, tiles, stats);
                if (communicator.isRoot()) pictures.push_back(tiles.picture);
            }
        });
    });
    return pictures;
}

RunOptions runOptions(const std::string& balance, const std::string& guard, const std::string& guardRows)
{
    RunOptions options;
    options.balance = balance;
    options.guard = guard;
    options.guardRows = guardRows;
    return options;
}

void expectSameBytes(const Case& c, const std::vector<Tile>& expected, const RunOptions& options, int ranks)
{
    const std::vector<Tile> pictures = draw(c, options, ranks, int(expected.size()));
    ASSERT_EQ(pictures.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        ASSERT_EQ(pictures[i].rgba.size(), expected[i].rgba.size());
        std::size_t differing = 0;
        for (std::size_t k = 0; k < expected[i].rgba.size(); ++k)
            differing += pictures[i].rgba[k] != expected[i].rgba[k];
        EXPECT_EQ(differing, 0u) << c.name << ", " << ranks << " ranks, " << options.balance << ", guard "
                                 << options.guard << " " << options.guardRows << ", frame " << i;
    }
}

std::vector<Case> cases()
{
    CameraOptions close;
    close.zoom = 1.5;
    std::vector<Case> all;
    all.push_back(makeCase("hierarchical", teapot(), 160, 131, close, licOf(LicMethod::hierarchical, 40)));
    all.push_back(
        makeCase("hann with remainder", teapot(), 160, 97, close, licOf(LicMethod::hierarchical, 77, Kernel::hann)));
    all.push_back(makeCase("direct", teapot(), 160, 131, close, licOf(LicMethod::direct, 30)));
    all.push_back(makeCase("by magnitude", makeBuiltinScene("torus:3000", "tornado:24,24,24"), 120, 101, close,
                           licOf(LicMethod::hierarchical, 50, Kernel::box, false)));
    all.push_back(makeCase("no streaks", teapot(), 64, 48, close, licOf(LicMethod::none, 8)));
    return all;
}

TEST(SameBytes, FromAnyNumberOfRanksAndBalancer)
{
    for (const Case& c : cases()) {
        const std::vector<Tile> alone = draw(c, {}, 1, 3);
        for (const int ranks : {2, 3, 5})
            for (const char* balance : {"static", "timing", "pixels", "hybrid"})
                expectSameBytes(c, alone, runOptions(balance, "bound", "auto"), ranks);
    }
}

TEST(SameBytes, FromAnyGuard)
{
    for (const Case& c : cases()) {
        const std::vector<Tile> alone = draw(c, {}, 1, 1);
        for (const int ranks : {2, 5}) {
            expectSameBytes(c, alone, runOptions("hybrid", "bound", "project"), ranks);
            expectSameBytes(c, alone, runOptions("hybrid", "bound", "receive"), ranks);
            expectSameBytes(c, alone, runOptions("hybrid", "estimate", "auto"), ranks);
        }
    }
}

TEST(SameBytes, FromMoreRanksThanRows)
{
    CameraOptions camera;
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
        const Case c = makeCase("seven rows", teapot(), 40, 7, camera, licOf(method, 20));
        const std::vector<Tile> alone = draw(c, {}, 1, 1);
        for (const char* balance : {"static", "pixels", "hybrid"})
            expectSameBytes(c, alone, runOptions(balance, "bound", "auto"), 13);
    }
}

}  // namespace
}  // namespace aeolic
