#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "aeolic/error.h"
#include "data/fingerprint.h"
#include "data/load/file_info.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "part_formats_testing.h"
#include "reader/tecplot/testing/sample_tecplot.h"

namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

constexpr std::size_t kQuads = 16;

class Tecplot : public testing::Test {
protected:
    void write(const SampleTecplot& sample = {}) const { writeSampleTecplot(file_, sample); }

    static SceneDescription describe(const std::string& surface, const std::string& field = "",
                                     const std::string& colorBy = "")
    {
        SceneDescription description;
        description.surface.spec = surface;
        description.field.spec = field;
        description.field.vectors = "UVW";
        description.shading.colorBy = colorBy;
        return description;
    }

    std::string complaint(const std::string& text) const
    {
        writeBytes(file_, text);
        return complaintOf([&] { loadScene(describe(file_)); });
    }

    void expectComplaint(const std::string& text, const std::vector<std::string>& parts) const
    {
        expectSays(complaint(text), parts);
    }

    TempFolder folder_;
    std::string file_ = folder_.file("box.tec");
};

void expectFlow(const Scene& scene, double step = 0)
{
    testkit::expectVectors(scene, [&](const glm::dvec3& p) { return tecplotFlow(p) + glm::dvec3(step, 0, 0); });
}

const SampleTecplot allSamples[] = {
    {}, {.block = false}, {.ordered = false}, {.ordered = false, .block = false}, {.shared = true}, {.repeats = true}};

TEST_F(Tecplot, ZonesOfFacesAreTheSurfaceAndThoseThatFillSpaceTheField)
{
    for (const SampleTecplot& sample : allSamples) {
        write(sample);
        const Scene sheet = loadScene(describe(file_));
        EXPECT_EQ(sheet.surface.triangles.size(), 2 * kQuads);
        EXPECT_EQ(sheet.surface.originWorld.z, 5);
        expectFlow(sheet);
        EXPECT_NEAR(areaOf(loadScene(describe(file_ + ":box")).surface), 6 * 16, 1e-5);
        const Scene slice = loadScene(describe("slice:2,2,1.5:0,0,1", file_, "T"));
        EXPECT_NEAR(areaOf(slice.surface), 16, 1e-5);
        expectFlow(slice);
    }
}

TEST_F(Tecplot, AnySpellingGivesTheSameBytes)
{
    for (const char* color : {"T", "p"}) {
        std::vector<std::string> found;
        for (const SampleTecplot& sample : allSamples) {
            if (!sample.block && color[0] == 'p') continue;
            write(sample);
            found.push_back(fingerprint(loadScene(describe(file_ + ":sheet", "", color))));
        }
        EXPECT_EQ(found, std::vector<std::string>(found.size(), found[0])) << color;
    }
}

TEST_F(Tecplot, ValuesInCells)
{
    for (const bool ordered : {true, false}) {
        write({.ordered = ordered});
        SceneDescription description = describe(file_ + ":sheet", "", "p");
        description.surface.cells = CellValues::steps;
        const Scene scene = loadScene(description);
        for (std::size_t i = 0; i < 2 * kQuads; ++i) EXPECT_EQ(scene.surface.cellScalars[i], float(i / 2));
    }
}

/// Flat data may lie across any axis; two components are enough.
TEST_F(Tecplot, FlatDataInXAndZ)
{
    const std::string zone = "ZONE I=2, J=2, DATAPACKING=POINT\n0 0 1 2\n1 0 1 2\n0 1 1 2\n1 1 1 2\n";
    writeBytes(file_, "VARIABLES = x z velx velz\n" + zone);
    const auto load = [&] {
        SceneDescription description = describe(file_);
        description.field.vectors = "vel";
        return loadScene(description);
    };
    EXPECT_EQ(load().surface.pointVectors.front(), glm::vec3(1, 0, 2));
    EXPECT_EQ(load().boundsWorld.hi, glm::dvec3(1, 0, 1));
    writeBytes(file_, "VARIABLES = y z vely velz\n" + zone);
    EXPECT_EQ(load().surface.pointVectors.front(), glm::vec3(0, 1, 2));
    expectComplaint("VARIABLES = x velx\nZONE I=2, J=2, DATAPACKING=POINT\n0 0\n1 0\n0 1\n1 1\n",
                    {"it has not two variables called x, y or z"});
}

