#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "aeolic/error.h"
#include "data/fingerprint.h"
#include "data/load/file_info.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_writers.h"
#include "part_formats_testing.h"
#include "reader/ensight/testing/sample_ensight.h"
#include "reader/openfoam/testing/sample_case.h"

/// EnSight Gold cases that are sound. Damaged ones: ensight_damaged_test.cpp.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

constexpr EnSightFormat formats[] = {{EnSightEncoding::ascii, false},
                                     {EnSightEncoding::binary, false},
                                     {EnSightEncoding::binary, true},
                                     {EnSightEncoding::fortran, false},
                                     {EnSightEncoding::fortran, true}};

class EnSight : public testing::Test {
protected:
    void SetUp() override { writeSampleEnSight(folder_.path().string()); }

    static SceneDescription describe(const std::string& surface, const std::string& field = "",
                                     const std::string& colorBy = "")
    {
        SceneDescription description;
        description.surface.spec = surface;
        description.field.spec = field;
        description.field.vectors = "U";
        description.shading.colorBy = colorBy;
        return description;
    }

    TempFolder folder_;
    std::string case_ = folder_.file("box.case");
};

void expectFlow(const Scene& scene, double step = 0)
{
    testkit::expectVectors(
        scene, [&](const glm::dvec3& p) { return glm::dvec3(sampleFlow(glm::vec3(p), 0)) + glm::dvec3(step, 0, 0); });
}

TEST_F(EnSight, FacesAreTheSurfaceUnlessAPartIsNamed)
{
    constexpr std::size_t quads = kSampleCells * kSampleCells;
    for (const std::string& spec : {case_, case_ + ":walls", case_ + ":w*"}) {
        const Scene scene = loadScene(describe(spec));
        EXPECT_EQ(scene.surface.triangles.size(), 2 * quads) << spec;
        EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
        expectFlow(scene, 0);
    }
    EXPECT_EQ(loadScene(describe(case_ + ":fluid")).surface.triangles.size(), 12 * quads);
}

TEST_F(EnSight, TimesAreThoseOfTheCase)
{
    for (const double time : {0.0, 0.75, 1.5, 7.0}) {
        SceneDescription description = describe(case_ + ":walls");
        description.time.moment = time;
        expectFlow(loadScene(description), std::min(time / 1.5, 1.0));
    }
}

TEST_F(EnSight, FilesAreNumberedAsTheTimeSetSays)
{
    const std::string whole = readBytes(case_);
    std::filesystem::rename(folder_.file("U.0001"), folder_.file("U.0012"));
    std::filesystem::rename(folder_.file("q.0001"), folder_.file("q.0012"));
    std::filesystem::rename(folder_.file("p.0001"), folder_.file("p.0012"));
    SceneDescription description = describe(case_ + ":walls");
    description.time.moment = 1.5;
    EXPECT_THROW(loadScene(description), InputError);
    std::string text = whole;
    text.replace(text.find("increment: 1"), 12, "increment: 12");
    writeBytes(case_, text);
    expectFlow(loadScene(description), 1);
    text = whole;
    const std::size_t begin = text.find("filename start"), end = text.find("time values");
    writeBytes(case_, text.replace(begin, end - begin, "filename numbers: 0\n 12\n"));
    expectFlow(loadScene(description), 1);
}

/// All that may stand in a file, in text and in both byte orders, gives the same scene.
TEST_F(EnSight, EveryEncodingGivesTheSameScene)
{
    for (const bool ids : {false, true}) {
        std::vector<std::string> first;
        for (const EnSightFormat& format : formats) {
            writeSampleEnSight(folder_.path().string(), {format, ids, ids, true, true, true});
            std::vector<std::string> found;
            for (const char* spec : {":walls", ":fluid", ":mixed", ":slab,cube"})
                for (const char* color : {"p", "q"})
                    found.push_back(fingerprint(loadScene(describe(case_ + spec, "", color))));
            found.push_back(fingerprint(loadScene(describe(case_ + ":walls", case_, "field:p"))));
            found.push_back(describeFile(case_));
            if (first.empty()) first = found;
            EXPECT_EQ(found, first) << int(format.encoding) << format.swapped << ids;
        }
    }
}

