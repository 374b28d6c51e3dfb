#include "render/brick_image.h"

#include <gtest/gtest.h>

#include "render_testing.h"

namespace aeolic {
namespace {

using namespace testkit;

constexpr int kWidth = 200, kHeight = 120;

GridField fieldAround(const Scene& scene)
{
    GridField field;
    field.dims = {9, 9, 9};
    field.originWorld = scene.boundsWorld.lo;
    field.spacingWorld = (scene.boundsWorld.hi - scene.boundsWorld.lo) / 8.0;
    return field;
}

TEST(BrickImage, WithoutBricksIsAllOfTheImage)
{
    const Scene scene = makeBuiltinScene("sphere:500", "rotation:8,8,8");
    const View view = makeView(fitCamera(scene, {}, kWidth, kHeight), scene, {});
    EXPECT_EQ(imageOf(fieldAround(scene), scene.surface.originWorld, view), (Extent{0, 0, kWidth, kHeight}));
}

/// Whatever is seen of a brick lies in its rectangle: checked with points inside the brick.
TEST(BrickImage, HoldsEveryPointOfTheBrick)
{
    const Scene scene = makeBuiltinScene("sphere:500", "rotation:8,8,8");
    for (const double azimuth : {0.0, 33.0, 190.0}) {
        CameraOptions options;
        options.azimuth = azimuth;
        options.zoom = 1.7;
        const Camera camera = fitCamera(scene, options, kWidth, kHeight);
        const View view = makeView(camera, scene, {});
        int smaller = 0;
        for (int rank = 0; rank < 8; ++rank) {
            GridField field = fieldAround(scene);
            field.brick = brickOf(field, {rank, 8});
            const Extent seen = imageOf(field, scene.surface.originWorld, view);
            smaller += seen.width() * seen.height() < kWidth * kHeight * 2 / 3;
            for (int k = 0; k < 9 * 9 * 9; ++k) {
                const glm::dvec3 part{k % 9 / 8.0, k / 9 % 9 / 8.0, k / 81 / 8.0};
                glm::dvec3 world;
                for (int c = 0; c < 3; ++c) {
                    const auto a = std::size_t(c);
                    const double cell = double(field.brick->cellLo[a]) +
                                        part[c] * double(field.brick->cellHi[a] - field.brick->cellLo[a]);
                    world[c] = field.originWorld[c] + cell * field.spacingWorld[c];
                }
                const glm::dvec3 at = testkit::imageOf(camera, world);
                const int x = int(std::lround(at.x)), y = int(std::lround(at.y));
                const bool inImage = x >= 0 && y >= 0 && x < kWidth && y < kHeight;
                ASSERT_TRUE(!inImage || seen.contains(x, y)) << x << ", " << y;
            }
        }
        EXPECT_GE(smaller, 4) << "the rectangles save nothing";
    }
}

TEST(BrickImage, BehindTheEyeIsAllOfTheImageAndNothingIsNothing)
{
    const Scene scene = makeBuiltinScene("sphere:500", "rotation:8,8,8");
    CameraOptions inside;
    inside.position = Vec3{0, 0, 0};
    inside.focal = Vec3{1, 0, 0};
    const View view = makeView(fitCamera(scene, inside, kWidth, kHeight), scene, {});
    GridField field = fieldAround(scene);
    field.brick = Brick{{0, 0, 0}, {8, 8, 8}};
    EXPECT_EQ(imageOf(field, scene.surface.originWorld, view), (Extent{0, 0, kWidth, kHeight}));
    field.brick = Brick{};
    EXPECT_TRUE(imageOf(field, scene.surface.originWorld, view).empty());
}

}  // namespace
}  // namespace aeolic
