#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "data/load/field/plane_image.h"

/// --surface image: a field of one layer as it is.
namespace aeolic {
namespace {

/// Samples whose colour says where they are: p = x + 100 y.
struct Plane {
    Plane(std::int64_t across, std::int64_t up, int flat) : width(across), height(up)
    {
        std::array<std::int64_t, 3> dims{1, 1, 1};
        dims[flat == 0 ? 1 : 0] = across;
        dims[flat == 2 ? 1 : 2] = up;
        for (std::int64_t j = 0; j < up; ++j)
            for (std::int64_t i = 0; i < across; ++i) {
                p.push_back(float(i) / float(across - 1));
                for (int k = 0; k < 3; ++k) u.push_back(k == flat ? 0.0F : 1.0F + 0.01F * float(i * j % 7));
            }
        Grid grid;
        grid.dims = dims;
        grid.origin = {3, -2, 0.5};
        grid.spacing = {0.1, 0.1, 0.1};
        grid.pointArrays = {{"U", ArrayView(u.data(), across * up, 3)}, {"p", ArrayView(p.data(), across * up)}};
        data.grid = grid;
    }

    std::int64_t width, height;
    std::vector<float> p, u;
    Data data;
};

SceneDescription sceneOf(const Plane& plane)
{
    SceneDescription scene;
    scene.surface.spec = "image";
    scene.field.spec = "grid in memory";
    scene.field.vectors = "U";
    scene.output.width = int(plane.width);
    scene.output.height = int(plane.height);
    scene.run.backend = BackendChoice::cpu;
    scene.shading.lighting = false;
    scene.shading.scalarBar = false;
    scene.lic.steps = 8;
    return scene;
}

class PlaneImage : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Flat, PlaneImage, testing::Values(0, 1, 2));

TEST_P(PlaneImage, EverySampleIsAPixel)
{
    const Plane plane(41, 23, GetParam());
    SceneDescription scene = sceneOf(plane);
    const auto size = planeSize(scene, plane.data);
    ASSERT_TRUE(size);
    EXPECT_EQ(size->width, 41);
    EXPECT_EQ(size->height, 23);
    scene.lic.method = LicMethod::none;
    scene.shading.colorBy = "p";
    scene.shading.colormap = "gray";
    scene.shading.colorRange = {{0, 1}};
    scene.shading.blend = 1;
    scene.shading.background = "ff0000";
    Renderer renderer(scene, plane.data);
    const Picture picture = renderer.render({scene.camera});
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const std::uint8_t* pixel = &picture.pixels[std::size_t(3 * (y * picture.width + x))];
            ASSERT_EQ(pixel[0], pixel[2]) << "nothing of the background at " << x << ", " << y;
            const int before = x > 0 ? pixel[1 - 3] : 0;
            ASSERT_GE(pixel[1] + 1, before) << "columns go up with x";
        }
    EXPECT_LT(picture.pixels[1], 20);
    EXPECT_GT(picture.pixels[std::size_t(3 * 40 + 1)], 235);
}

