#include "description/color_scale.h"

#include <gtest/gtest.h>

#include "aeolic/error.h"
#include "description/scene_text.h"
#include "description/validate.h"

namespace aeolic {
namespace {

TEST(ColorScale, BandsAreFromTwoToAsManyAsThereAreColours)
{
    for (const char* text : {"bands:2", "bands:9", "bands:10", "bands:99", "bands:199", "bands:249", "bands:256"})
        EXPECT_TRUE(isBands(text)) << text;
    for (const char* text : {"bands", "bands:", "bands:1", "bands:0", "bands:257", "bands:-3", "bands:+3", "bands:3.5",
                             "bands:03", "bands: 3", "bands:3 ", "Bands:3", "bands:99999999999999999999", "linear"})
        EXPECT_FALSE(isBands(text)) << text;
    EXPECT_EQ(colorScaleOf("bands:17").bands, 17);
    EXPECT_EQ(colorScaleOf("log").kind, ColorScale::Kind::log);
    EXPECT_EQ(colorScaleOf("linear").kind, ColorScale::Kind::linear);
}

TEST(ColorScale, LogBeginsAboveZero)
{
    ShadingOptions shading;
    EXPECT_EQ(shownRange(shading, {-1, 5}), (std::array{-1.0, 5.0}));
    shading.colorScale = "log";
    EXPECT_EQ(shownRange(shading, {0.5, 5}), (std::array{0.5, 5.0}));
    EXPECT_EQ(shownRange(shading, {0, 5}), (std::array{0.005, 5.0}));
    EXPECT_EQ(shownRange(shading, {-7, 5}), (std::array{0.005, 5.0}));
    EXPECT_EQ(shownScale(shading, {-7, 5}).kind, ColorScale::Kind::log);
    shading.colorRange = {{2, 3}};
    EXPECT_EQ(shownRange(shading, {-7, 5}), (std::array{2.0, 3.0}));
}

TEST(ColorScale, DataNowhereAboveZeroKeepTheirRangeOnALinearScale)
{
    ShadingOptions shading;
    shading.colorScale = "log";
    for (const std::array<double, 2>& range : {std::array{-7.0, -1.0}, {-7.0, 0.0}, {0.0, 0.0}}) {
        EXPECT_TRUE(lacksLogarithm(shading, range));
        EXPECT_EQ(shownRange(shading, range), range);
        EXPECT_EQ(shownScale(shading, range).kind, ColorScale::Kind::linear);
    }
    EXPECT_FALSE(lacksLogarithm(shading, {-7, 1e-300}));
    shading.colorRange = {{2, 3}};
    EXPECT_FALSE(lacksLogarithm(shading, {-7, -1})) << "the range that was asked for has one";
    shading.colorRange.reset();
    shading.colorScale = "bands:4";
    EXPECT_FALSE(lacksLogarithm(shading, {-7, -1}));
    EXPECT_EQ(shownScale(shading, {-7, -1}).bands, 4);
}

std::string complaint(const SceneDescription& scene)
{
    try {
        validate(scene, commandLineName);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(ColorScale, ARangeThatTouchesZeroIsRefusedForLog)
{
    SceneDescription scene;
    setOption(scene, "--color-range", "0,10");
    setOption(scene, "--color-scale", "log");
    EXPECT_EQ(complaint(scene), "--color-range: found a low end of 0; expected one above 0, with --color-scale log");
    setOption(scene, "--color-range", "1,10");
    EXPECT_EQ(complaint(scene), "");
    setOption(scene, "--color-scale", "bands:400");
    EXPECT_EQ(complaint(scene),
              "--color-scale: found 'bands:400'; expected one of linear, log, or bands:N, N from 2 to 256");
    setOption(scene, "--color-scale", "linear");
    setOption(scene, "--color-range", "10,1");
    EXPECT_EQ(complaint(scene), "--color-range: found 10,1; expected the low end first, and below the high end");
}

TEST(ColorScale, ColoursAreSixDigits)
{
    for (const char* name : {"--nan-color", "--below-color", "--above-color"}) {
        SceneDescription scene;
        setOption(scene, name, "ff00AA");
        EXPECT_EQ(complaint(scene), "");
        setOption(scene, name, "transparent");
        EXPECT_EQ(complaint(scene),
                  std::string(name) + ": found 'transparent'; expected six hexadecimal digits RRGGBB");
        setOption(scene, name, "ff00a");
        EXPECT_EQ(complaint(scene), std::string(name) + ": found 'ff00a'; expected six hexadecimal digits RRGGBB");
    }
}

}  // namespace
}  // namespace aeolic
