#include "openfoam_testing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <sstream>

#include "data/load/file_info.h"
#include "data/vtk/surface/surface_file.h"
#include "reader/openfoam/testing/sample_case.h"
#include "same_bytes_testing.h"

namespace aeolic {
namespace {

using namespace openfoam_testing;
namespace fs = std::filesystem;

testkit::Case pictureCase(const std::string& surface)
{
    testkit::Case c{"a case", describe(surface), {}};
    c.description.output.width = 160;
    c.description.output.height = 120;
    return c;
}

struct Way {
    const char* name;
    SampleCase sample;
};

TEST(OpenFoam, EveryWayOfWritingACaseGivesTheSamePicture)
{
    const TempFolder folder;
    writeSampleCase(folder.file("text"));
    const auto expected = testkit::draw("cpu", pictureCase(folder.file("text")), {}, 1, 1);
    const Way ways[] = {{"binary", {.binary = true}},
                        {"gzip", {.gzip = true}},
                        {"binary-gzip-long", {.binary = true, .gzip = true, .longLabels = true}},
                        {"big-endian", {.binary = true, .longLabels = true, .bigEndian = true}},
                        {"region", {.region = "air"}},
                        {"decomposed", {.processors = 3}},
                        {"decomposed-binary", {.binary = true, .gzip = true, .processors = 3}},
                        {"collated", {.processors = 3, .collated = 3}},
                        {"collated-binary", {.binary = true, .longLabels = true, .processors = 3, .collated = 3}},
                        {"collated-gzip", {.binary = true, .gzip = true, .processors = 3, .collated = 3}},
                        {"collated-twice", {.binary = true, .processors = 3, .collated = 2}}};
    for (const Way& way : ways) {
        SCOPED_TRACE(way.name);
        writeSampleCase(folder.file(way.name), way.sample);
        EXPECT_EQ(testkit::draw("cpu", pictureCase(folder.file(way.name)), {}, 1, 1).front().pixels,
                  expected.front().pixels);
    }
    EXPECT_EQ(testkit::draw("cpu", pictureCase(folder.file("text") + "/case.foam"), {}, 1, 1).front().pixels,
              expected.front().pixels);
}

TEST(OpenFoam, ADecomposedCaseGivesTheSameBytesOnAnyNumberOfRanks)
{
    const TempFolder folder;
    for (const int collated : {0, 2}) {
        const std::string path = folder.file("case" + std::to_string(collated));
        writeSampleCase(path, {.binary = true, .gzip = true, .processors = 3, .collated = collated});
        const testkit::Case c = pictureCase(path);
        const auto expected = testkit::draw("cpu", c, {}, 1, 1);
        for (const int ranks : {2, 4}) testkit::expectSameBytes("cpu", c, expected, {}, ranks);
    }
}

TEST(OpenFoam, WithoutAddressingProcessorsFollowOneAnother)
{
    const TempFolder folder;
    writeSampleCase(folder.file("case"), {.processors = 3});
    const Scene told = loadScene(describe(folder.file("case")));
    for (int i = 0; i < 3; ++i)
        fs::remove(folder.path() / "case" / ("processor" + std::to_string(i)) / "constant/polyMesh/faceProcAddressing");
    const Scene scene = loadScene(describe(folder.file("case")));
    EXPECT_EQ(scene.surface.triangles.size(), told.surface.triangles.size());
    EXPECT_EQ(scene.surface.positions.size(), told.surface.positions.size()) << "seams are closed";
}

TEST(OpenFoam, FacesHaveTheSolversValues)
{
    const TempFolder folder;
    writeSampleCase(folder.file("case"), {.binary = true});
    SurfaceArrays arrays{true, "wallShearStress", ""};
    arrays.parts = {"floor"};
    const LoadedSurface surface = readSurfaceFile(folder.file("case"), arrays, {});
    ASSERT_EQ(surface.mesh.triangles.size(), 2u * kSampleFloorFaces);
    ASSERT_EQ(surface.mesh.cellVectors.size(), surface.mesh.triangles.size());
    std::map<float, int> along;
    for (const glm::vec3& v : surface.mesh.cellVectors) ++along[v.x];
    EXPECT_EQ(along.size(), 8u) << "one value for each column of faces";
    EXPECT_FLOAT_EQ(along.begin()->first, 2 * 1.125f) << "time 1: the state before the first step is left out";
    for (const auto& [value, count] : along) EXPECT_EQ(count, 6) << value;
}

TEST(OpenFoam, PatchesWithoutAValueHaveThoseOfTheCellsBehind)
{
    const TempFolder folder;
    writeSampleCase(folder.file("case"), {.processors = 2});
    SurfaceArrays arrays{true, "U", ""};
    arrays.parts = {"inlet"};
    for (const glm::vec3& v : readSurfaceFile(folder.file("case"), arrays, {}).mesh.cellVectors)
        EXPECT_TRUE(v.x >= 1 && v.x <= 4 && v.z >= 1) << v.x << " " << v.z;
    arrays.parts = {"sides"};
    for (const glm::vec3& v : readSurfaceFile(folder.file("case"), arrays, {}).mesh.cellVectors) {
        EXPECT_NEAR(v.z, 0, 1e-6) << "slip: nothing goes through";
        EXPECT_GE(v.x, 1);
    }
    arrays.parts = {"floor"};
    for (const glm::vec3& v : readSurfaceFile(folder.file("case"), arrays, {}).mesh.cellVectors)
        EXPECT_EQ(glm::length(v), 0) << "noSlip";
}

TEST(OpenFoam, PartsAreNamesGroupsAndPatterns)
{
    const TempFolder folder;
    writeSampleCase(folder.file("case"));
    const auto triangles = [&](const std::string& parts) {
        return loadScene(describe(folder.file("case") + parts)).surface.triangles.size();
    };
    EXPECT_EQ(triangles(""), 96u) << "all walls";
    EXPECT_EQ(triangles(":wall"), 96u);
    EXPECT_EQ(triangles(":solid"), 96u);
    EXPECT_EQ(triangles(":floor"), 48u);
    EXPECT_EQ(triangles(":f*r,roof"), 96u);
    EXPECT_EQ(triangles(":*"), 2 * (48u + 24u + 64u)) << "sides: 8 x 4 twice";
    expectParts(messageOf(describe(folder.file("case:flor"))),
                {"no part 'flor'", "inlet, outlet, floor, roof, sides", "did you mean floor?"});
    expectParts(messageOf(describe(folder.file("case:"))), {"no part is named", "patterns with *"});
}

TEST(OpenFoam, OneTimeAfterAnother)
{
    const TempFolder folder;
    writeSampleCase(folder.file("case"), {.gzip = true, .processors = 2, .times = {"0", "1", "2.5", "10"}});
    SceneDescription description = describe(folder.file("case"));
    OneRank alone;
    LoadedScene scene(description, {}, alone);
    EXPECT_EQ(scene.times(), (std::vector<double>{1, 2.5, 10}));
    const float before = scene.scene().surface.pointVectors.front().x;
    scene.moveTo(10);
    EXPECT_FLOAT_EQ(scene.scene().surface.pointVectors.front().x, before * 11 / 2);
}

/// `postProcess -latestTime` leaves cases where only the last time has a field.
TEST(OpenFoam, TimesMayDifferInTheirFields)
{
    const TempFolder folder;
    const std::string path = folder.file("case");
    writeSampleCase(path, {.gzip = true, .times = {"1", "2", "3"}});
    for (const char* time : {"1", "2"}) fs::remove(path + "/" + time + "/wallShearStress.gz");
    fs::create_directories(path + "/2.5/uniform");
    SceneDescription surface = describe(path), field = describe("slice:1,0.6,0.5:0,0,1");
    field.field.spec = path;
    for (SceneDescription description : {surface, field}) {
        const std::string missing = ": it has no 'wallShearStress'; expected time 3, the only one that has it";
        expectParts(messageOf(description), {path + ", time 1" + missing});
        description.time.moment = 2.25;
        expectParts(messageOf(description), {path + ", time 2" + missing});
        description.time.moment = 3;
        OneRank alone;
        const LoadedScene scene(description, {}, alone);
        EXPECT_EQ(scene.times(), (std::vector<double>{1, 2, 3}));
    }
    surface.time.moment = 3;
    EXPECT_FLOAT_EQ(loadScene(surface).surface.pointVectors.front().x, 4 * 1.125f);
    surface.field.vectors = "U";
    EXPECT_EQ(messageOf(surface), "(nothing was refused)") << "coloured by an array that the first time lacks";
    const std::string text = describeFile(path);
    EXPECT_NE(text.find("  wallShearStress: only at time 3\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("--vectors wallShearStress"), std::string::npos) << "which the first time lacks\n" << text;
}

TEST(OpenFoam, AFileOfACaseEndsInFoamOrOpenFoam)
{
    const TempFolder folder;
    writeSampleCase(folder.file("case"));
    for (const char* name : {"a.foam", "a.FOAM", "a.openfoam", "a.OpenFOAM"}) {
        writeBytes(folder.file("case/") + name, "");
        EXPECT_EQ(messageOf(describe(folder.file("case/") + name)), "(nothing was refused)") << name;
    }
}

TEST(OpenFoam, AFieldThatIsCutOffIsNotLeftOut)
{
    const TempFolder folder;
    const std::string path = folder.file("case"), damaged = path + "/1/U.gz";
    writeSampleCase(path, {.gzip = true, .times = {"1"}});
    const std::string bytes = readBytes(damaged);
    writeBytes(damaged, bytes.substr(0, bytes.size() / 2));
    SceneDescription description = describe("boundary", "U");
    description.field.spec = path;
    expectParts(messageOf(description), {damaged, "cut off"});
    expectParts(messageOf(describe(path, "U")), {damaged, "cut off"});
    EXPECT_THROW(describeFile(path), InputError);
    EXPECT_EQ(messageOf(describe(path)), "(nothing was refused)") << "another field is sound";
}

TEST(OpenFoam, TheVolumeIsAField)
{
    const TempFolder folder;
    for (const Way& way :
         {Way{"one", {.binary = true}}, Way{"text", {.gzip = true}}, Way{"long", {.binary = true, .longLabels = true}},
          Way{"parts", {.binary = true, .processors = 3}}, Way{"collated", {.processors = 3, .collated = 3}}}) {
        SCOPED_TRACE(way.name);
        const std::string path = folder.file(way.name);
        writeSampleCase(path, way.sample);
        SceneDescription description = describe("slice:1,0.6,0.5:0,0,1", "U");
        description.field.spec = path;
        const Scene scene = loadScene(description);
        EXPECT_GT(scene.surface.triangles.size(), 50u);
        EXPECT_TRUE(scene.hasScalar);
    }
}

/// Points that lie closer than the size of all lets numbers tell once ended VTK's merging of processors.
TEST(OpenFoam, CellsOfPointsWithoutAPlaceAreRefused)
{
    for (const char* place : {"(1e200 1e-310 0)", "(0 nan 0)", "(0 0 -inf)"}) {
        const TempFolder folder;
        writeSampleCase(folder.file("case"), {.processors = 2});
        SceneDescription description;
        description.surface.spec = "boundary";
        description.field.spec = folder.file("case");
        description.field.vectors = "U";
        ASSERT_EQ(messageOf(description), "(nothing was refused)");
        const std::string points = folder.file("case/processor1/constant/polyMesh/points");
        const std::string text = readBytes(points);
        const std::size_t at = text.rfind('('), end = text.find(')', at);
        writeBytes(points, text.substr(0, at) + place + text.substr(end + 1));
        expectParts(messageOf(description), {points, "a coordinate of point", "expected at most 1e+30"});
    }
}

TEST(OpenFoam, InfoListsPartsTimesAndCommands)
{
    const TempFolder folder;
    writeSampleCase(folder.file("case"), {.processors = 2, .times = {"0", "1", "2"}});
    const std::string text = describeFile(folder.file("case"));
    for (const char* part : {"an OpenFOAM case in 2 processors' folders", "floor", "wall, solid", "wallShearStress",
                             "2, from 1 to 2", "case --vectors wallShearStress", "case:inlet", "--time 2"})
        EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
}

/// What aeolic info proposes first.
std::string firstCommand(const std::string& path)
{
    const std::string text = describeFile(path), begin = "Try:\n  aeolic render ";
    const std::size_t at = text.find(begin) + begin.size();
    return text.substr(at, text.find('\n', at) - at);
}

TEST(OpenFoam, InfoOfACaseInTwoDimensionsProposesItsSidesLookedAtStraight)
{
    const TempFolder folder;
    const std::string path = folder.file("case"), boundary = path + "/constant/polyMesh/boundary";
    writeSampleCase(path);
    EXPECT_EQ(firstCommand(path).find("--camera"), std::string::npos) << "it has walls to look at";
    for (const std::string type : {"empty", "wedge"}) {
        std::string text = readBytes(boundary);
        const std::size_t at = text.find("type ", text.find("sides")) + 5;
        writeBytes(boundary, text.replace(at, text.find(';', at) - at, type));
        const std::string expected =
            "--surface " + path + ":sides --vectors U --color-by p --camera azimuth=0,elevation=90 ";
        EXPECT_EQ(firstCommand(path).substr(0, expected.size()), expected);
    }
}

/// A long channel that is lower than its one layer of cells is thick.
TEST(OpenFoam, InfoLooksAtTheSidesOfALowChannelNotAtItsRoof)
{
    const TempFolder folder;
    const std::string path = folder.file("case"), mesh = path + "/constant/polyMesh/";
    writeSampleCase(path);
    std::string boundary = readBytes(mesh + "boundary");
    const std::size_t at = boundary.find("type ", boundary.find("sides")) + 5;
    writeBytes(mesh + "boundary", boundary.replace(at, boundary.find(';', at) - at, "empty"));
    std::istringstream points(readBytes(mesh + "points"));
    std::string low, line;
    int moved = 0;
    while (std::getline(points, line)) {
        const std::size_t open = std::min(line.rfind('('), line.size());  // The list's own may stand before it.
        double x = 0, y = 0, z = 0;
        const bool isPoint = std::sscanf(line.c_str() + open, "(%lf %lf %lf)", &x, &y, &z) == 3;
        moved += isPoint;
        low += (isPoint ? line.substr(0, open) + fmt::format("({} {} {})", 5 * x, 0.1 * y, z) : line) + "\n";
    }
    ASSERT_EQ(moved, 9 * 5 * 4);
    writeBytes(mesh + "points", low);
    const std::string text = describeFile(path);
    const std::string straight = " --camera azimuth=0,elevation=90 ", slice = ":0,0,1";
    EXPECT_NE(text.find(":sides --vectors U --color-by p" + straight), std::string::npos) << text;
    EXPECT_NE(text.find(slice + straight), std::string::npos) << text;
}

}  // namespace
}  // namespace aeolic
