#include "engine/whole_scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "aeolic/error.h"
#include "base/memory.h"
#include "engine/renderer_internals.h"
#include "pieces_scenes_testing.h"
#include "ranks/thread_communicator.h"

/// What is asked of a whole scene that lies among ranks: lines, topology, what a pixel shows.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

std::string textOf(const Vec3& v)
{
    return fmt::format("{} {} {}", v[0], v[1], v[2]);
}

std::string textOf(const SurfaceValues& values)
{
    return fmt::format("{} | {} | {}\n", textOf(values.position), textOf(values.vector), values.scalar);
}

std::string textOf(const FlowTopology& topology)
{
    std::string text = topology.scalar + "\n";
    for (const FlowPoint& point : topology.points)
        text += fmt::format("{} {} {} {}: {}", int(point.kind), point.attracts, point.index, point.strength,
                            textOf(point.at));
    for (const FlowLine& line : topology.lines) {
        text += fmt::format("line {} {} {}\n", line.separates, line.length, line.strength);
        for (const SurfaceValues& place : line.places) text += textOf(place);
    }
    return text;
}

std::string textOf(const EvenSurfaceLines& lines)
{
    std::string text = fmt::format("{} {}\n", lines.scalar, lines.spacing);
    for (const SurfaceStreamline& line : lines.lines) {
        text += fmt::format("line {} {}\n", line.closed, line.length);
        for (const SurfaceValues& place : line.places) text += textOf(place);
    }
    return text;
}

std::string textOf(const std::optional<PickedPlace>& place)
{
    if (!place) return "nothing\n";
    return fmt::format("{} at {}, normal {}, triangle {} of {}, {} {}, {} along it, {} {}\n", place->depth,
                       textOf(place->position), textOf(place->normal), place->triangle, place->surface,
                       place->vectorName, place->vector ? textOf(*place->vector) : "none",
                       place->tangential ? textOf(*place->tangential) : "none", place->scalarName,
                       place->scalar.value_or(-1));
}

class WholeScenes : public PiecesTest {
protected:
    using Ask = std::function<std::string(Renderer&)>;