TEST_F(Tecplot, StrandsAreTimes)
{
    write({.steps = 3});
    SceneDescription description = describe(file_);
    for (const double time : {0.0, 0.5, 1.0, 0.25, 7.0}) {
        description.time.moment = time;
        const Scene scene = loadScene(description);
        EXPECT_EQ(scene.surface.triangles.size(), 2 * kQuads);
        expectFlow(scene, 2 * std::min(time, 1.0));
    }
    const std::string told = describeFile(file_);
    for (const char* text : {"a Tecplot file", "box    volume     64", "sheet  faces      16",
                             "time steps  3, from 0 to 1", "UVW", "box.tec:sheet --vectors UVW", "--time 0.5"})
        EXPECT_NE(told.find(text), std::string::npos) << text << " is not in:\n" << told;
}

/// Corners that come twice make simpler elements, as Tecplot has them.
TEST_F(Tecplot, ElementsWithCornersThatComeTwice)
{
    const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n";
    const auto volumeOf = [&](const std::string& corners) {
        writeBytes(file_, "VARIABLES=x,y,z\nZONE N=8 E=1 ZONETYPE=FEBRICK\n" + points + corners + "\n");
        SceneDescription description = describe(file_ + ":zone 1", "abc:8,8,8");
        description.field.vectors = "";
        return areaOf(loadScene(description).surface);
    };
    EXPECT_NEAR(volumeOf("1 2 3 4 5 6 7 8"), 6, 1e-5);
    EXPECT_NEAR(volumeOf("1 2 4 4 5 6 8 8"), 3 + std::sqrt(2.0), 1e-5);                    // A wedge.
    EXPECT_NEAR(volumeOf("1 2 4 4 5 5 5 5"), 1.5 + std::sqrt(3.0) / 2, 1e-5);              // A tetrahedron.
    EXPECT_NEAR(volumeOf("1 2 3 4 5 5 5 5"), 1 + 2 * 0.5 + 2 * std::sqrt(2.0) / 2, 1e-5);  // A pyramid.
    writeBytes(file_, "VARIABLES=x,y\nZONE N=3 E=1 ZONETYPE=FEQUADRILATERAL\n0 0\n1 0\n0 1\n1 2 3 3\n");
    SceneDescription flat = describe(file_, "abc:8,8,8");
    flat.field.vectors = "";
    EXPECT_NEAR(areaOf(loadScene(flat).surface), 0.5, 1e-6);
}

TEST_F(Tecplot, WaysToWriteNumbersAndNames)
{
    SceneDescription description = describe(file_);
    writeBytes(file_,
               "TITLE = \"ZONE T=1\"\nvariables = \"X [m]\" 'Y [m]' \"Z [m]\" \"X Velocity\" \"Y Velocity\" \"Z "
               "Velocity\"\nzone t='a', i=2,j=2\n"
               "1.0D+00 0 0 1 0 0 # a comment\n+2.0d0,0,0,1,0,0\n1 1 0 nan 1e999 0\n2 1 0 3*1\n");
    description.field.vectors = "Velocity";
    const Scene scene = loadScene(description);
    ASSERT_EQ(scene.surface.positions.size(), 4U);
    EXPECT_NEAR(scene.surface.bounds().hi.x, 2, 1e-6);
    EXPECT_EQ(scene.surface.pointVectors.back(), glm::vec3(1));
}

TEST_F(Tecplot, AnyCornerMayComeTwice)
{
    const std::string square =
        "VARIABLES=x,y,U,V\nZONE N=4 E=2 F=FEPOINT ET=QUADRILATERAL\n0 0 1 0\n1 0 1 0\n0 1 1 0\n"
        "1 1 1 0\n1 4 3 3\n";
    for (const char* half : {"1 2 4 4", "1 2 4 1", "1 2 2 4", "1 1 2 4", "2 4 1 1"}) {
        writeBytes(file_, square + half + "\n");
        SceneDescription description = describe(file_, "abc:8,8,8");
        description.field.vectors = "";
        EXPECT_NEAR(areaOf(loadScene(description).surface), 1, 1e-6) << half;
    }
    const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n";
    for (const char* wedge : {"1 2 4 4 5 6 8 8", "1 1 2 4 5 5 6 8", "1 2 2 4 5 6 6 8", "1 2 4 1 5 6 8 5"}) {
        writeBytes(file_, "VARIABLES=x,y,z\nZONE N=8 E=1 ZONETYPE=FEBRICK\n" + points + wedge + "\n");
        SceneDescription description = describe("boundary", file_);
        description.field.vectors = "";
        description.surface.spec = file_ + ":zone 1";
        description.field.spec = "abc:8,8,8";
        EXPECT_NEAR(areaOf(loadScene(description).surface), 3 + std::sqrt(2.0), 1e-5) << wedge;
    }
}

