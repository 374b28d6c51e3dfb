#include "data/color_map/color_map_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "aeolic/error.h"

/// Colour maps out of files, as ParaView and spreadsheets write them, and as nobody should.
namespace aeolic {
namespace {

namespace fs = std::filesystem;

class ColorMapFile : public testing::Test {
protected:
    ColorMapFile()
        : folder_(fs::temp_directory_path() /
                  ("aeolic_maps_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name())))
    {
        fs::create_directories(folder_);
    }
    ~ColorMapFile() override { fs::remove_all(folder_); }

    std::string write(const std::string& name, const std::string& text) const
    {
        const std::string path = (folder_ / name).string();
        std::ofstream(path, std::ios::binary) << text;
        return path;
    }
    ColorMap load(const std::string& name, const std::string& text) const { return loadColorMap(write(name, text)); }
    /// The complaint without the path.
    std::string complaint(const std::string& name, const std::string& text) const
    {
        const std::string path = write(name, text);
        try {
            loadColorMap(path);
        } catch (const InputError& error) {
            const std::string what = error.what();
            EXPECT_TRUE(what.starts_with(path)) << what;
            EXPECT_EQ(what.find('\n'), std::string::npos) << what;
            return what.substr(std::min(path.size(), what.size()));
        }
        return "";
    }

    fs::path folder_;
};

constexpr const char* coolToWarm = R"([{"ColorSpace": "Diverging", "Name": "Cool to Warm", "NanColor": [1, 1, 0],
    "RGBPoints": [0, 0.231373, 0.298039, 0.752941, 0.5, 0.865003, 0.865003, 0.865003, 1, 0.705882, 0.0156863, 0.14902]}])";

TEST_F(ColorMapFile, ParaViewsJsonGivesParaViewsColours)
{
    const ColorMap map = load("map.json", coolToWarm);
    // The built-in table is the same map, computed elsewhere.
    for (std::size_t i = 0; i < 256; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(map.colors[i][c], colorMap("coolwarm")[i][c], 2) << i << " " << c;
    EXPECT_EQ(map.nan, (Color{255, 255, 0}));
    EXPECT_FALSE(map.below || map.above);
}

TEST_F(ColorMapFile, DivergingAloneFindsItsWhite)
{
    const ColorMap map = load("two.json", R"({"ColorSpace": "Diverging", "RGBPoints": [-3, 0.231373, 0.298039, 0.752941,
        5, 0.705882, 0.0156863, 0.14902]})");
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(map.colors[128][c], 221, 3);
}

TEST_F(ColorMapFile, EverySpace)
{
    const auto middle = [&](const std::string& space, const std::string& points) {
        return load("s.json", "{\"ColorSpace\": \"" + space + "\", \"RGBPoints\": [" + points + "]}").colors[128];
    };
    EXPECT_EQ(middle("RGB", "0,0,0,0, 1,1,1,1"), (Color{128, 128, 128}));
    EXPECT_EQ(middle("Lab", "0,0,0,0, 1,1,1,1"), middle("CIELAB", "0,0,0,0, 1,1,1,1"));
    EXPECT_NEAR(middle("Lab", "0,0,0,0, 1,1,1,1")[0], 119, 2) << "lightness 50";
    const Color around = middle("HSV", "0,1,0,0, 1,0,0,1"), wrapped = middle("Wrapped", "0,1,0,0, 1,0,0,1");
    EXPECT_GT(around[1], 250) << "from red to blue by green";
    EXPECT_EQ(wrapped[1], 0) << "from red to blue by magenta";
    EXPECT_GT(std::min(wrapped[0], wrapped[2]), 240);
}

TEST_F(ColorMapFile, ColoursBeyondTheRangeWhereTheyAreSwitchedOn)
{
    const std::string points =
        "\"RGBPoints\": [0,0,0,0, 1,1,1,1], \"BelowRangeColor\": [0, 0, 1], "
        "\"AboveRangeColor\": [1, 0, 0], \"UseBelowRangeColor\": 1";
    const ColorMap map = load("map.json", "{" + points + ", \"UseAboveRangeColor\": 0}");
    EXPECT_EQ(map.below, (Color{0, 0, 255}));
    EXPECT_FALSE(map.above);
}

