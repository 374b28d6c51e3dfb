#include "render/cpu/project/raster/triangle_groups.h"

#include <gtest/gtest.h>

#include <random>

#include "render/cpu/project/raster/transform.h"
#include "render/cpu/project/scene_arrays.h"
#include "render_testing.h"

namespace aeolic::cpu {
namespace {

using namespace testkit;

/// Boxes of the triangles of visible groups.
std::vector<std::uint32_t> boxesOf(const SceneArrays& arrays, const View& view, const Extent& extent,
                                   const VisibleGroups& visible, std::vector<std::uint32_t>& unsafe)
{
    ScreenVertices screen;
    transformVertices(arrays, view, visible, screen);
    std::vector<TriangleBox> boxes;
    std::vector<std::uint64_t> between(visible.groups());
    visible.forEachRange(0, visible.groups(), [&](std::size_t begin, std::size_t end) {
        setUpTriangles(arrays, screen, begin, end, extent, 0, {boxes, unsafe, between.data()});
    });
    std::vector<std::uint32_t> ids;
    for (const TriangleBox& box : boxes) ids.push_back(box.id);
    return ids;
}

std::size_t triangleCount(const VisibleGroups& visible)
{
    std::size_t count = 0;
    visible.forEachRange(0, visible.groups(), [&](std::size_t begin, std::size_t end) { count += end - begin; });
    return count;
}

/// All groups, whatever the view.
VisibleGroups everything(const SceneArrays& arrays, const View& view)
{
    VisibleGroups all;
    constexpr int kFar = 1 << 28;
    std::vector<TriangleGroup> huge = arrays.groups;
    for (TriangleGroup& group : huge) group.loLocal = glm::vec3(-1e9f), group.hiLocal = glm::vec3(1e9f);
    all.find(huge, arrays.scene->surface.triangles.size(), view, {-kFar, -kFar, kFar, kFar});
    return all;
}

TEST(TriangleGroups, EveryTriangleIsInItsGroupsBoxAndBlocks)
{
    const Scene scene = makeBuiltinScene("teapot:6000", "uniform:2,2,2");
    const SurfaceMesh& mesh = scene.surface;
    const std::vector<TriangleGroup> groups = groupTriangles(mesh);
    ASSERT_EQ(groups.size(), (mesh.triangles.size() + kGroupTriangles - 1) / kGroupTriangles);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (const std::uint32_t point : mesh.triangles[i]) {
            const TriangleGroup& group = groups[i / kGroupTriangles];
            for (int c = 0; c < 3; ++c) {
                ASSERT_LE(group.loLocal[c], mesh.positions[point][c]);
                ASSERT_GE(group.hiLocal[c], mesh.positions[point][c]);
            }
            ASSERT_GE(point / kBlockPoints, group.firstBlock);
            ASSERT_LE(point / kBlockPoints, group.lastBlock);
        }
}

TEST(TriangleGroups, AMeshWithoutTrianglesHasNone)
{
    EXPECT_TRUE(groupTriangles({}).empty());
    VisibleGroups visible;
    visible.find({}, 0, {}, {0, 0, 10, 10});
    EXPECT_EQ(triangleCount(visible), 0u);
}

/// From any side, close by, from within: the triangles found are those found among all, stripe by stripe and column by
/// column.
TEST(TriangleGroups, NoTriangleThatShowsIsMissed)
{
    const Scene scene = makeBuiltinScene("teapot:20000", "uniform:2,2,2");
    const SceneArrays arrays(scene);
    std::mt19937 random(7);
    const auto between = [&](double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(random); };
    for (int i = 0; i < 40; ++i) {
        CameraOptions options;
        options.azimuth = between(0, 360);
        options.elevation = between(-90, 90);
        options.zoom = std::exp(between(-0.5, 4));
        options.fov = between(10, 120);
        const View view = makeView(fitCamera(scene, options, 300, 200), scene, {});
        const VisibleGroups all = everything(arrays, view);
        ASSERT_EQ(triangleCount(all), scene.surface.triangles.size());
        for (const Extent& extent : {Extent{0, 0, 300, 200}, Extent{0, 60, 300, 85}, Extent{0, 199, 300, 200},
                                     Extent{120, 0, 140, 200}, Extent{0, 0, 300, 1}}) {
            VisibleGroups visible;
            visible.find(arrays.groups, scene.surface.triangles.size(), view, extent);
            std::vector<std::uint32_t> unsafe, unsafeOfAll;
            const auto found = boxesOf(arrays, view, extent, visible, unsafe);
            EXPECT_EQ(found, boxesOf(arrays, view, extent, all, unsafeOfAll)) << "view " << i;
            // Triangles before the eye's plane are cut; those that lie behind it altogether leave nothing.
            EXPECT_LE(unsafe.size(), unsafeOfAll.size());
        }
    }
}

/// Eight stripes together look at about as many triangles as one picture does; the rest is along their borders.
TEST(TriangleGroups, AStripeLooksAtItsOwnTriangles)
{
    const Scene scene = makeBuiltinScene("teapot:25000", "uniform:2,2,2");
    const std::vector<TriangleGroup> groups = groupTriangles(scene.surface);
    const std::size_t triangles = scene.surface.triangles.size();
    const View view = makeView(fitCamera(scene, {}, 800, 800), scene, {});
    VisibleGroups visible;
    visible.find(groups, triangles, view, {0, 0, 800, 800});
    EXPECT_EQ(triangleCount(visible), triangles);
    std::size_t sum = 0;
    for (int y = 0; y < 800; y += 100) {
        visible.find(groups, triangles, view, {0, y, 800, y + 100});
        sum += triangleCount(visible);
    }
    EXPECT_LT(double(sum), 2 * double(triangles));
}

}  // namespace
}  // namespace aeolic::cpu
