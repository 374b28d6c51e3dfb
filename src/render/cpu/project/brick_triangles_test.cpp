#include "render/cpu/project/brick_triangles.h"

#include <gtest/gtest.h>

#include <numeric>

#include "render_testing.h"

namespace aeolic::cpu {
namespace {

/// A field of 8 x 8 x 8 cells of a unit each, from the world's (100, 0, 0), and a triangle about each cell's centre
/// along the x axis.
Scene sceneOfRow()
{
    Scene scene;
    auto field = std::make_shared<GridField>();
    field->dims = {9, 9, 9};
    field->originWorld = {100, 0, 0};
    scene.field = field;
    scene.surface.originWorld = {104, 4, 4};
    for (int i = 0; i < 8; ++i) {
        const auto first = std::uint32_t(scene.surface.positions.size());
        const glm::vec3 center(float(i) - 3.5f, -3.5f, -3.5f);
        for (const glm::vec3& corner : {glm::vec3(-0.2f, 0, 0), glm::vec3(0.2f, 0, 0), glm::vec3(0, 0.2f, 0)})
            scene.surface.positions.push_back(center + corner);
        scene.surface.triangles.push_back({first, first + 1, first + 2});
    }
    return scene;
}

void setBrick(Scene& scene, const GridIndex& lo, const GridIndex& hi)
{
    auto field = std::make_shared<GridField>(*scene.field);
    field->brick = Brick{lo, hi};
    scene.field = field;
}

TEST(BrickTriangles, ThoseOfItsCellsAndNoOthers)
{
    Scene scene = sceneOfRow();
    setBrick(scene, {2, 0, 0}, {5, 8, 8});
    BrickTriangles triangles;
    triangles.update(scene);
    EXPECT_EQ(triangles.reaching(), (std::vector<std::uint32_t>{0, 0, 1, 1, 1, 0, 0, 0}));
    setBrick(scene, {0, 1, 0}, {8, 8, 8});  // Above all of them.
    triangles.update(scene);
    EXPECT_EQ(std::accumulate(triangles.reaching().begin(), triangles.reaching().end(), 0u), 0u);
}

TEST(BrickTriangles, OneAcrossTheFaceIsOfBoth)
{
    Scene scene = sceneOfRow();
    scene.surface.positions[3 * 4].x -= 0.5f;  // The fifth now begins in the fourth's cell.
    BrickTriangles lower, upper;
    setBrick(scene, {0, 0, 0}, {4, 8, 8});
    lower.update(scene);
    setBrick(scene, {4, 0, 0}, {8, 8, 8});
    upper.update(scene);
    EXPECT_EQ(lower.reaching(), (std::vector<std::uint32_t>{1, 1, 1, 1, 1, 0, 0, 0}));
    EXPECT_EQ(upper.reaching(), (std::vector<std::uint32_t>{0, 0, 0, 0, 1, 1, 1, 1}));
}

TEST(BrickTriangles, AllOfThemWithoutBricks)
{
    const Scene scene = sceneOfRow();
    BrickTriangles triangles;
    triangles.update(scene);
    EXPECT_EQ(triangles.reaching(), std::vector<std::uint32_t>(8, 1));
}

TEST(BrickTriangles, AnotherSurfaceIsLookedAtWhenSaidSo)
{
    Scene scene = sceneOfRow();
    setBrick(scene, {0, 0, 0}, {1, 8, 8});
    BrickTriangles triangles;
    triangles.update(scene);
    for (glm::vec3& p : scene.surface.positions) p.x -= 1;  // The second is where the first was.
    triangles.forget();
    triangles.update(scene);
    EXPECT_EQ(triangles.reaching(), (std::vector<std::uint32_t>{0, 1, 0, 0, 0, 0, 0, 0}));
    scene.surface.triangles.pop_back();
    triangles.forget();
    triangles.update(scene);
    EXPECT_EQ(triangles.reaching().size(), 7u);
}

}  // namespace
}  // namespace aeolic::cpu
