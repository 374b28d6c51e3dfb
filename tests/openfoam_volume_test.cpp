#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "openfoam_testing.h"
#include "reader/openfoam/testing/sample_case.h"

/// The cells of OpenFOAM cases: polyhedra, regions, meshes that move.
namespace aeolic {
namespace {

using namespace openfoam_testing;
namespace fs = std::filesystem;

SceneDescription describeVolume(const std::string& path, const std::string& surface)
{
    SceneDescription description = describe(surface, "U");
    description.field.spec = path;
    return description;
}

double areaOf(const SurfaceMesh& mesh)
{
    double area = 0;
    for (const auto& t : mesh.triangles) {
        const auto at = [&](int k) { return glm::dvec3(mesh.positions[t[k]]); };
        area += 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
    }
    return area;
}

Bounds boundsOf(const Scene& scene)
{
    Bounds bounds;
    for (const glm::vec3& p : scene.surface.positions) bounds.add(scene.surface.originWorld + glm::dvec3(p));
    return bounds;
}

void writeFoam(const fs::path& file, const char* type, const std::string& body)
{
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "FoamFile { version 2.0; format ascii; class " << type << "; object x; }\n" << body << "\n";
}

/// A cube beside two cells of half its height. The side that it has in common with them is two faces, so the cube is a
/// polyhedron of seven faces. The flow is along x.
void writePolyhedron(const fs::path& folder)
{
    const fs::path mesh = folder / "constant/polyMesh";
    writeFoam(mesh / "points", "vectorField",
              "18((0 0 0)(1 0 0)(1 1 0)(0 1 0)(0 0 1)(1 0 1)(1 1 1)(0 1 1)"       // The cube.
              "(1 0.5 0)(1 0.5 1)(2 0 0)(2 0.5 0)(2 1 0)(2 0 1)(2 0.5 1)(2 1 1)"  // Beside it.
              "(1 1 0.5)(2 1 0.5))");
    writeFoam(mesh / "faces", "faceList",
              "16(4(1 8 9 5) 5(8 2 16 6 9) 4(8 9 14 11)"                       // Between cells: 0|1, 0|2, 1|2.
              "4(0 4 7 3) 5(0 3 2 8 1) 5(4 5 9 6 7) 4(0 1 5 4) 5(3 7 6 16 2)"  // The cube's.
              "4(1 10 13 5) 4(10 11 14 13) 4(1 8 11 10) 4(5 13 14 9)"          // The lower one's.
              "5(11 12 17 15 14) 4(8 2 12 11) 4(9 14 15 6) 6(2 16 6 15 17 12))");
    writeFoam(mesh / "owner", "labelList", "16(0 0 1 0 0 0 0 0 1 1 1 1 2 2 2 2)");
    writeFoam(mesh / "neighbour", "labelList", "3(1 2 2)");
    writeFoam(mesh / "boundary", "polyBoundaryMesh", "1(sides { type wall; nFaces 13; startFace 3; })");
    writeFoam(folder / "1/U", "volVectorField",
              "dimensions [0 1 -1 0 0 0 0];\ninternalField uniform (1 0 0);\n"
              "boundaryField { sides { type calculated; value uniform (1 0 0); } }");
}

TEST(OpenFoamVolume, PolyhedraAreCutAsWellAsOtherCells)
{
    const TempFolder folder;
    writePolyhedron(folder.path() / "case");
    const std::string path = folder.file("case");
    for (const char* plane : {"slice:1,0.5,0.3:0,0,1", "slice:1,0.3,0.5:0,1,0"})
        EXPECT_NEAR(areaOf(loadScene(describeVolume(path, plane)).surface), 2, 1e-5) << plane;
    EXPECT_NEAR(areaOf(loadScene(describeVolume(path, "slice:0.5,0.5,0.5:1,0,0")).surface), 1, 1e-5);
    EXPECT_NEAR(areaOf(loadScene(describeVolume(path, "boundary")).surface), 10, 1e-5) << "2 ends, 4 sides of 2";
}

TEST(OpenFoamVolume, WallsHaveTheFlowOfPolyhedraBesideThem)
{
    const TempFolder folder;
    writePolyhedron(folder.path() / "case");
    const Scene scene = loadScene(describeVolume(folder.file("case"), folder.file("case:sides")));
    ASSERT_GE(scene.surface.pointVectors.size(), 18u);
    for (const glm::vec3& v : scene.surface.pointVectors) EXPECT_NEAR(glm::length(v - glm::vec3(1, 0, 0)), 0, 1e-5);
}

/// The second region is the first one, two units higher.
void writeTwoRegions(const std::string& path)
{
    writeSampleCase(path, {.region = "air"});
    writeSampleCase(path, {.region = "rock"});
    const std::string points = path + "/constant/rock/polyMesh/points";
    std::istringstream in(readBytes(points));
    std::string moved;
    for (std::string line; std::getline(in, line);) {
        const std::size_t open = std::min(line.rfind('('), line.size());
        double x = 0, y = 0, z = 0;
        const bool isPoint = std::sscanf(line.c_str() + open, "(%lf %lf %lf)", &x, &y, &z) == 3;
        moved += (isPoint ? line.substr(0, open) + fmt::format("({} {} {})", x, y + 2, z) : line) + "\n";
    }
    writeBytes(points, moved);
}

TEST(OpenFoamVolume, RegionsArePartsOfTheField)
{
    const TempFolder folder;
    const std::string path = folder.file("case");
    writeTwoRegions(path);
    const Scene both = loadScene(describeVolume(path, "boundary")),
                air = loadScene(describeVolume(path + ":air", "boundary")),
                rock = loadScene(describeVolume(path + ":rock/internalMesh", "boundary"));
    EXPECT_NEAR(boundsOf(both).hi.y, 3, 1e-5);
    EXPECT_NEAR(boundsOf(air).hi.y, 1, 1e-5);
    EXPECT_NEAR(boundsOf(rock).lo.y, 2, 1e-4);
    EXPECT_EQ(both.surface.triangles.size(), air.surface.triangles.size() + rock.surface.triangles.size());
    expectParts(messageOf(describeVolume(path + ":are", "boundary")), {"no part 'are'", "air/internalMesh"});
}

/// A solid has no velocity.
TEST(OpenFoamVolume, ARegionWithoutTheFieldIsBlank)
{
    const TempFolder folder;
    const std::string path = folder.file("case");
    writeTwoRegions(path);
    for (const char* time : {"0", "1"}) fs::remove(path + "/" + time + "/rock/U");
    EXPECT_EQ(messageOf(describeVolume(path, "slice:1,0.6,0.5:0,0,1")), "(nothing was refused)");
    EXPECT_EQ(messageOf(describe(path + ":air/inlet,rock/inlet", "U")), "(nothing was refused)");
    SceneDescription rock = describe(path + ":rock/inlet", "");
    rock.shading.colorBy = "p";
    EXPECT_EQ(loadScene(rock).surface.pointVectors.front(), glm::vec3(0)) << "wallShearStress is the only one there";
    expectParts(messageOf(describe(path + ":inlet", "V")), {"no array 'V'", "U (cells, 3 components)"});
}

TEST(OpenFoamVolume, PointsThatMoveAreThoseOfTheTime)
{
    for (const SampleCase& sample :
         {SampleCase{.times = {"1", "2", "3"}}, SampleCase{.processors = 2, .collated = 2, .times = {"1", "2", "3"}}}) {
        const TempFolder folder;
        const std::string path = folder.file("case"), data = path + (sample.collated > 0 ? "/processors2" : "");
        writeSampleCase(path, sample);
        fs::create_directories(data + "/2/polyMesh");
        std::string points = readBytes(data + "/constant/polyMesh/points");
        for (std::size_t at = points.find("(2 "); at != std::string::npos; at = points.find("(2 ", at))
            points.replace(at, 3, "(4 ");  // As many bytes: blocks keep their sizes.
        writeBytes(data + "/2/polyMesh/points", points);
        for (const auto& [time, end] : {std::pair{1.0, 2.0}, {2.0, 4.0}, {3.0, 4.0}}) {
            SceneDescription walls = describe(path), volume = describeVolume(path, "slice:1,0.6,0.5:0,0,1");
            walls.time.moment = volume.time.moment = time;
            EXPECT_NEAR(boundsOf(loadScene(walls)).hi.x, end, 1e-5) << time;
            EXPECT_NEAR(boundsOf(loadScene(volume)).hi.x, end, 1e-5) << time;
        }
    }
}

TEST(OpenFoamVolume, TimesMayHaveOddNames)
{
    const TempFolder folder;
    const std::string path = folder.file("case");
    writeSampleCase(path, {.times = {"1e-05", "0.30000000000000004", "2.50", "1e+1"}});
    for (const char* name : {"0.orig", "-1", "3_old", "nan", "inf"}) fs::copy(path + "/2.50", path + "/" + name);
    for (SceneDescription description : {describe(path), describeVolume(path, "slice:1,0.6,0.5:0,0,1")}) {
        OneRank alone;
        const LoadedScene scene(description, {}, alone);
        EXPECT_EQ(scene.times(), (std::vector<double>{1e-05, 0.30000000000000004, 2.5, 10}));
    }
}

TEST(OpenFoamVolume, ProcessorsOfACollatedCaseMustAllBeThere)
{
    const TempFolder folder;
    const std::string path = folder.file("case");
    writeSampleCase(path, {.processors = 4, .collated = 2});
    EXPECT_EQ(messageOf(describe(path)), "(nothing was refused)");
    fs::remove_all(path + "/processors4_0-1");
    expectParts(messageOf(describe(path)), {"processors4_2-3", "no processor0"});
    writeSampleCase(path, {.processors = 4, .collated = 2});
    fs::remove_all(path + "/processors4_2-3");
    expectParts(messageOf(describe(path)), {"2 processors in processors4_0-1", "expected 4"});
    writeSampleCase(path, {.processors = 4, .collated = 2});
    const std::string file = path + "/processors4_2-3/constant/polyMesh/faces";
    const std::string bytes = readBytes(file);
    writeBytes(file, bytes.substr(0, bytes.size() - 40));
    expectParts(messageOf(describe(path)), {file});
}

}  // namespace
}  // namespace aeolic