vtkSmartPointer<vtkFloatArray> flowOf(const SamplePart& part)
{
    auto vectors = vtkSmartPointer<vtkFloatArray>::New();
    vectors->SetName("U");
    vectors->SetNumberOfComponents(3);
    for (const glm::vec3& p : part.points) {
        const glm::vec3 flow = sampleFlow(p, 0);
        vectors->InsertNextTuple3(double(flow.x), double(flow.y), double(flow.z));
    }
    return vectors;
}

vtkSmartPointer<vtkPoints> pointsOf(const SamplePart& part)
{
    auto points = vtkSmartPointer<vtkPoints>::New();
    for (const glm::vec3& p : part.points) points->InsertNextPoint(double(p.x), double(p.y), double(p.z));
    return points;
}

std::vector<vtkIdType> cornersOf(const std::vector<int>& cell)
{
    std::vector<vtkIdType> corners;
    for (const int corner : cell) corners.push_back(corner - 1);
    return corners;
}

TEST_F(EnSight, TheSameDataFromVtkFilesIsTheSameScene)
{
    const SamplePart walls = sampleWalls(), fluid = sampleFluid();
    vtkNew<vtkPolyData> faces;
    vtkNew<vtkCellArray> polygons;
    for (const auto& cell : walls.elements[0].cells) {
        const auto corners = cornersOf(cell);
        polygons->InsertNextCell(vtkIdType(corners.size()), corners.data());
    }
    faces->SetPoints(pointsOf(walls));
    faces->SetPolys(polygons);
    faces->GetPointData()->AddArray(flowOf(walls));
    writeDataSet(folder_.file("walls.vtp"), *faces, Encoding::raw);
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(pointsOf(fluid));
    for (const auto& cell : fluid.elements[0].cells) grid->InsertNextCell(VTK_HEXAHEDRON, 8, cornersOf(cell).data());
    grid->GetPointData()->AddArray(flowOf(fluid));
    writeDataSet(folder_.file("fluid.vtu"), *grid, Encoding::raw);
    EXPECT_EQ(fingerprint(loadScene(describe(folder_.file("walls.vtp")))), fingerprint(loadScene(describe(case_))));
    for (const std::string& surface :
         {folder_.file("walls.vtp"), std::string("boundary"), std::string("slice:2,2,2:0,0,1")})
        EXPECT_EQ(fingerprint(loadScene(describe(surface, folder_.file("fluid.vtu")))),
                  fingerprint(loadScene(describe(surface, case_ + ":fluid"))))
            << surface;
}

/// Slices through cubes that are made of other kinds of cells each: of area 1, with a flow that is linear.
TEST_F(EnSight, EveryKindOfElement)
{
    writeSampleEnSight(folder_.path().string(), {.mixed = true});
    const std::string field = case_ + ":mixed";
    for (const char* height : {"0.5", "1.5"}) {
        const Scene scene = loadScene(describe(std::string("slice:10,0,") + height + ":0,0,1", field));
        EXPECT_NEAR(areaOf(scene.surface), 1, 1e-5) << height;
        expectFlow(scene, 0);
    }
    // Tetrahedra and a pyramid overlap in the tip.
    EXPECT_NEAR(areaOf(loadScene(describe("slice:10,0,2.5:0,0,1", field)).surface), 0.5, 1e-5);
    const std::string told = describeFile(case_);
    EXPECT_NE(told.find("mixed  volume     11"), std::string::npos) << told;
}