TEST_F(ColorMapFile, Xml)
{
    const ColorMap map = load("map.xml", R"(<ColorMaps><ColorMap name="x" space="RGB" indexedLookup="false">
        <Point x="-1" o="0" r="0" g="0" b="0"/><Point x="1" o="0.5" r="1" g="0.4" b="0"/>
        <NaN r="0" g="1" b="0"/></ColorMap></ColorMaps>)");
    EXPECT_EQ(map.colors.front(), (Color{0, 0, 0}));
    EXPECT_EQ(map.colors.back(), (Color{255, 102, 0}));
    EXPECT_EQ(map.colors[51], (Color{51, 20, 0}));
    EXPECT_EQ(map.nan, (Color{0, 255, 0}));
}

TEST_F(ColorMapFile, CsvInBothUnitsWithAndWithoutValues)
{
    const Color middle{128, 64, 0};
    EXPECT_EQ(load("a.csv", "0,0,0\n1,0.5,0\n").colors[128], middle);
    EXPECT_EQ(load("b.csv", "r;g;b\r\n0;0;0\r\n255;128;0\r\n").colors[128], middle);
    EXPECT_EQ(load("c.CSV", "\xef\xbb\xbf# mine\nvalue,r,g,b\n\n-5,0,0,0\n\n7,1,.5,0").colors[128], middle);
    EXPECT_EQ(load("d.csv", "0 0 0\n 255\t128  0\n").colors[128], middle);
}

TEST_F(ColorMapFile, PointsAreSortedAndDoubleOnesJump)
{
    const ColorMap map = load("map.csv", "1,1,1,1\n0,0,0,0\n0.5,0,0,1\n0.5,1,0,0\n");
    EXPECT_EQ(map.colors.front(), (Color{0, 0, 0}));
    EXPECT_EQ(map.colors.back(), (Color{255, 255, 255}));
    EXPECT_GT(map.colors[127][2], 250);
    EXPECT_EQ(map.colors[127][0], 0);
    EXPECT_GT(map.colors[128][0], 250) << "the second of the two begins here";
    EXPECT_LT(map.colors[128][2], 5);
    const ColorMap ends = load("ends.csv", "0,1,0,0\n0,0,1,0\n1,0,0,1\n1,1,1,1\n");
    EXPECT_EQ(ends.colors.front(), (Color{0, 255, 0}));
    EXPECT_EQ(ends.colors.back(), (Color{255, 255, 255}));
}

TEST_F(ColorMapFile, AMillionPoints)
{
    std::string text;
    for (int i = 0; i < 1000000; ++i) text += std::to_string(i) + (i % 2 ? ",1,1,1\n" : ",0.5,0.5,0.5\n");
    const ColorMap map = load("map.csv", text);
    for (const Color& color : map.colors) EXPECT_TRUE(color[0] >= 127) << int(color[0]);
}

TEST_F(ColorMapFile, TheWidestValuesDoNotOverflow)
{
    const ColorMap map = load("map.csv", "-1.7e308,0,0,0\n1.7e308,1,1,1\n");
    EXPECT_NEAR(map.colors[128][0], 128, 1);
}