/// As a picture of the data's shape: nothing of it is blank, and no sample falls between pixels.
TEST_P(PlaneImage, UnevenSpacingKeepsTheShapeAndEverySample)
{
    Plane plane(41, 23, GetParam());
    SceneDescription scene = sceneOf(plane);
    const int across = GetParam() == 0 ? 1 : 0, up = GetParam() == 2 ? 1 : 2;
    auto& spacing = plane.data.grid->spacing;
    spacing[std::size_t(up)] = 10 * spacing[std::size_t(across)];
    const auto size = planeSize(scene, plane.data);
    ASSERT_TRUE(size);
    EXPECT_EQ(size->width, 41);
    EXPECT_EQ(size->height, 230);
    scene.output.width = size->width;
    scene.output.height = size->height;
    Renderer renderer(scene, plane.data);
    renderer.render({scene.camera});
    EXPECT_EQ(renderer.lastFrame().coveredPixels, 41 * 230);

    spacing[std::size_t(across)] = 0.7 * spacing[std::size_t(up)];  // 28.7 to 23.
    EXPECT_EQ(planeSize(scene, plane.data)->width, 41);
    EXPECT_EQ(planeSize(scene, plane.data)->height, 33);
    spacing[std::size_t(across)] = 10000 * spacing[std::size_t(up)];
    EXPECT_EQ(planeSize(scene, plane.data)->width, 32768);
    EXPECT_EQ(planeSize(scene, plane.data)->height, 2);

    const double infinite = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : {std::pair{infinite, 1.0}, std::pair{1e300, 1e-300}, std::pair{std::nan(""), 1.0}}) {
        spacing[std::size_t(across)] = a;
        spacing[std::size_t(up)] = b;
        EXPECT_EQ(planeSize(scene, plane.data)->width, 41) << "loading says what is wrong";
        EXPECT_EQ(planeSize(scene, plane.data)->height, 23);
    }
}

TEST_P(PlaneImage, LargerPicturesAreFilledToo)
{
    const Plane plane(41, 23, GetParam());
    SceneDescription scene = sceneOf(plane);
    scene.output.width = 123;
    scene.output.height = 69;
    Renderer renderer(scene, plane.data);
    renderer.render({scene.camera});
    EXPECT_EQ(renderer.lastFrame().coveredPixels, 123 * 69);
    scene.camera.azimuth = 10;
    renderer.render({scene.camera});
    EXPECT_LT(renderer.lastFrame().coveredPixels, 123 * 69) << "a camera of one's own counts";
}

TEST(PlaneImages, WhatIsNoPlaneIsRefused)
{
    Plane plane(8, 6, 2);
    SceneDescription scene = sceneOf(plane);
    plane.data.grid->dims = {4, 4, 3};
    EXPECT_THROW(planeSize(scene, plane.data), InputError);
    EXPECT_THROW(Renderer(scene, plane.data), InputError);
    plane.data.grid->dims = {48, 1, 1};
    EXPECT_THROW(planeSize(scene, plane.data), InputError);
    EXPECT_THROW(Renderer(scene, plane.data), InputError);
    plane.data.grid->dims = {40000, 2, 1};
    EXPECT_THROW(planeSize(scene, plane.data), InputError);
    scene.surface.spec = "boundary";
    EXPECT_FALSE(planeSize(scene, plane.data));
    scene.surface.spec = "image";
    scene.field.spec = "abc";
    try {
        Renderer(scene).render({scene.camera});
        FAIL() << "a built-in flow has no samples";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("image"), std::string::npos) << error.what();
    }
}

TEST(PlaneImages, LandIsBlank)
{
    Plane plane(20, 20, 2);
    for (std::size_t i = 0; i < 3 * 20 * 7; ++i) plane.u[i] = std::numeric_limits<float>::quiet_NaN();
    const SceneDescription scene = sceneOf(plane);
    Renderer renderer(scene, plane.data);
    EXPECT_NO_THROW(renderer.render({scene.camera}));
}

/// Half a turn sees the image from behind, still straight: mirrored.
TEST(PlaneImageOrbit, TurnsFromTheStraightView)
{
    const Plane plane(41, 23, 2);
    SceneDescription scene = sceneOf(plane);
    scene.lic.method = LicMethod::none;
    scene.shading.colorBy = "p";
    scene.output.frames = 2;
    Renderer renderer(scene, plane.data);
    const Picture front = renderer.render({AnimationFrame{0}}), back = renderer.render({AnimationFrame{1}});
    EXPECT_EQ(renderer.lastFrame().coveredPixels, 41 * 23);
    for (int x = 2; x < 39; ++x)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(front.pixels[std::size_t(3 * (41 * 11 + x) + c)],
                        back.pixels[std::size_t(3 * (41 * 11 + 40 - x) + c)], 3)
                << x;
}

}  // namespace
}  // namespace aeolic
