#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include "cluster/thread_communicator.h"
#include "pipeline/frame.h"
#include "pipeline/load_together.h"
#include "render_testing.h"

/// The promise: a picture's bytes do not depend on how many ranks draw it, nor on how they share the work.
namespace aeolic {
namespace {

using namespace testkit;

struct Case {
    std::string name;
    SceneDescription description;
    CameraOptions camera;
};

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

Case makeCase(const std::string& name, int width, int height, const LicOptions& lic,
              const std::string& surface = "teapot:6000", const std::string& field = "abc:32,32,32")
{
    SceneDescription description;
    description.surface.spec = surface;
    description.field.spec = field;
    description.shading.colorBy = field.substr(0, field.find(':')) + ":mag";
    description.lic = lic;
    description.output.width = width;
    description.output.height = height;
    CameraOptions close;
    close.zoom = 1.5;
    return {name, description, close};
}

/// Frames of a turning camera, so that balancers that look back have something to look at.
std::vector<Tile> draw(const std::string& backendName, const Case& c, const RunOptions& options, int ranks, int frames)
{
    std::vector<Tile> pictures;
    runRanks(ranks, [&](Communicator& communicator) {
        // A group shares its communicator; this one belongs to runRanks.
        FrameGroup group(std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}), options);
        SceneDescription description = c.description;
        description.run = options;
        tbb::task_arena arena(1);
        arena.execute([&] {
            const Scene scene = loadTogether(communicator, description, ranks);
            const auto backend = makeBackend(backendName, scene);
            Frame drawn;
            for (int frame = 0; frame < frames; ++frame) {
                CameraOptions turned = c.camera;
                turned = orbited(turned, 25.0 * frame, scene.boundsWorld);
                const FrameRequest request{
                    fitCamera(scene, turned, description.output.width, description.output.height), description.lic,
                    description.shading};
                renderFrame(request, scene, *backend, group, drawn);
                if (communicator.isRoot()) pictures.push_back(drawn.tiles.picture);
            }
        });
    });
    return pictures;
}

RunOptions runOptions(const std::string& balance, const std::string& guard, const std::string& guardRows,
                      const std::string& bricks = "off")
{
    RunOptions options;
    options.balance = balance;
    options.guard = guard;
    options.guardRows = guardRows;
    options.bricks = bricks;
    return options;
}

void expectSameBytes(const std::string& backendName, const Case& c, const std::vector<Tile>& expected,
                     const RunOptions& options, int ranks)
{
    const std::vector<Tile> pictures = draw(backendName, c, options, ranks, int(expected.size()));
    ASSERT_EQ(pictures.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        ASSERT_EQ(pictures[i].rgba.size(), expected[i].rgba.size());
        std::size_t differing = 0;
        for (std::size_t k = 0; k < expected[i].rgba.size(); ++k)
            differing += pictures[i].rgba[k] != expected[i].rgba[k];
        EXPECT_EQ(differing, 0u) << c.name << ", " << ranks << " ranks, " << options.balance << ", guard "
                                 << options.guard << " " << options.guardRows << ", bricks " << options.bricks
                                 << ", frame " << i;
    }
}

std::vector<Case> cases()
{
    return {makeCase("hierarchical", 160, 131, licOf(LicMethod::hierarchical, 40)),
            makeCase("hann with remainder", 160, 97, licOf(LicMethod::hierarchical, 77, Kernel::hann)),
            makeCase("direct", 160, 131, licOf(LicMethod::direct, 30)),
            makeCase("by magnitude", 120, 101, licOf(LicMethod::hierarchical, 50, Kernel::box, false), "torus:3000",
                     "tornado:24,24,24"),
            makeCase("no streaks", 64, 48, licOf(LicMethod::none, 8))};
}

class SameBytes : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, SameBytes, allBackends, backendName);

TEST_P(SameBytes, FromAnyNumberOfRanksAndBalancer)
{
    for (const Case& c : cases()) {
        const std::vector<Tile> alone = draw(GetParam(), c, {}, 1, 3);
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
        const std::vector<Tile> alone = draw(GetParam(), c, {}, 1, 1);
        for (const int ranks : {2, 5}) {
            expectSameBytes(GetParam(), c, alone, runOptions("hybrid", "bound", "project"), ranks);
            expectSameBytes(GetParam(), c, alone, runOptions("hybrid", "bound", "receive"), ranks);
            expectSameBytes(GetParam(), c, alone, runOptions("hybrid", "estimate", "auto"), ranks);
        }
    }
}

TEST_P(SameBytes, FromBricks)
{
    for (const Case& c : cases()) {
        const std::vector<Tile> alone = draw(GetParam(), c, {}, 1, 2);
        for (const int ranks : GetParam() == "gl" ? std::vector{3} : std::vector{2, 3, 8})
            for (const char* guardRows : {"project", "receive"})
                expectSameBytes(GetParam(), c, alone, runOptions("hybrid", "bound", guardRows, "on"), ranks);
    }
}

TEST_P(SameBytes, FromMoreRanksThanRowsOrCells)
{
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
        const Case c = makeCase("seven rows", 40, 7, licOf(method, 20), "teapot:6000", "abc:2,2,3");
        const std::vector<Tile> alone = draw(GetParam(), c, {}, 1, 1);
        for (const char* balance : {"static", "pixels", "hybrid"})
            for (const char* bricks : {"on", "off"})
                expectSameBytes(GetParam(), c, alone, runOptions(balance, "bound", "auto", bricks), 13);
    }
}

/// The camera inside the mesh: bricks reach behind the eye.
TEST_P(SameBytes, FromInsideTheSurface)
{
    Case c = makeCase("inside", 90, 70, licOf(LicMethod::hierarchical, 30), "torus:3000");
    c.camera.position = Vec3{0.7, 0, 0.02};
    c.camera.focal = Vec3{0.7, 1, 0};
    const std::vector<Tile> alone = draw(GetParam(), c, {}, 1, 2);
    expectSameBytes(GetParam(), c, alone, runOptions("pixels", "estimate", "auto", "on"), 5);
}

}  // namespace
}  // namespace aeolic