/// Transient files share what does not change: each zone with the one before.
TEST_F(Tecplot, LongChainsOfZonesThatShare)
{
    constexpr int zones = 3000;
    std::string text =
        "VARIABLES=x,y,z,U,V,W\nZONE N=3 E=1 ZONETYPE=FETRIANGLE\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n1 2 3\n";
    for (int i = 1; i < zones; ++i)
        text += "ZONE N=3 E=1 ZONETYPE=FETRIANGLE VARSHARELIST=([1-6]=" + std::to_string(i) +
                ") CONNECTIVITYSHAREZONE=" + std::to_string(i) + "\n";
    writeBytes(file_, text);
    const Scene last = loadScene(describe(file_ + ":zone " + std::to_string(zones)));
    EXPECT_EQ(last.surface.triangles.size(), 1U);
    EXPECT_EQ(last.surface.pointVectors.front(), glm::vec3(1, 2, 3));
}

TEST_F(Tecplot, ListsMayBeOfSeveralLines)
{
    const std::string zone = "ZONE N=3 E=1 ZONETYPE=FETRIANGLE";
    writeBytes(file_, "VARIABLES=x,y,z,U,V,W\n" + zone + "\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n1 2 3\n" + zone +
                          " VARSHARELIST=([1-3,\n\t4-6]=1\n)\n3 2 1\n");
    const Scene last = loadScene(describe(file_ + ":zone 2"));
    EXPECT_EQ(last.surface.triangles.size(), 1U);
}

TEST_F(Tecplot, SmallThingsThatOtherProgramsWrite)
{
    const std::string zone =
        "VARIABLES=x,y,z,U,V,W\nZONE I=2,J=2\n0 0 1e-330 1 1e-400 0\n1 0 0 1 0 0\n0 1 0 1 0 0\n1 1 0 1 0 0\n";
    for (const std::string& start : {std::string("\xEF\xBB\xBF"), std::string("TITLE=\"a\" "), std::string()}) {
        writeBytes(file_, start + zone);
        const Scene scene = loadScene(describe(file_));
        EXPECT_EQ(scene.surface.triangles.size(), 2U) << start;
        for (const glm::vec3& vector : scene.surface.pointVectors) EXPECT_EQ(vector, glm::vec3(1, 0, 0)) << start;
    }
}

TEST_F(Tecplot, HundredsOfVariables)
{
    std::string names = "VARIABLES=a";
    for (int i = 0; i < 900; ++i) names += ",v" + std::to_string(i);
    expectComplaint(names + "\nZONE I=1\n", {"box.tec", "x, y or z: a, v0, ", "and 891 more"});
}

TEST_F(Tecplot, DamagedHeads)
{
    const std::string start = "VARIABLES=x,y,z,U,V,W\n", point = "0 0 0 1 0 0\n";
    expectComplaint("", {"box.tec", "it is empty"});
    expectComplaint("(0 \"Fluent\")", {"box.tec", "line 1", "Tecplot file in text"});
    expectComplaint("#!TDV112 and so on", {"box.tec", "Tecplot file in binary"});
    expectComplaint(std::string("VARIABLES=\0x", 12), {"box.tec", "not text"});
    expectComplaint("ZONE I=2\n", {"box.tec", "no variables were named"});
    expectComplaint("VARIABLES=\nZONE\n", {"box.tec", "line 2", "names no variables"});
    expectComplaint(start, {"box.tec", "no zones"});
    expectComplaint("VARIABLES=a,b\nZONE I=2,J=2\n0 0\n", {"box.tec", "x, y or z: a, b"});
    expectComplaint("FILETYPE=GRID\n" + start, {"box.tec", "line 1", "the type GRID", "FULL"});
    expectComplaint(start + "ZONE I=2,J=two\n", {"box.tec", "line 2", "the J 'two'", "whole number"});
    expectComplaint(start + "ZONE I=-2,J=2\n", {"box.tec", "the I -2"});
    expectComplaint(start + "ZONE I=2000000,J=2000000,K=2000000\n", {"box.tec", "memory"});
    expectComplaint(start + "ZONE I=200,J=200\n", {"box.tec", "it ends behind 0 numbers"});
    expectComplaint(start + "ZONE N=3 E=100000 ZONETYPE=FETRIANGLE\n", {"box.tec", "it ends behind 0 numbers"});
    expectComplaint(start + "ZONE ZONETYPE=FEPOTATO\n", {"box.tec", "ZONETYPE FEPOTATO"});
    expectComplaint(start + "ZONE T=\"no end\n", {"box.tec", "does not end"});
    expectComplaint(start + "ZONE VARLOCATION=([1-9]=CELLCENTERED)\n", {"box.tec", "numbers from 1 to 6"});
    expectComplaint(start + "ZONE VARLOCATION=([4]=CELL\n", {"box.tec", "a list does not end"});
    expectComplaint(start + "ZONE VARSHARELIST=([4]=1)\n", {"box.tec", "first zone"});
    expectComplaint(start + "ZONE I=1\n" + point + "ZONE VARSHARELIST=([4]=2)\n", {"box.tec", "variables of zone 2"});
    expectComplaint(start + "ZONE CONNECTIVITYSHAREZONE=1\n", {"box.tec", "elements of zone 1"});
    expectComplaint(start + "ZONE I=2 SOLUTIONTIME=soon\n", {"box.tec", "'soon'", "finite"});
    expectComplaint(start + "ZONE I=2\n" + point + point, {"box.tec", "'zone 1'", "faces or fills space"});
    expectComplaint(start + "ZONE N=4 E=1 ZONETYPE=FEPOLYHEDRON\n" + point, {"box.tec"});
}

