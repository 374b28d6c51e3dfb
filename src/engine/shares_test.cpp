#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <mutex>
#include <type_traits>

#include "aeolic/error.h"
#include "cluster/composite/composite.h"
#include "description/camera.h"
#include "description/choices.h"
#include "load_testing.h"
#include "pieces_scenes_testing.h"
#include "render_testing.h"

/// Whole scenes, bricks and pieces go through the same calls: project, composite, complete. What the ranks have then is
/// what one rank has that holds everything.
namespace aeolic {
namespace {

using namespace testkit;

class Shares : public PiecesTest, public ::testing::WithParamInterface<std::string> {
protected:
    void SetUp() override { skipWithout(GetParam()); }

    Case bricks() const { return makeCase("bricks", 120, 90, licOf(LicMethod::hierarchical, 30), "torus:3000"); }
};
INSTANTIATE_TEST_SUITE_P(Backends, Shares, allBackends, backendName);

/// Which alternative of Share.
enum Kind : std::size_t { whole, brick, piece };

/// What later stages read of every pixel.
struct Pixels {
    std::vector<float> invDepth;
    std::vector<std::uint32_t> flow;
    std::vector<int> links;
    bool operator==(const Pixels&) const = default;
};

Pixels pixelsOf(const GBuffer& buffer, const Extent& rows)
{
    Pixels pixels;
    for (int y = rows.y0; y < rows.y1; ++y)
        for (int x = rows.x0; x < rows.x1; ++x) {
            pixels.invDepth.push_back(buffer.invDepth.at(x, y));
            pixels.flow.push_back(buffer.flow.at(x, y));
            pixels.links.push_back(buffer.links.at(x, y));
        }
    return pixels;
}

/// What every rank has of the image's upper half, which is drawn for all of them.
std::vector<Pixels> drawOn(int ranks, const std::string& backendName, const Case& c, Kind kind)
{
    std::vector<Pixels> drawn(static_cast<std::size_t>(ranks));
    runRanks(ranks, [&](Communicator& communicator) {
        SceneDescription description = c.description;
        description.run.bricks = ranks > 1 ? BrickChoice::on : BrickChoice::off;
        tbb::task_arena arena(1);
        arena.execute([&] {
            const Scene scene = loadOnRank(communicator, description);
            const auto backend =
                makeBackend(*choiceNamed<BackendChoice>(backendName), scene, {-1, communicator.rank()});
            const Camera camera = makeCamera(c.camera, scene.boundsWorld, scene.fitRadius, description.output.width,
                                             description.output.height, scene.reach);
            const View view = makeView(camera, scene, description.lic);
            const Extent rows{0, 0, camera.width, camera.height / 2}, valid{0, 0, camera.width, camera.height / 2 + 5};
            const Share share = backend->project(view, rows, valid);
            EXPECT_EQ(share.index(), kind);
            const std::vector<Extent> needed(std::size_t(ranks), withNeighbours(rows, valid));
            std::visit(
                [&](const auto& of) {
                    if constexpr (!std::is_same_v<decltype(of), const std::monostate&>)
                        composite(communicator, of, needed);
                },
                share);
            backend->complete(view, rows);
            drawn[std::size_t(communicator.rank())] = pixelsOf(backend->probe().gbuffer(), rows);
        });
    });
    return drawn;
}

void expectWhatOneHas(const std::string& backendName, const Case& c, Kind kind)
{
    const Pixels alone = drawOn(1, backendName, c, whole).front();
    EXPECT_GT(std::count_if(alone.links.begin(), alone.links.end(), [](int links) { return links == 255; }), 100);
    for (const int ranks : {2, 5})
        for (const Pixels& pixels : drawOn(ranks, backendName, c, kind)) EXPECT_TRUE(pixels == alone) << ranks;
}

TEST_P(Shares, OfAFieldInBricks)
{
    expectWhatOneHas(GetParam(), bricks(), brick);
}

TEST_P(Shares, OfASurfaceInPieces)
{
    const Case c = torus(licOf(LicMethod::hierarchical, 30));
    if (GetParam() == "gl")
        EXPECT_THROW(drawOn(2, GetParam(), c, piece), InputError);
    else
        expectWhatOneHas(GetParam(), c, piece);
}

/// The G-buffer is complete after project() already.
TEST_P(Shares, OfAWholeSceneThereAreNone)
{
    Stages stages(GetParam(), makeBuiltinScene("torus:3000", "abc:16,16,16"));
    const Camera camera = fitCamera(stages.scene, {}, 120, 90);
    const Extent image = wholeImage(camera);
    const Pixels before = pixelsOf(stages.project(camera, directLic(10)), image);
    stages.backend->complete(stages.view, image);
    EXPECT_TRUE(pixelsOf(stages.backend->probe().gbuffer(), image) == before);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(stages.backend->project(stages.view, image)));
}

}  // namespace
}  // namespace aeolic