    /// Every rank answers as one alone does, which has the whole scene.
    void expectSameAnswer(const SceneDescription& scene, const std::vector<int>& ranks, const Ask& ask,
                          std::size_t leastLength)
    {
        SceneDescription whole = scene;
        whole.run.bricks = BrickChoice::off;
        Renderer alone(whole);
        const std::string expected = ask(alone);
        EXPECT_GT(expected.size(), leastLength);
        std::mutex comparing;
        for (const int count : ranks)
            runRanks(count, [&](Communicator& communicator) {
                Renderer renderer(scene, std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
                const std::string answer = ask(renderer);
                const std::lock_guard lock(comparing);
                ASSERT_TRUE(answer == expected)
                    << communicator.rank() << " of " << count << " ranks: " << answer.substr(0, 400)
                    << "\nalone: " << expected.substr(0, 400);
            });
    }

    /// A surface in pieces with vectors of its own, and in a field in bricks; cut out of such a field; and whole in
    /// one.
    std::vector<SceneDescription> scenes()
    {
        TorusPieces fine;
        fine.strips = 1;
        const LicOptions lic = licOf(LicMethod::hierarchical, 8);
        Case own = torus(lic, fine), sampled = torus(lic, fine, "abc:mag"), isosurface = winding(lic),
             slice = make("slice", "slice:10,-6,4:0.2,0.1,1", folder_.file("f.vti"), lic, "p");
        sampled.description.field.spec = "abc:20,20,20";
        // Looked up at points: the triangles of each piece are cut as fine as the field's cells.
        TorusPieces coarse;
        coarse.aroundWedge = 2;
        coarse.aroundTube = 5;
        Case off = torus(lic, coarse, "abc:mag");
        off.description.field.spec = "abc:30,30,30";
        off.description.field.offset = 0.01;
        std::vector<SceneDescription> all;
        for (const Case& each : {own, sampled, isosurface, slice, off}) {
            all.push_back(each.description);
            all.back().run.bricks = BrickChoice::on;
            all.back().run.backend = BackendChoice::cpu;
            all.back().camera = each.camera;
        }
        return all;
    }
};

TEST_F(WholeScenes, PicturesWithLinesAreTheSameBytes)
{
    std::atomic<int> withCutTriangles = 0;
    for (SceneDescription scene : scenes()) {
        scene.shading.overlay = "edges,outline,streamlines:14,separation,topology";
        SceneDescription whole = scene;
        whole.run.bricks = BrickChoice::off;
        const Picture alone = Renderer(whole).render();
        whole.shading.overlay = "none";
        EXPECT_NE(Renderer(whole).render().pixels, alone.pixels);
        for (const int count : {2, 5})
            runRanks(count, [&](Communicator& communicator) {
                Renderer renderer(scene, std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
                const Scene& mine = RendererInternals::scene(renderer);
                EXPECT_TRUE(mine.inPieces || mine.bricked()) << scene.surface.spec;
                const auto& numbers = mine.surface.order;
                if (std::adjacent_find(numbers.begin(), numbers.end()) != numbers.end()) ++withCutTriangles;
                for (int frame = 0; frame < 2; ++frame) {
                    const Picture together = renderer.render();
                    EXPECT_TRUE(!communicator.isRoot() || together.pixels == alone.pixels) << scene.surface.spec;
                }
            });
    }
    EXPECT_GT(withCutTriangles, 0);
}

TEST_F(WholeScenes, TopologyAndLinesAreTheSame)
{
    for (const SceneDescription& scene : scenes()) {
        SCOPED_TRACE(scene.surface.spec);
        expectSameAnswer(
            scene, {2, 5}, [](Renderer& renderer) { return textOf(renderer.topology()); }, 300);
        expectSameAnswer(
            scene, {3}, [](Renderer& renderer) { return textOf(renderer.separation()); }, 2);
        expectSameAnswer(
            scene, {2, 5}, [](Renderer& renderer) { return textOf(renderer.streamlines()); }, 1000);
    }
}

TEST_F(WholeScenes, PixelsShowTheSamePlaces)
{
    const auto pickMany = [](Renderer& renderer) {
        std::string text;
        for (int y = 5; y < 101; y += 13)
            for (int x = 3; x < 130; x += 9) text += textOf(renderer.pick(x, y));
        return text;
    };
    for (const SceneDescription& scene : scenes()) {
        SCOPED_TRACE(scene.surface.spec);
        expectSameAnswer(scene, {2, 5}, pickMany, 4000);
    }
}

/// More ranks than pieces: some hold nothing.
TEST_F(WholeScenes, RanksWithoutAPieceAnswerToo)
{
    SceneDescription scene = torus(licOf(LicMethod::hierarchical, 8)).description;
    scene.run.bricks = BrickChoice::on;
    scene.run.backend = BackendChoice::cpu;
    expectSameAnswer(
        scene, {13}, [](Renderer& renderer) { return textOf(renderer.topology()) + textOf(renderer.pick(60, 50)); },
        20);
}

TEST_F(WholeScenes, WithoutRoomOneLineSaysSo)
{
    Scene scene;
    scene.inPieces = true;
    scene.allTriangles = availableMemoryBytes() / 512;
    EXPECT_NO_THROW(requireRoomForWhole(scene, 1, "--overlay"));
    scene.allTriangles *= 3;
    try {
        requireRoomForWhole(scene, 2, "--overlay");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("--overlay: needs all of the surface on each rank"), std::string::npos)
            << error.what();
    }
    scene.inPieces = false;
    EXPECT_NO_THROW(requireRoomForWhole(scene, 2, "--overlay"));
}

}  // namespace
}  // namespace aeolic