TEST_F(EnSight, Blocks)
{
    writeSampleEnSight(folder_.path().string(), {.blocks = true});
    const Scene slab = loadScene(describe(case_ + ":slab"));
    EXPECT_EQ(slab.surface.triangles.size(), 12U);
    expectFlow(slab, 0);
    const Scene cube = loadScene(describe("slice:21,1,1.5:0,0,1", case_ + ":cube"));
    EXPECT_NEAR(areaOf(cube.surface), 4, 1e-5);
    expectFlow(cube, 0);
    const Scene boundary = loadScene(describe(case_ + ":cube"));
    EXPECT_NEAR(areaOf(boundary.surface), 24, 1e-5);
}

TEST_F(EnSight, WordsMayHaveTabsBetweenThem)
{
    writeSampleEnSight(folder_.path().string(), {.blocks = true});
    const std::string geometry = folder_.file("box.geo");
    std::string bytes = readBytes(geometry);
    const std::size_t at = bytes.find("block uniform");
    ASSERT_NE(at, std::string::npos);
    bytes[at + 5] = '\t';
    writeBytes(geometry, bytes);
    EXPECT_NEAR(areaOf(loadScene(describe(case_ + ":cube")).surface), 24, 1e-5);
}

/// The field is what fills space, however many parts it has.
TEST_F(EnSight, AllCellsAreTheField)
{
    writeSampleEnSight(folder_.path().string(), {.blocks = true});
    EXPECT_NEAR(areaOf(loadScene(describe("slice:2,2,1.5:0,0,1", case_)).surface), 16 + 4, 1e-4);
    EXPECT_NEAR(areaOf(loadScene(describe("slice:2,2,1.5:0,0,1", case_ + ":fluid")).surface), 16, 1e-4);
}

TEST_F(EnSight, UndefinedAndPartialValuesAreMissing)
{
    writeSampleEnSight(folder_.path().string(), {.gaps = true});
    const auto missing = [&](const char* name) {
        SceneDescription description = describe(case_ + ":walls", "", name);
        description.surface.cells = CellValues::steps;
        const SurfaceMesh mesh = loadScene(description).surface;
        const auto& values = mesh.pointScalars.empty() ? mesh.cellScalars : mesh.pointScalars;
        return std::pair{std::count_if(values.begin(), values.end(), [](float v) { return std::isnan(v); }),
                         values.size()};
    };
    EXPECT_EQ(missing("q"), (std::pair<long, std::size_t>{1, 25}));
    const auto [gone, all] = missing("p");
    EXPECT_EQ(all, std::size_t(2 * kSampleCells * kSampleCells));  // Two triangles each.
    EXPECT_EQ(gone, long(all) - 2);
}

/// A file without values for a part is no fault: many variables are those of the walls alone.
TEST_F(EnSight, APartWithoutValuesIsMissing)
{
    EnSightBytes file{EnSightFormat{}};
    file.text("of the fluid").text("part").whole({1}).text("hexa8").reals(std::vector<float>(64, 3));
    for (const char* name : {"p.0000", "p.0001"}) writeBytes(folder_.file(name), file.bytes());
    const Scene scene = loadScene(describe(case_ + ":walls", "", "p"));
    EXPECT_FALSE(scene.scalarRangeKnown);
}

TEST_F(EnSight, AFolderWhoseNameEndsSoIsAnOpenFoamCase)
{
    writeSampleCase(folder_.file("channel.case"));
    SceneDescription description = describe(folder_.file("channel.case"));
    description.field.vectors = "wallShearStress";
    EXPECT_FALSE(loadScene(description).surface.triangles.empty());
}

TEST_F(EnSight, InfoTellsPartsTimesAndWhatToTry)
{
    const std::string text = describeFile(case_);
    for (const char* what : {"an EnSight case\n", "fluid", "walls", "2, from 0 to 1.5", "U ", "p ", "q ",
                             "render --surface ", "render --field "})
        EXPECT_NE(text.find(what), std::string::npos) << what << "\n" << text;
}

}  // namespace
}  // namespace aeolic
