#include "render/view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render_testing.h"

namespace aeolic {
namespace {

using namespace testkit;

Scene cubeScene()
{
    Scene scene = makeScene(makeCube({0, 0, 0}, 1));
    scene.surface.pointVectors.assign(scene.surface.positions.size(), glm::vec3(1, 0.25f, 0));
    return scene;
}

View viewOf(const Scene& scene, double zoom, double stepPx)
{
    CameraOptions camera;
    camera.zoom = zoom;
    LicOptions lic;
    lic.step = stepPx;
    return makeView(fitCamera(scene, camera, 200, 200), scene, lic);
}

}  // namespace

TEST(View, WalksAStepAsItIsWhereTheImageShowsItShort)
{
    const Scene scene = cubeScene();
    const View view = viewOf(scene, 1, 1);
    EXPECT_EQ(view.stepParts, 1);
    LicOptions lic;
    lic.steps = 37;
    EXPECT_EQ(inShortSteps(lic, view).steps, 37);
    EXPECT_EQ(inShortSteps(lic, view).step, 1);
}

TEST(View, SplitsStepsThatTheImageWouldShowTooLong)
{
    const Scene scene = cubeScene();
    for (const double zoom : {1.0, 1.5, 2.0, 2.5})
        for (const double stepPx : {0.5, 1.0, 2.0, 3.0}) {
            SCOPED_TRACE(testing::Message() << "zoom " << zoom << ", step " << stepPx);
            const View view = viewOf(scene, zoom, stepPx), unit = viewOf(scene, zoom, 0.01);
            const double longest = double(unit.maxStepPx) * 100 * stepPx;
            EXPECT_EQ(view.stepParts, std::clamp(int(std::ceil(longest / double(kLongestStepPx))), 1, kMostStepParts));
            EXPECT_LE(view.maxStepPx, kLongestStepPx);
            EXPECT_NEAR(double(view.stepLocal) * view.stepParts, double(unit.stepLocal) * 100 * stepPx, 1e-6);
            LicOptions lic;
            lic.steps = 20;
            lic.step = stepPx;
            const LicOptions walked = inShortSteps(lic, view);
            EXPECT_EQ(walked.steps, 20 * view.stepParts);
            EXPECT_NEAR(walked.steps * walked.step, 20 * stepPx, 1e-12) << "as far as before";
        }
    EXPECT_GT(viewOf(scene, 2.5, 1).stepParts, 1);
}

/// From within the mesh a surface may be as near as can be: no more parts then, and guard rows stay as few.
TEST(View, GivesNearestSurfacesShorterStepsRatherThanMoreParts)
{
    const View view = viewOf(cubeScene(), 100, 8);
    EXPECT_EQ(view.stepParts, kMostStepParts);
    EXPECT_EQ(view.maxStepPx, kLongestStepPx);
}

/// A view from close by is the one with shorter and more steps asked for, bit by bit.
TEST(View, ACloseViewIsThatOfShorterSteps)
{
    const Scene scene = cubeScene();
    CameraOptions close;
    close.zoom = 2.5;
    const Camera camera = fitCamera(scene, close, 120, 90);
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
        LicOptions asked;
        asked.method = method;
        asked.steps = 24;
        const LicOptions shorter = inShortSteps(asked, makeView(camera, scene, asked));
        ASSERT_GT(shorter.steps, asked.steps);
        Stages one("cpu", scene), other("cpu", scene);
        one.project(camera, asked);
        other.project(camera, shorter);
        const Image<float>&a = one.convolve(asked), &b = other.convolve(shorter);
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x) ASSERT_EQ(a.at(x, y), b.at(x, y)) << x << "," << y;
    }
}

}  // namespace aeolic
