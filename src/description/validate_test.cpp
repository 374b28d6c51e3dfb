#include "description/validate.h"

#include <gtest/gtest.h>

#include <limits>

#include "aeolic/error.h"

namespace aeolic {
namespace {

std::string complaint(const SceneDescription& scene, const OptionNaming& naming = jsonName)
{
    try {
        validate(scene, naming);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Validate, DefaultsAreValid)
{
    EXPECT_EQ(complaint({}), "");
}

TEST(Validate, NamesTheFieldAsTheUserWroteIt)
{
    SceneDescription scene;
    scene.lic.steps = -5;
    EXPECT_EQ(complaint(scene), "lic.steps: found -5; expected a whole number from 1 to 65536");
    EXPECT_EQ(complaint(scene, commandLineName), "--steps: found -5; expected a whole number from 1 to 65536");
}

TEST(Validate, RangesIncludeTheirEndsAndNothingBeyond)
{
    SceneDescription scene;
    scene.output.width = 32768;
    scene.output.height = 1;
    scene.lic.steps = 65536;
    scene.lic.step = 8;
    scene.camera.fov = 170;
    EXPECT_EQ(complaint(scene), "");
    scene.output.width = 32769;
    EXPECT_EQ(complaint(scene), "output.width: found 32769; expected a whole number from 1 to 32768");
    scene.output.width = 0;
    EXPECT_EQ(complaint(scene), "output.width: found 0; expected a whole number from 1 to 32768");
}

TEST(Validate, OpenEndIsRefused)
{
    SceneDescription scene;
    scene.lic.step = 0;
    EXPECT_EQ(complaint(scene), "lic.step: found 0; expected a number above 0, up to 8");
    scene.lic.step = 1;
    scene.camera.zoom = 0;
    EXPECT_EQ(complaint(scene), "camera.zoom: found 0; expected a number above 0, up to 1000000");
}

TEST(Validate, NotANumberIsRefusedEverywhere)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    SceneDescription scene;
    scene.shading.blend = nan;
    EXPECT_EQ(complaint(scene), "shading.blend: found nan; expected a number from 0 to 1");
    scene = {};
    scene.shading.colorRange = {0.0, infinity};
    EXPECT_EQ(complaint(scene), "shading.colorRange: found inf; expected a number from -1e+37 to 1e+37");
    scene = {};
    scene.camera.position = {0, nan, 0};
    EXPECT_NE(complaint(scene), "");
    scene = {};
    scene.field.resampleSpacing = infinity;
    EXPECT_EQ(complaint(scene), "field.resampleSpacing: found inf; expected a finite number above 0");
}

TEST(Validate, EnumValueWithoutAName)
{
    SceneDescription scene;
    scene.lic.kernel = Kernel(7);
    EXPECT_EQ(complaint(scene), "lic.kernel: found value 7; expected one of box, hann");
    scene = {};
    scene.run.guard = GuardChoice(5);
    EXPECT_EQ(complaint(scene), "run.guard: found value 5; expected one of bound, estimate");
    scene = {};
    scene.run.guardRows = GuardRowsChoice(3);
    EXPECT_EQ(complaint(scene), "run.guardRows: found value 3; expected one of project, receive, auto");
    scene = {};
    scene.field.precision = FieldPrecision(-1);
    EXPECT_EQ(complaint(scene, commandLineName), "--field-precision: found value -1; expected one of float, half");
}

TEST(Validate, ANameThatIsAlmostRight)
{
    SceneDescription scene;
    scene.shading.colormap = "Viridi";
    EXPECT_EQ(complaint(scene, commandLineName),
              "--colormap: found 'Viridi'; expected one of viridis, turbo, coolwarm, gray, plasma, inferno, magma, "
              "cividis, twilight, RdBu, vik, or a file .json, .xml or .csv; did you mean viridis?");
}

TEST(Validate, ReversedColorRange)
{
    SceneDescription scene;
    scene.shading.colorRange = {3.0, 1.5};
    EXPECT_EQ(complaint(scene, commandLineName),
              "--color-range: found 3,1.5; expected the low end first, and below the high end");
    scene.shading.colorRange = {1.0, 1.0};
    EXPECT_NE(complaint(scene), "");
}

TEST(Validate, CameraThatLooksAtItself)
{
    SceneDescription scene;
    scene.camera.position = {1, 2, 3};
    scene.camera.focal = {1, 2, 3};
    EXPECT_EQ(complaint(scene), "camera.focal: found the camera's position 1,2,3; expected another point, to look at");
}

/// A zoomed view that a page saved is so narrow. From where the whole fits into it, no float tells depths apart.
TEST(Validate, AVeryNarrowViewNeedsAPosition)
{
    SceneDescription scene;
    scene.camera.fov = 0.02;
    EXPECT_EQ(complaint(scene), "camera.fov: found 0.02; expected 1 or more, or a position of the camera");
    scene.camera.position = {1, 2, 3};
    EXPECT_EQ(complaint(scene), "");
    scene.camera.fov = 0;
    EXPECT_EQ(complaint(scene), "camera.fov: found 0; expected a number from 1e-06 to 170");
}

TEST(Validate, NewlineInANameStaysOneLine)
{
    SceneDescription scene;
    scene.shading.colorBy = "p\naeolic: all is well";
    EXPECT_EQ(complaint(scene),
              "shading.colorBy: found 'p\\x0aaeolic: all is well'; expected text without control characters");
}

TEST(Validate, VeryLongTextIsShortened)
{
    SceneDescription scene;
    scene.shading.background = std::string(100000, 'x');
    EXPECT_LT(complaint(scene).size(), 200u);
}

TEST(Validate, BackgroundIsSixDigitsOrTransparent)
{
    SceneDescription scene;
    for (const char* good : {"000000", "fFaA09", "transparent"}) {
        scene.shading.background = good;
        EXPECT_EQ(complaint(scene), "") << good;
    }
    for (const char* bad : {"", "#ffffff", "fffff", "gggggg", "white"}) {
        scene.shading.background = bad;
        EXPECT_NE(complaint(scene), "") << bad;
    }
}

TEST(Validate, AMomentOrARangeOfTime)
{
    SceneDescription scene;
    scene.time.range = {3.0, -1.0};
    EXPECT_EQ(complaint(scene), "") << "time may run backwards";
    scene.time.moment = 0.5;
    EXPECT_EQ(complaint(scene, commandLineName), "--time-range: found together with --time; expected one or the other");
    scene.time = {1e31, std::nullopt};
    EXPECT_EQ(complaint(scene), "time.moment: found 1e+31; expected a number from -1e+30 to 1e+30");
}

}  // namespace
}  // namespace aeolic