TEST_F(ColorMapFile, BadOnesAreRefusedInOneLine)
{
    const std::string twoOrMore = "; expected a colour map: colours at two values or more";
    EXPECT_EQ(complaint("a.csv", ""), ": found 0 points" + twoOrMore);
    EXPECT_EQ(complaint("b.csv", "0,0,0\n"), ": found 1 point" + twoOrMore);
    EXPECT_EQ(complaint("c.csv", "3,0,0,0\n3,1,1,1\n"), ": found 2 points, all at 3" + twoOrMore);
    EXPECT_EQ(complaint("d.csv", "0,0,0\n0,1\n"), ": line 2: found 2 values; expected 3, as before");
    EXPECT_EQ(complaint("e.csv", "0,0,0,0,1\n"), ": line 1: found 5 values; expected r,g,b or value,r,g,b");
    EXPECT_EQ(complaint("f.csv", "0,0,0\n0,nan,1\n"), ": line 2: found 'nan'; expected a number");
    EXPECT_EQ(complaint("g.csv", "0,0,0\n0,1,256\n"),
              ": line 2: found a colour of 256; expected parts from 0 to 1, or from 0 to 255");
    EXPECT_EQ(complaint("h.csv", "0,0,0\n0,-0.1,1\n"),
              ": line 2: found a colour of -0.1; expected parts from 0 to 1, or from 0 to 255");
    EXPECT_EQ(complaint("i.json", "[{"),
              ": it is not well-formed JSON at byte 3; expected a colour map as ParaView "
              "exports it: [{\"RGBPoints\": [value, r, g, b, …]}]");
    EXPECT_EQ(complaint("j.json", "[]").substr(0, 14), ": found array;");
    EXPECT_EQ(complaint("k.json", "{\"RGBPoints\": [0,0,0,0,1]}"),
              ": RGBPoints: found 5 numbers; expected four for each point: value, r, g, b");
    EXPECT_EQ(complaint("l.json", "{\"RGBPoints\": [0,0,0,null, 1,1,1,1]}"),
              ": RGBPoints[3]: found null; expected a number");
    EXPECT_EQ(complaint("m.json", "{\"RGBPoints\": [0,0,0,2, 1,1,1,1]}"),
              ": point 1: found a colour of 2; expected parts from 0 to 1");
    EXPECT_EQ(
        complaint("n.json", "{\"ColorSpace\": \"lab\", \"RGBPoints\": [0,0,0,0, 1,1,1,1]}"),
        ": ColorSpace: found 'lab'; expected one of RGB, HSV, Wrapped, Lab, CIELAB, Diverging; did you mean Lab?");
    EXPECT_EQ(complaint("o.json", "{\"IndexedColors\": [1,0,0]}"),
              ": IndexedColors: found colours for categories; expected RGBPoints, colours at values");
    EXPECT_EQ(complaint("p.json", "{\"RGBPoints\": [1e999,0,0,0]}").substr(0, 31), ": found a number beyond 1e308; ");
    EXPECT_EQ(complaint("q.json", "{\"NanColor\": 3, \"RGBPoints\": [0,0,0,0, 1,1,1,1]}"),
              ": NanColor: not a list of three; expected red, green, blue");
    EXPECT_EQ(complaint("r.xml", "<ColorMap><Point x='1'").substr(0, 27), ": it is not well-formed XML");
    EXPECT_EQ(complaint("s.xml", "<a/>").substr(0, 23), ": it holds no ColorMap;");
    EXPECT_EQ(complaint("t.xml", "<ColorMap><Point x=\"1\" r=\"0\" g=\"0\"/></ColorMap>"),
              ": Point 1: it has no b; expected b=\"NUMBER\"");
    EXPECT_EQ(complaint("u.xml", "<ColorMap><Point x=\"eins\" r=\"0\" g=\"0\" b=\"0\"/></ColorMap>"),
              ": Point 1: its x is 'eins'; expected a number");
}

TEST_F(ColorMapFile, WhatIsNoFileIsRefused)
{
    EXPECT_THROW(loadColorMap((folder_ / "missing.json").string()), InputError);
    fs::create_directories(folder_ / "folder.json");
    EXPECT_THROW(loadColorMap((folder_ / "folder.json").string()), InputError);
    fs::create_symlink("/dev/zero", folder_ / "endless.csv");
    EXPECT_THROW(loadColorMap((folder_ / "endless.csv").string()), InputError);
}

}  // namespace
}  // namespace aeolic
