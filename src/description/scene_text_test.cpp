#include "description/scene_text.h"

#include <gtest/gtest.h>

#include <functional>

#include "aeolic/error.h"

namespace aeolic {
namespace {

std::string complaint(const std::function<void(SceneDescription&)>& change)
{
    SceneDescription scene;
    try {
        change(scene);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(SceneText, NumbersAreReadWhole)
{
    SceneDescription scene;
    setOption(scene, "--steps", "+64");
    EXPECT_EQ(scene.lic.steps, 64);
    setOption(scene, "--steps", "1e3");
    EXPECT_EQ(scene.lic.steps, 1000);
    setOption(scene, "--step", "-.5");
    EXPECT_EQ(scene.lic.step, -0.5);
    for (const char* bad : {"", " ", "1 ", "1x", "0x10", "nan", "inf", "1e999", "1,5", "--1", "+-1", "3.5"})
        EXPECT_NE(complaint([&](auto& s) { setOption(s, "--steps", bad); }), "") << "'" << bad << "'";
}

TEST(SceneText, AnOffsetIsALengthOrAuto)
{
    SceneDescription scene;
    setOption(scene, "--offset", "-0.5");
    EXPECT_EQ(scene.field.offset, -0.5);
    setOption(scene, "--offset", "auto");
    EXPECT_FALSE(scene.field.offset);
    for (const char* wrong : {"nan", "inf", "far", "", "Auto"})
        EXPECT_NE(complaint([&](auto& s) { setOption(s, "--offset", wrong); }).find("auto or a number"),
                  std::string::npos)
            << wrong;
    EXPECT_NE(complaint([](auto& s) { setOption(s, "--resample-spacing", "auto"); }), "");
}

TEST(SceneText, WholeNumbersBeyondTheTypeAreRefusedBeforeTheyWrap)
{
    EXPECT_EQ(complaint([](auto& s) { setOption(s, "--seed", "4294967296"); }),
              "--seed: found 4294967296; expected a whole number from 0 to 4294967295");
    EXPECT_NE(complaint([](auto& s) { setOption(s, "--threads", "1e300"); }), "");
}

std::string surfacesOfText(const SceneDescription& scene)
{
    std::string text = scene.surface.spec;
    for (const SurfaceItem& item : scene.surfaces) text += " " + item.spec + (item.streaks ? "" : "(context)");
    return text;
}

TEST(SceneText, SurfacesAndContextsAreOneListAndASingleSurfaceIsNone)
{
    SceneDescription scene;
    setSurfaces(scene, {"a"}, {});
    EXPECT_EQ(surfacesOfText(scene), "a");
    setSurfaces(scene, {"a", "b"}, {"c"});
    EXPECT_EQ(surfacesOfText(scene), "a a b c(context)");
    EXPECT_EQ(scene.surfaces[2].colorBy, "");
    setSurfaces(scene, {}, {"d"});
    EXPECT_EQ(surfacesOfText(scene), "a a b c(context) d(context)") << "what a scene file lists stays";
    setSurfaces(scene, {"e"}, {"f"});
    EXPECT_EQ(surfacesOfText(scene), "e e f(context)");
    setSurfaces(scene, {}, {});
    EXPECT_EQ(surfacesOfText(scene), "e e f(context)");
    setOption(scene, "--surface", "g");
    EXPECT_EQ(surfacesOfText(scene), "g");
    setOption(scene, "--context", "h");
    EXPECT_EQ(surfacesOfText(scene), "g g h(context)");
}

TEST(SceneText, TheTextOfAFieldReadsBackAsTheSame)
{
    SceneDescription scene;
    for (const auto& [option, text] : {std::pair{"--steps", "7"},
                                       {"--step", "0.1"},
                                       {"--lighting", "off"},
                                       {"--kernel", "hann"},
                                       {"--color-range", "-1e-07,3"},
                                       {"--camera up", "0,1,0"},
                                       {"--color-by", "U:mag"}}) {
        setOption(scene, option, text);
        EXPECT_EQ(optionText(scene, option), text);
    }
    EXPECT_EQ(optionText(SceneDescription{}, "--color-range"), "");
}

TEST(SceneText, AnOptionIsTakenFromAnotherScene)
{
    SceneDescription scene, from;
    scene.shading.colorRange = {1, 2};
    scene.shading.title = "A";
    scene.lic.steps = 7;
    from.output.width = from.output.height = 99;
    for (const char* name : {"--color-range", "--title", "--size"}) takeOption(scene, from, name);
    EXPECT_FALSE(scene.shading.colorRange);
    EXPECT_EQ(scene.shading.title, "");
    EXPECT_EQ(scene.output.width, 99);
    EXPECT_EQ(scene.output.height, 99);
    EXPECT_EQ(scene.lic.steps, 7);
    takeOption(scene, from, "--step");
    EXPECT_EQ(scene.lic.steps, 7) << "its name only begins with that";
}

TEST(SceneText, Size)
{
    SceneDescription scene;
    setOption(scene, "--size", "1920x1080");
    EXPECT_EQ(scene.output.width, 1920);
    EXPECT_EQ(scene.output.height, 1080);
    for (const char* bad : {"", "x", "10", "10x", "x10", "10x10x10", "10X10", "10 x 10", "10*10"})
        EXPECT_EQ(complaint([&](auto& s) { setOption(s, "--size", bad); }),
                  "--size: found '" + std::string(bad) + "'; expected WIDTHxHEIGHT in pixels, each from 1 to 32768");
    EXPECT_EQ(complaint([](auto& s) { setOption(s, "--size", "0x100"); }),
              "--size width: found 0; expected a whole number from 1 to 32768");
}

TEST(SceneText, CameraItemsEndAtSemicolonsAndAtCommasBeforeNames)
{
    for (const char* text :
         {"position=1,2,3;focal=0,-1,0;up=0,0,1;fov=30", "position=1,2,3,focal=0,-1,0,up=0,0,1,fov=30",
          "fov=30, up=0, 0, 1; position= 1,2,3 ;focal=0,-1,0;"}) {
        SceneDescription scene;
        setOption(scene, "--camera", text);
        EXPECT_EQ(scene.camera.position, (Vec3{1, 2, 3})) << text;
        EXPECT_EQ(scene.camera.focal, (Vec3{0, -1, 0})) << text;
        EXPECT_EQ(scene.camera.up, (Vec3{0, 0, 1})) << text;
        EXPECT_EQ(scene.camera.fov, 30) << text;
    }
    SceneDescription scene;
    setOption(scene, "--camera", "azimuth=-45,zoom=1.5");
    EXPECT_EQ(scene.camera.azimuth, -45);
    EXPECT_EQ(scene.camera.zoom, 1.5);
    EXPECT_EQ(scene.camera.elevation, CameraOptions{}.elevation);
}

TEST(SceneText, CameraFaults)
{
    const auto camera = [](const char* text) { return complaint([&](auto& s) { setOption(s, "--camera", text); }); };
    EXPECT_EQ(camera("azimuth=x"), "--camera azimuth: found 'x'; expected a number from -1000000 to 1000000");
    EXPECT_EQ(camera("position=1,2"), "--camera position: found '1,2'; expected 3 numbers separated by commas");
    EXPECT_EQ(camera("zoom=2,zoom=3"), "--camera zoom: found twice; expected it once");
    EXPECT_EQ(camera("azimuth=1,position=1,2,3"), "--camera: found angles and a position; expected one or the other");
    EXPECT_EQ(camera("position=1,2,3;zoom=2"), "--camera: found a zoom and a position; expected one or the other");
    EXPECT_EQ(camera("azimuth=50 elevation=20"),
              "--camera azimuth: found '50 elevation=20'; expected a number from -1000000 to 1000000");
    EXPECT_EQ(camera("azimuth").find("did you mean"), std::string::npos) << "what was typed already";
    EXPECT_EQ(camera("azimut=3"),
              "--camera: found 'azimut=3'; expected name=value with the names azimuth, elevation, roll, zoom, fov, "
              "position, focal, up; did you mean azimuth?");
    for (const char* bad : {"", "azimuth", "tilt=3", "=3", ",", ";;", "position=1,2,3,4", "azimuth=1,,zoom=2"})
        EXPECT_NE(camera(bad), "") << bad;
}

TEST(SceneText, AnglesTurnAnAbsoluteViewOfTheFileIntoARelativeOne)
{
    SceneDescription scene;
    scene.camera.position = Vec3{1, 2, 3};
    setOption(scene, "--camera", "fov=40");
    EXPECT_TRUE(scene.camera.position);
    setOption(scene, "--camera", "azimuth=40");
    EXPECT_FALSE(scene.camera.position);
}

}  // namespace
}  // namespace aeolic
