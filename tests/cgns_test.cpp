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
#include "reader/cgns/testing/sample_cgns.h"
#include "reader/hdf5/testing/sample_hdf5.h"

/// CGNS files that are sound. Damaged ones: cgns_damaged_test.cpp.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;
using Cells = SampleCgns::Cells;

constexpr std::size_t kQuads = 16;  // Of each side of the box.
constexpr Cells allCells[] = {Cells::structured, Cells::hexahedra, Cells::mixed, Cells::polyhedra};

class Cgns : public testing::Test {
protected:
    void write(const SampleCgns& sample) const { writeSampleCgns(file_, sample); }

    static SceneDescription describe(const std::string& surface, const std::string& field = "",
                                     const std::string& colorBy = "")
    {
        SceneDescription description;
        description.surface.spec = surface;
        description.field.spec = field;
        description.field.vectors = "Velocity";
        description.shading.colorBy = colorBy;
        return description;
    }

    TempFolder folder_;
    std::string file_ = folder_.file("box.cgns");
};

void expectFlow(const Scene& scene, double step = 0)
{
    testkit::expectVectors(scene, [&](const glm::dvec3& p) { return cgnsFlow(p) + glm::dvec3(step, 0, 0); });
}

/// Corners on z = 0 alone and so on.
std::vector<double> heights(const SurfaceMesh& mesh)
{
    std::vector<double> all;
    for (const glm::vec3& p : mesh.positions) all.push_back(double(p.z) + mesh.originWorld.z);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

TEST_F(Cgns, WallsAreTheSurfaceUnlessAPartIsNamed)
{
    for (const Cells cells : allCells)
        for (const bool doubles : {true, false}) {
            write({.cells = cells, .doubles = doubles});
            const Scene scene = loadScene(describe(file_));
            EXPECT_EQ(scene.surface.triangles.size(), 2 * 2 * kQuads) << int(cells);
            EXPECT_EQ(heights(scene.surface), (std::vector<double>{0, 4}));
            expectFlow(scene);
            for (const char* name : {":floor", ":box/floor", ":BCWallViscous", ":ground", ":*/fl*r"}) {
                const Scene floor = loadScene(describe(file_ + name));
                EXPECT_EQ(floor.surface.triangles.size(), 2 * kQuads) << name;
                EXPECT_EQ(heights(floor.surface), std::vector<double>{0}) << name;
            }
            EXPECT_EQ(loadScene(describe(file_ + ":inlet,lid")).surface.triangles.size(), 2 * 2 * kQuads);
            const Scene all = loadScene(describe(file_ + ":box"));
            EXPECT_EQ(all.surface.triangles.size(), 6 * 2 * kQuads);
            expectFlow(all);
        }
}

TEST_F(Cgns, AnySpellingOfTheGridGivesTheSameBytes)
{
    for (const char* part : {":floor", ":lid", ":inlet"}) {
        std::vector<std::string> found;
        for (const Cells cells : allCells) {
            if (cells == Cells::structured) {
                for (const bool rind : {false, true}) {
                    write({.cells = cells, .rind = rind});
                    found.push_back(fingerprint(loadScene(describe(file_ + part, "", "Pressure"))));
                }
                continue;
            }
            for (const bool lists : {false, true})
                for (const bool parents : {false, true}) {
                    write({.cells = cells, .parents = parents, .lists = lists});
                    found.push_back(fingerprint(loadScene(describe(file_ + part, "", "Pressure"))));
                }
            write({.cells = cells, .byPoints = true});
            found.push_back(fingerprint(loadScene(describe(file_ + part, "", "Pressure"))));
        }
        EXPECT_EQ(found, std::vector<std::string>(found.size(), found[0])) << part;
    }
}

TEST_F(Cgns, BoundariesOfPointsWhereNoFacesAreTold)
{
    for (const Cells cells : {Cells::hexahedra, Cells::mixed}) {
        write({.cells = cells, .faces = false, .byPoints = true});
        SceneDescription description = describe(file_ + ":lid", "", "Pressure");
        description.surface.cells = CellValues::steps;
        const Scene lid = loadScene(description);
        EXPECT_EQ(heights(lid.surface), std::vector<double>{4});
        EXPECT_NEAR(areaOf(lid.surface), 16, 1e-5);
        for (std::size_t i = 0; i < 2 * kQuads; ++i) EXPECT_EQ(lid.surface.cellScalars[i], 48 + float(i / 2));
        for (const auto& t : lid.surface.triangles) {  // Seen from outside.
            const glm::vec3 a = lid.surface.positions[t[0]], b = lid.surface.positions[t[1]],
                            c = lid.surface.positions[t[2]];
            EXPECT_GT(glm::cross(b - a, c - a).z, 0);
        }
        expectFlow(lid);
    }
}

TEST_F(Cgns, FacesHaveTheValuesOfTheCellsBehindThem)
{
    for (const Cells cells : allCells)
        for (const bool parents : {true, false}) {
            write({.cells = cells, .parents = parents});
            SceneDescription description = describe(file_ + ":lid", "", "Pressure");
            description.surface.cells = CellValues::steps;
            const Scene scene = loadScene(description);
            ASSERT_EQ(scene.surface.cellScalars.size(), 2 * kQuads);
            for (std::size_t i = 0; i < 2 * kQuads; ++i)
                EXPECT_EQ(scene.surface.cellScalars[i], 48 + float(i / 2)) << int(cells) << " " << i;
        }
}

TEST_F(Cgns, TheCellsThatFacesNameGoBeforeThoseThatFit)
{
    for (const Cells cells : {Cells::hexahedra, Cells::polyhedra}) {
        write({.cells = cells});
        const bool polyhedra = cells == Cells::polyhedra;
        const std::string node =
            polyhedra ? "/Base/box/faces/ParentElements/ data" : "/Base/box/lidFaces/ParentElements/ data";
        const std::uint64_t faces = polyhedra ? 240 : 16;
        replaceHdf5(file_, node, {2, faces}, std::vector<std::int64_t>(2 * faces, polyhedra ? 242 : 2));
        SceneDescription description = describe(file_ + ":lid", "", "Pressure");
        description.surface.cells = CellValues::steps;
        EXPECT_EQ(loadScene(description).surface.cellScalars, std::vector<float>(2 * kQuads, 1));
    }
}

TEST_F(Cgns, FacesOfPolyhedraLookOutwards)
{
    for (const bool turned : {false, true}) {
        write({.cells = Cells::polyhedra, .turned = turned});
        const SurfaceMesh mesh = loadScene(describe(file_ + ":box")).surface;
        ASSERT_EQ(mesh.triangles.size(), 6 * 2 * kQuads);
        for (const auto& t : mesh.triangles) {
            const glm::vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
            EXPECT_GT(glm::dot(glm::cross(b - a, c - a), a), 0);  // Positions are relative to the middle.
        }
    }
}

TEST_F(Cgns, ValuesOnABoundaryGoBeforeThoseOfTheCells)
{
    write({.onFaces = true});
    SceneDescription description = describe(file_ + ":floor", "", "Pressure");
    description.surface.cells = CellValues::steps;
    EXPECT_EQ(loadScene(description).surface.cellScalars[2], 1001);
    description.surface.spec = file_ + ":lid";
    EXPECT_EQ(loadScene(description).surface.cellScalars[2], 49);
    description.field.vectors = "Shear";
    EXPECT_TRUE(std::isnan(loadScene(description).surface.cellVectors[2].x));
    description.surface.spec = file_ + ":floor";
    EXPECT_EQ(loadScene(description).surface.cellVectors[2], glm::vec3(1));
}

TEST_F(Cgns, TheVolumeIsAField)
{
    for (const Cells cells : allCells) {
        write({.cells = cells, .secondZone = true});
        const Scene scene = loadScene(describe("slice:4,2,1.5:0,0,1", file_, "Density"));
        EXPECT_NEAR(areaOf(scene.surface), 32, 1e-4);
        expectFlow(scene);
        EXPECT_NEAR(areaOf(loadScene(describe("slice:4,2,1.5:0,0,1", file_ + ":other")).surface), 16, 1e-4);
        expectFlow(loadScene(describe(file_ + ":floor", file_)));
    }
}

TEST_F(Cgns, TimesAndWhatIsBetween)
{
    for (const Cells cells : {Cells::structured, Cells::polyhedra}) {
        write({.cells = cells, .steps = 3});
        SceneDescription description = describe(file_ + ":floor");
        for (const double time : {0.0, 0.5, 1.0, 0.25, 7.0}) {
            description.time.moment = time;
            expectFlow(loadScene(description), 2 * std::min(time, 1.0));
        }
        description.surface.spec = "slice:2,2,1.5:0,0,1";
        description.field.spec = file_;
        description.time.moment = 0.5;
        expectFlow(loadScene(description), 1);
    }
}

/// Some programs name only the common end of the solutions on points and in cells.
TEST_F(Cgns, PointersMayNameTheEndsOfNames)
{
    write({.steps = 3});
    const Scene whole = loadScene(describe(file_ + ":floor", "", "Pressure"));
    write({.shortPointers = true, .steps = 3});
    EXPECT_EQ(fingerprint(loadScene(describe(file_ + ":floor", "", "Pressure"))), fingerprint(whole));
    SceneDescription later = describe(file_ + ":floor");
    later.time.moment = 1.0;
    expectFlow(loadScene(later), 2);
}

TEST_F(Cgns, BasesAndLinksToOtherFiles)
{
    write({.secondBase = true});
    EXPECT_EQ(loadScene(describe(file_ + ":floor")).surface.triangles.size(), 2 * kQuads);
    SceneDescription sheet = describe(file_ + ":Sheets/sheet", "abc:8,8,8");
    sheet.field.vectors = "";
    EXPECT_EQ(heights(loadScene(sheet).surface), std::vector<double>{5});
    const std::string linked = folder_.file("linked.cgns");
    writeSampleCgns(linked, {.grid = file_});
    write({});
    EXPECT_EQ(fingerprint(loadScene(describe(linked, linked))), fingerprint(loadScene(describe(file_, file_))));
    std::filesystem::remove(file_);
    EXPECT_THROW(loadScene(describe(linked)), InputError);
}

/// As solvers write it that begin a file at each step.
TEST_F(Cgns, EachStepInAFileOfItsOwn)
{
    constexpr int steps = 70;
    write({.steps = steps});
    const std::string sound = fingerprint(loadScene(describe(file_ + ":floor")));
    for (int step = 0; step < steps; ++step)
        for (const char* kind : {"Points", "Cells"}) {
            const std::string name = "/Base/box/" + (kind + std::to_string(step)),
                              own = kind + std::to_string(step) + ".cgns";
            Hdf5Writer writer(folder_.file(own));
            writer.group("/Base/box");
            const hid_t opened = H5Fopen(file_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
            H5Ocopy(opened, name.c_str(), writer.file(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
            H5Ldelete(opened, name.c_str(), H5P_DEFAULT);
            H5Gclose(H5Gcreate2(opened, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
            for (const auto& [what, text] : {std::pair{"/ path", name}, {"/ file", own}}) {
                const hsize_t length = text.size();
                const hid_t space = H5Screate_simple(1, &length, nullptr),
                            data = H5Dcreate2(opened, (name + what).c_str(), H5T_NATIVE_INT8, space, H5P_DEFAULT,
                                              H5P_DEFAULT, H5P_DEFAULT);
                H5Dwrite(data, H5T_NATIVE_INT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data());
                H5Dclose(data);
                H5Sclose(space);
            }
            H5Fclose(opened);
            setHdf5Text(file_, name, "type", "LK");
        }
    EXPECT_EQ(fingerprint(loadScene(describe(file_ + ":floor"))), sound);
    SceneDescription last = describe(file_ + ":floor");
    last.time.moment = 0.5 * (steps - 1);
    expectFlow(loadScene(last), steps - 1);
    std::filesystem::remove(folder_.file("Points3.cgns"));
    EXPECT_THROW(loadScene(describe(file_ + ":floor")), InputError);
}

TEST_F(Cgns, InfoListsPartsTimesAndCommands)
{
    write({.cells = Cells::hexahedra, .steps = 3, .secondZone = true});
    const std::string told = describeFile(file_);
    for (const char* text :
         {"a CGNS file", "box               volume            64\n", "box/floor         BCWallViscous     16  ground\n",
          "box/lid           BCWall            16\n", "other             volume ", "points      250",
          "Density   points  double", "time steps  3, from 0 to 1", "render --surface ", "box.cgns --vectors Velocity",
          "box.cgns:box/floor --vectors Velocity", "--time 0.5"})
        EXPECT_NE(told.find(text), std::string::npos) << text << " is not in:\n" << told;
}

}  // namespace
}  // namespace aeolic
