#include <gtest/gtest.h>

#include "data/scene.h"
#include "engine/renderer_internals.h"
#include "memory_scenes_testing.h"

/// A grid in the caller's memory that is looked up on the surface beforehand.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

class MemoryNearWall : public MemoryTest {
protected:
    MemoryNearWall()
    {
        around_.origin = {-1, -0.5, -0.5};
        scene_.field.offset = 0.1;
        scene_.shading.colorBy = "p";
    }

    GridSample around_;
};

TEST_F(MemoryNearWall, AnOffsetWorksAsWithFiles)
{
    const MemorySheet sheet(4);
    const MemoryGrid grid(around_);
    Renderer memory(scene_, Data{sheet.surface(), grid.grid()});
    EXPECT_FALSE(RendererInternals::scene(memory).field) << "the surface carries what the grid has";
    EXPECT_EQ(memory.render({scene_.camera}).pixels, ofFiles(scene_, sheetFile(), gridFile(around_)).pixels);
    SceneDescription nearer = scene_;
    nearer.field.offset = std::nullopt;
    EXPECT_NE(memory.render({scene_.camera}).pixels, ofFiles(nearer, sheetFile(), gridFile(around_)).pixels);
}

TEST_F(MemoryNearWall, EitherMayBeReplaced)
{
    const MemorySheet flat(4), finer(6);  // Of the same size: the camera fits the first surface.
    GridSample shifted = around_;
    shifted.origin[0] -= 0.2;
    shifted.scale = 2;
    const MemoryGrid first(around_), second(shifted);
    scene_.shading.colorRange = {0, 50};
    Renderer renderer(scene_, Data{flat.surface(), first.grid()});
    const auto expect = [&](const MemorySheet& sheet, const MemoryGrid& grid, const char* what) {
        EXPECT_EQ(renderer.render({scene_.camera}).pixels, ofMemory(scene_, Data{sheet.surface(), grid.grid()}).pixels)
            << what;
    };
    renderer.setData({{}, second.grid()});
    expect(flat, second, "another grid");
    renderer.setData({finer.surface(), {}});
    expect(finer, second, "another surface, with the other grid");
    renderer.setData({{}, first.grid()});
    expect(finer, first, "the grid again, on the other surface");
    renderer.setData({flat.surface(), second.grid()});
    expect(flat, second, "both");

    Grid wrong = first.grid();
    wrong.pointArrays.pop_back();
    EXPECT_THROW(renderer.setData({{}, wrong}), InputError) << "no array to colour by";
    expect(flat, second, "nothing has changed");
}

TEST_F(MemoryNearWall, AtRestOnTheSurface)
{
    scene_.field.offset = std::nullopt;
    scene_.shading.colorBy.clear();
    MemoryGrid grid(around_);
    for (std::size_t i = 0; i < grid.p.size(); ++i) {  // A wall without slip within the grid, at its third layer.
        const std::size_t layer = i / std::size_t(around_.dims[0] * around_.dims[1]);
        for (std::size_t c = 0; c < 3 && layer == 2; ++c) grid.u[3 * i + c] = 0;
    }
    const std::vector<float> points{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const std::vector<std::int32_t> triangles{0, 1, 2, 0, 2, 3};
    Surface wall;
    wall.points = ArrayView(points.data(), 4, 3);
    wall.triangles = ArrayView(triangles.data(), 2, 3);
    const Renderer renderer(scene_, Data{wall, grid.grid()});
    ASSERT_FALSE(RendererInternals::scene(renderer).field);
    for (const glm::vec3& v : RendererInternals::scene(renderer).surface.pointVectors) EXPECT_GT(glm::length(v), 0.1f);
}

}  // namespace
}  // namespace aeolic
