#include "engine/picture_warnings.h"

#include <gtest/gtest.h>

#include <limits>

#include "aeolic/error.h"
#include "aeolic/renderer.h"

namespace aeolic {
namespace {

using Lines = std::vector<std::string>;

/// A triangle with the values of `p` at its corners, and a flow.
struct Triangle {
    explicit Triangle(std::vector<float> values) : p(std::move(values))
    {
        Surface surface;
        surface.points = ArrayView(points.data(), 3, 3);
        surface.triangles = ArrayView(corners.data(), 1, 3);
        surface.pointArrays = {{"U", ArrayView(u.data(), 3, 3)}, {"p", ArrayView(p.data(), 3)}};
        data.surface = surface;
    }

    std::vector<float> points{0, 0, 0, 1, 0, 0, 0, 0, 1}, u{1, 0, 0, 1, 0, 0, 1, 0, 0}, p;
    std::vector<std::int32_t> corners{0, 1, 2};
    Data data;
};

SceneDescription sceneOfTriangle()
{
    SceneDescription scene;
    scene.surface.spec = "surface in memory";
    scene.field.vectors = "U";
    scene.shading.colorBy = "p";
    scene.shading.colorScale = "log";
    scene.output.width = scene.output.height = 300;
    scene.run.backend = BackendChoice::cpu;
    return scene;
}

const char* const kNoLogarithm =
    "surface in memory: 'p' is nowhere above 0, as --color-scale log needs it: its colours are on a linear scale";
const char* const kNoRoom =
    "the picture has no room for the legend: a larger --size or a smaller --text-scale may give it";

TEST(PictureWarnings, DataNowhereAboveZeroHaveNoLogarithm)
{
    const Triangle below({-3, -2, -1}), touching({-3, -2, 0}), above({-3, -2, 1});
    const SceneDescription scene = sceneOfTriangle();
    EXPECT_EQ(Renderer(scene, below.data).info().warnings, Lines{kNoLogarithm});
    EXPECT_EQ(Renderer(scene, touching.data).info().warnings, Lines{kNoLogarithm});
    EXPECT_EQ(Renderer(scene, above.data).info().warnings, Lines{});
}

TEST(PictureWarnings, ACharacterThatTheFontHasNotIsTold)
{
    const Triangle above({1, 2, 3});
    SceneDescription scene = sceneOfTriangle();
    scene.shading.title = "Wirbel 渦度";
    scene.shading.legend = "速 [m/s]";
    EXPECT_EQ(Renderer(scene, above.data).info().warnings,
              (Lines{"the title: the font has no picture of '渦度': boxes stand for that",
                     "the legend: the font has no picture of '速': boxes stand for that"}));
    scene.shading.title = "Größe ∇·u";
    scene.shading.legend = "ρ";
    EXPECT_EQ(Renderer(scene, above.data).info().warnings, Lines{});
}

TEST(PictureWarnings, SuchDataAreDrawnOnALinearScale)
{
    const Triangle below({-3, -2, -1});
    SceneDescription scene = sceneOfTriangle();
    const Picture logarithmic = Renderer(scene, below.data).render({scene.camera});
    scene.shading.colorScale = "linear";
    EXPECT_EQ(logarithmic.pixels, Renderer(scene, below.data).render({scene.camera}).pixels);
}

TEST(PictureWarnings, FollowTheOptionsBetweenPictures)
{
    const Triangle below({-3, -2, -1});
    SceneDescription scene = sceneOfTriangle();
    scene.shading.colorScale = "linear";
    Renderer renderer(scene, below.data);
    EXPECT_EQ(renderer.info().warnings, Lines{});
    scene.shading.colorScale = "log";
    renderer.setShading(scene.shading);
    EXPECT_EQ(renderer.info().warnings, Lines{kNoLogarithm});
    renderer.setSize(100, 100);
    EXPECT_EQ(renderer.info().warnings, (Lines{kNoLogarithm, kNoRoom}));
    scene.shading.colorRange = {{1, 2}};
    renderer.setShading(scene.shading);
    EXPECT_EQ(renderer.info().warnings, Lines{kNoRoom});
    scene.shading.scalarBar = false;
    renderer.setShading(scene.shading);
    EXPECT_EQ(renderer.info().warnings, Lines{});
    scene.shading.scalarBar = true;
    scene.shading.textScale = 4;
    renderer.setSize(300, 300);
    renderer.setShading(scene.shading);
    EXPECT_EQ(renderer.info().warnings, Lines{kNoRoom});
}

/// Viewers get those of the data with the scene, and the others with each picture.
TEST(PictureWarnings, FollowThoseOfTheData)
{
    const Triangle odd({-3, -2, std::numeric_limits<float>::quiet_NaN()});
    SceneDescription scene = sceneOfTriangle();
    Renderer renderer(scene, odd.data);
    ASSERT_EQ(renderer.info().warnings.size(), 2u);
    EXPECT_EQ(renderer.info().dataWarnings, 1u);
    EXPECT_EQ(renderer.info().warnings[1], kNoLogarithm);
    renderer.setSize(100, 100);
    EXPECT_EQ(renderer.info().warnings.size(), 3u);
    EXPECT_EQ(renderer.info().dataWarnings, 1u);
    scene.shading.scalarBar = false;
    scene.shading.colorScale = "linear";
    renderer.setShading(scene.shading);
    EXPECT_EQ(renderer.info().warnings.size(), 1u);
    EXPECT_EQ(renderer.info().dataWarnings, 1u);
}

/// A viewer's options come with each of its pictures, mostly the same: nothing is laid out anew for them.
TEST(PictureWarnings, AreNotFoundAnewForTheSameOptions)
{
    const Triangle below({-3, -2, -1});
    SceneDescription scene = sceneOfTriangle();
    Renderer renderer(scene, below.data);
    const std::string* const told = renderer.info().warnings.data();
    renderer.setShading(scene.shading);
    renderer.setSize(300, 300);
    EXPECT_EQ(renderer.info().warnings.data(), told);
    scene.shading.blend = 0.5;
    renderer.setShading(scene.shading);
    EXPECT_NE(renderer.info().warnings.data(), told);
    EXPECT_EQ(renderer.description().shading.blend, 0.5);
}

TEST(PictureWarnings, AMaskAboveTheLongestVectorLeavesNoStreak)
{
    const Triangle triangle({1, 2, 3});
    SceneDescription scene = sceneOfTriangle();
    Renderer renderer(scene, triangle.data);
    scene.lic.maskBelow = 1;
    renderer.setLic(scene.lic);
    EXPECT_EQ(renderer.info().warnings, Lines{}) << "vectors of that length show";
    scene.lic.maskBelow = 2.5;
    renderer.setLic(scene.lic);
    const Lines masked{"surface in memory: no streaks show: the longest vector is 1, and --mask-below 2.5"};
    EXPECT_EQ(renderer.info().warnings, masked);
    EXPECT_EQ(renderer.info().dataWarnings, 0u);
    EXPECT_EQ(Renderer(scene, triangle.data).info().warnings, masked);
    scene.lic.method = LicMethod::none;
    renderer.setLic(scene.lic);
    EXPECT_EQ(renderer.info().warnings, Lines{});
}

TEST(PictureWarnings, StayWhereOptionsAreRefused)
{
    const Triangle below({-3, -2, -1});
    SceneDescription scene = sceneOfTriangle();
    scene.output.width = scene.output.height = 100;
    Renderer renderer(scene, below.data);
    scene.shading.colormap = "/nowhere/missing.json";
    scene.shading.scalarBar = false;
    scene.shading.colorScale = "linear";
    EXPECT_THROW(renderer.setShading(scene.shading), InputError);
    EXPECT_EQ(renderer.info().warnings, (Lines{kNoLogarithm, kNoRoom}));
    EXPECT_EQ(renderer.description().shading.colormap, "viridis");
    EXPECT_TRUE(renderer.description().shading.scalarBar);
}

}  // namespace
}  // namespace aeolic