TEST_F(Tecplot, DamagedNumbers)
{
    const std::string start = "VARIABLES=x,y,z,U,V,W\nZONE T=\"a\" N=3 E=1 ZONETYPE=FETRIANGLE\n",
                      points = "0 0 0 1 0 0\n1 0 0 1 0 0\n0 1 0 1 0 0\n";
    EXPECT_EQ(complaint(start + points + "1 2 3\n"), "");
    expectComplaint(start + points + "1 2 4\n", {"box.tec", "'a'", "the corner 4", "1 to 3"});
    expectComplaint(start + points + "1 2 0\n", {"box.tec", "'a'", "the corner 0"});
    expectComplaint(start + points + "1 2 1e300\n", {"box.tec", "'a'", "the corner 1000000000000000000"});
    expectComplaint(start + points + "1.7 2 3\n", {"box.tec", "'a'", "the corner 1.7", "whole number"});
    expectComplaint(start + points + "nan 2 3\n", {"box.tec", "'a'", "the corner nan", "whole number"});
    expectComplaint(start + points + "1 2\n", {"box.tec", "'a'", "ends behind 20 numbers"});
    expectComplaint(start + points + "1 2 3 4\n", {"box.tec", "'a'", "'4' stands behind its 21 numbers"});
    expectComplaint(start + points + "1 2 three\n", {"box.tec", "'a'", "'three' behind 20 numbers"});
    expectComplaint(start + "0 0 0 1 0", {"box.tec", "'a'", "ends behind 5 numbers"});
    expectComplaint(start + "0 0 0 1 0 1-2\n", {"box.tec", "'a'", "behind 5 numbers"});
    expectComplaint(start + "1e30*5 0\n", {"box.tec", "'a'"});
    expectComplaint(start + "0*5 0\n", {"box.tec", "'a'"});
    expectComplaint(start + "9e31" + points.substr(1) + "1 2 3\n", {"box.tec", "'a'", "a coordinate is 9e+31"});
    expectComplaint("VARIABLES=x,y,z,U,V,W\nZONE I=2,J=2 VARLOCATION=([4-6]=CELLCENTERED)\n0 0 0 1 1 1\n",
                    {"box.tec", "BLOCK"});
}

/// Solvers write grids of several blocks like this: all blocks of a time are in one strand.
TEST_F(Tecplot, AStrandMayHaveSeveralZonesAtEveryTime)
{
    std::string text = "VARIABLES=\"X\" \"Y\" \"Z\" \"U\" \"V\" \"W\"\n";
    for (const int time : {0, 1})
        for (const int block : {0, 1}) {
            text += fmt::format("ZONE T=\"block {}\", STRANDID=1, SOLUTIONTIME={}, I=2, J=2, DATAPACKING=POINT\n",
                                block, time);
            for (const int point : {0, 1, 2, 3})
                text += fmt::format("{} {} 0 {} 0 0\n", block + point % 2, point / 2, 1 + time);
        }
    writeBytes(file_, text);
    OneRank alone;
    LoadedScene scene(describe(file_), {}, alone);
    EXPECT_EQ(scene.times(), (std::vector<double>{0, 1}));
    for (const double time : scene.times()) {
        scene.moveTo(time);
        ASSERT_EQ(scene.scene().surface.triangles.size(), 4u) << time;
        for (const glm::vec3& vector : scene.scene().surface.pointVectors) EXPECT_EQ(vector.x, 1 + time);
    }
}

}  // namespace
}  // namespace aeolic
