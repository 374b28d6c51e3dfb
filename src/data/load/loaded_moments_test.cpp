#include "data/load/loaded_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aeolic/error.h"
#include "data/vtk/testing/sample_files.h"
#include "load_testing.h"

namespace aeolic {
namespace {

using namespace test;

std::string pvdText(const std::vector<std::pair<double, std::string>>& steps)
{
    std::string text = "<?xml version=\"1.0\"?><VTKFile type=\"Collection\"><Collection>";
    for (const auto& [time, file] : steps)
        text += "<DataSet timestep=\"" + std::to_string(time) + "\" file=\"" + file + "\"/>";
    return text + "</Collection></VTKFile>";
}

class LoadedMoments : public testing::Test {
protected:
    /// field.pvd with `scales.size()` steps a second apart from time 10 on, f0.vti being the first.
    void writeField(const std::vector<double>& scales, const GridSample& like = {}, const std::string& ending = ".vti")
    {
        std::vector<std::pair<double, std::string>> steps;
        for (std::size_t i = 0; i < scales.size(); ++i) {
            GridSample sample = like;
            sample.scale = scales[i];
            const std::string name = "f" + std::to_string(i) + ending;
            writeGridFile(folder.file(name), sample);
            steps.emplace_back(10.0 + double(i), name);
        }
        writeBytes(folder.file("field.pvd"), pvdText(steps));
    }
    SceneDescription describe(const std::string& surface, const std::string& field,
                              const std::string& colorBy = "") const
    {
        SceneDescription description;
        description.surface.spec = surface;
        description.field.spec = field;
        description.shading.colorBy = colorBy;
        return description;
    }
    SceneDescription describeField(const std::string& surface = "slice:0,0,1:0,0,1",
                                   const std::string& colorBy = "") const
    {
        return describe(surface, folder.file("field.pvd"), colorBy);
    }

    TempFolder folder;
    OneRank alone;
};

/// A sample far from the others' zeros: (x, y, z) = (0, 0.5, 1) is sample (4, 4, 3) of 9 x 8 x 7.
glm::vec3 sampleOf(const Scene& scene)
{
    const float* v = scene.field->floats() + 3 * ((3 * 8 + 4) * 9 + 4);
    return {v[0], v[1], v[2]};
}

TEST_F(LoadedMoments, AFieldBetweenTwoStepsIsTheirMean)
{
    writeField({1, 3});
    LoadedScene loaded(describeField(), {}, alone);
    const Scene& scene = loaded.scene();
    EXPECT_EQ(loaded.times(), (std::vector<double>{10, 11}));
    EXPECT_EQ(sampleOf(scene), glm::vec3(1, 1, -1));
    for (const auto& [moment, scale] :
         {std::pair{10.5, 2.0f}, {10.25, 1.5f}, {11.0, 3.0f}, {99.0, 3.0f}, {-99.0, 1.0f}}) {
        loaded.moveTo(moment);
        EXPECT_EQ(sampleOf(scene), scale * glm::vec3(1, 1, -1)) << "at " << moment;
    }
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(LoadedMoments, AScalarBetweenTwoStepsToo)
{
    writeField({1, 3});
    LoadedScene loaded(describeField("slice:0,0,1:0,0,1", "p"), {}, alone);
    const Scene& scene = loaded.scene();
    const auto range = scene.scalarRange;
    loaded.moveTo(10.5);
    EXPECT_FLOAT_EQ(scene.scalarField->floats()[(3 * 8 + 4) * 9 + 4], 2 * 105.0f);
    EXPECT_EQ(scene.scalarRange, range) << "colours stay those of the first step";
}

TEST_F(LoadedMoments, LoadSceneGivesTheMomentAskedFor)
{
    writeField({1, 3});
    SceneDescription description = describeField();
    description.time.moment = 10.5;
    EXPECT_EQ(sampleOf(loadScene(description)), glm::vec3(2, 2, -2));
    description.time = {std::nullopt, std::array{11.0, 10.0}};
    EXPECT_EQ(sampleOf(loadScene(description)), glm::vec3(3, 3, -3));
}

TEST_F(LoadedMoments, RangesOfAFlowThatStartsFromRestAreThoseOfItsEnd)
{
    writeField({0, 1, 4});
    const Scene scene = loadScene(describeField("slice:0,0,1:0,0,1", "p"));
    EXPECT_EQ(sampleOf(scene), glm::vec3(0, 0, 0));
    EXPECT_GT(scene.maxVector, 4);
    EXPECT_GT(scene.scalarRange[1], 400);
}

TEST_F(LoadedMoments, MaskedInEitherStepIsMaskedBetween)
{
    GridSample masked;
    masked.nanPoints = {7};
    writeGridFile(folder.file("w_1.vti"));
    writeGridFile(folder.file("w_2.vti"), masked);
    LoadedScene loaded(describe("boundary", folder.file("w_%d.vti")), {}, alone);
    const Scene& scene = loaded.scene();
    EXPECT_FALSE(std::isnan(scene.field->floats()[21]));
    loaded.moveTo(0.5);
    EXPECT_TRUE(std::isnan(scene.field->floats()[21]));
    EXPECT_FALSE(std::isnan(scene.field->floats()[24]));
}

TEST_F(LoadedMoments, OnDifferentGridsTheEarlierStepIsShownAndOneWarningSaysSo)
{
    GridSample other;
    other.dims = {9, 8, 6};
    other.scale = 5;
    writeGridFile(folder.file("w_1.vti"));
    writeGridFile(folder.file("w_2.vti"), other);
    LoadedScene loaded(describe("slice:0,0,1:0,0,1", folder.file("w_*.vti")), {}, alone);
    const Scene& scene = loaded.scene();
    for (const double moment : {0.5, 0.75}) {
        loaded.moveTo(moment);
        EXPECT_EQ(sampleOf(scene), glm::vec3(1, 1, -1));
    }
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("different grids"), std::string::npos);
    loaded.moveTo(1);
    EXPECT_EQ(scene.field->dims, (GridIndex{9, 8, 6}));
}

TEST_F(LoadedMoments, AStepWithoutTheArrayIsOneLineAndTheMomentStays)
{
    GridSample without;
    without.leaveOut = {"p"};
    writeGridFile(folder.file("w_1.vti"));
    writeGridFile(folder.file("w_2.vti"), without);
    LoadedScene loaded(describe("boundary", folder.file("w_*.vti"), "p"), {}, alone);
    const Scene& scene = loaded.scene();
    EXPECT_THROW(loaded.moveTo(1), InputError);
    EXPECT_EQ(sampleOf(scene), glm::vec3(1, 1, -1));
    loaded.moveTo(0);
    EXPECT_EQ(sampleOf(scene), glm::vec3(1, 1, -1));
}

TEST_F(LoadedMoments, SeveralStepsInOneFile)
{
    GridSample samples[3];
    for (int i = 0; i < 3; ++i) samples[i].scale = 1 + i;
    writeGridSteps(folder.file("steps.vti"), {samples[0], samples[1], samples[2]});
    LoadedScene loaded(describe("boundary", folder.file("steps.vti")), {}, alone);
    const Scene& scene = loaded.scene();
    EXPECT_EQ(loaded.times(), (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(sampleOf(scene), glm::vec3(1, 1, -1));
    loaded.moveTo(1.5);
    EXPECT_EQ(sampleOf(scene), glm::vec3(2.5, 2.5, -2.5));
}

TEST_F(LoadedMoments, NeverMoreThanTwoStepsAndOneAhead)
{
    writeField({1, 2, 3, 4, 5, 6});
    LoadedScene loaded(describeField(), {}, alone);
    const Scene& scene = loaded.scene();
    for (const double moment : {10.5, 11.5, 12.0, 14.5, 10.5, 13.25, 15.0}) {
        loaded.moveTo(moment);
        EXPECT_LE(loaded.held(), 3u) << moment;
        EXPECT_FLOAT_EQ(sampleOf(scene).x, float(moment - 9)) << moment;
        loaded.readAhead(moment + 1);
        EXPECT_LE(loaded.held(), 3u) << moment;
    }
}

TEST_F(LoadedMoments, WhatWasReadAheadIsNotReadAgain)
{
    writeField({1, 2, 3});
    LoadedScene loaded(describeField(), {}, alone);
    const Scene& scene = loaded.scene();
    loaded.moveTo(10.5);
    loaded.readAhead(11.5);
    loaded.moveTo(10.5);
    while (loaded.held() < 3) {
    }
    loaded.moveTo(11.5);  // Waits for the step.
    std::filesystem::remove(folder.file("f1.vti"));
    std::filesystem::remove(folder.file("f2.vti"));
    EXPECT_NO_THROW(loaded.moveTo(11.75)) << "both steps are in memory";
    EXPECT_FLOAT_EQ(sampleOf(scene).x, 2.75f);
}

TEST_F(LoadedMoments, AnErrorWhileReadingAheadComesWithTheStep)
{
    writeField({1, 2, 3});
    writeBytes(folder.file("f2.vti"), "damaged");
    LoadedScene loaded(describeField(), {}, alone);
    const Scene& scene = loaded.scene();
    loaded.moveTo(10.5);
    loaded.readAhead(12);
    loaded.moveTo(10.75);
    EXPECT_THROW(loaded.moveTo(12), InputError);
    loaded.moveTo(10.25);
    EXPECT_FLOAT_EQ(sampleOf(scene).x, 1.25f);
}

TEST_F(LoadedMoments, BricksHaveTheBitsOfTheWhole)
{
    writeField({1, 3});
    SceneDescription description = describeField();
    description.time.moment = 10.3;
    const Scene whole = loadScene(description);
    for (const Scene& part : testkit::loadParts(description, {true, false}, 3)) {
        const GridIndex first = part.field->firstSample(), held = part.field->heldDims();
        for (std::int64_t i = 0; i < held[0]; ++i) {
            const auto of = std::size_t(((first[2] * 8 + first[1]) * 9 + first[0] + i) * 3);
            EXPECT_EQ(part.field->floats()[3 * i], whole.field->floats()[of]);
        }
    }
}

TEST_F(LoadedMoments, ASurfaceMovesAndKeepsItsOriginAndBounds)
{
    SheetSample lower, upper;
    upper.shift = {4, 0, 2};
    upper.scale = 3;
    writeSheetFile(folder.file("s_0.vtp"), lower);
    writeSheetFile(folder.file("s_1.vtp"), upper);
    SceneDescription description = describe(folder.file("s_*.vtp"), "", "q");
    description.field.vectors = "tau";
    LoadedScene loaded(description, {}, alone);
    const Scene& scene = loaded.scene();
    const Bounds bounds = scene.boundsWorld;
    const glm::dvec3 origin = scene.surface.originWorld;
    loaded.moveTo(0.25);
    EXPECT_EQ(scene.surface.originWorld, origin) << "noise sticks to P-space";
    EXPECT_EQ(scene.boundsWorld.lo, bounds.lo) << "the camera's fit stays";
    EXPECT_NEAR(scene.surface.bounds().lo.x, 1, 1e-6);
    EXPECT_NEAR(scene.surface.bounds().lo.z, 0.5, 1e-6);
    for (const glm::vec3& v : scene.surface.pointVectors) EXPECT_NEAR(v.x, 1.5, 1e-6);
    EXPECT_NEAR(*std::max_element(scene.surface.pointScalars.begin(), scene.surface.pointScalars.end()), 3, 1e-6);
    EXPECT_TRUE(scene.warnings.empty());
}

/// A bent quad is cut along its shorter diagonal, which is the other one when it is bent the other way.
TEST_F(LoadedMoments, QuadsThatAreCutTheOtherWayAreStillTheSameMesh)
{
    SheetSample up, down;
    up.twist = 3;
    down.twist = -3;
    writeSheetFile(folder.file("s_0.vtp"), up);
    writeSheetFile(folder.file("s_1.vtp"), down);
    LoadedScene loaded(describe(folder.file("s_*.vtp"), "uniform:4,4,4"), {}, alone);
    const Scene& scene = loaded.scene();
    loaded.moveTo(0.5);
    EXPECT_TRUE(scene.warnings.empty());
    for (const glm::vec3& p : scene.surface.positions) {
        const glm::dvec3 world = glm::dvec3(p) + scene.surface.originWorld;
        EXPECT_NEAR(world.z, 0.1 * world.x, 1e-5) << "halfway it is flat";
    }
}

TEST_F(LoadedMoments, WhereTheTopologyChangesTheEarlierStepIsShown)
{
    SheetSample coarse, fine;
    fine.n = 9;
    fine.shift = {0, 0, 0.01};
    writeSheetFile(folder.file("s_0.vtp"), coarse);
    writeSheetFile(folder.file("s_1.vtp"), fine);
    LoadedScene loaded(describe(folder.file("s_*.vtp"), "abc:8,8,8"), {}, alone);
    const Scene& scene = loaded.scene();
    const std::size_t coarseTriangles = scene.surface.triangles.size();
    SceneChange change = loaded.moveTo(0.5);
    EXPECT_EQ(scene.surface.triangles.size(), coarseTriangles);
    EXPECT_FALSE(change.triangles);
    EXPECT_FALSE(change.field) << "the built-in flow is that of the first moment";
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("different meshes"), std::string::npos);
    change = loaded.moveTo(1);
    EXPECT_TRUE(change.triangles);
    EXPECT_EQ(scene.surface.triangles.size(), 162u);
}

TEST_F(LoadedMoments, AnIsosurfaceIsCutOutOfEachStep)
{
    writeField({1, 2});
    LoadedScene loaded(describeField("isosurface:p=100"), {}, alone);
    const Scene& scene = loaded.scene();
    loaded.moveTo(11);
    for (const glm::vec3& p : scene.surface.positions) {
        const glm::dvec3 world = glm::dvec3(p) + scene.surface.originWorld;
        EXPECT_NEAR(2 * sampleScalar(world.x, world.y, world.z), 100, 1e-3);
    }
}

TEST_F(LoadedMoments, ACutThatCarriesItsVectorsIsInterpolated)
{
    writeField({1, 3}, {}, ".vtu");
    LoadedScene loaded(describeField("slice:0,0,1:0,0,1", "p"), {}, alone);
    const Scene& scene = loaded.scene();
    ASSERT_FALSE(scene.field);
    loaded.moveTo(10.5);
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
    for (std::size_t i = 0; i < scene.surface.positions.size(); ++i) {
        const glm::dvec3 p = glm::dvec3(scene.surface.positions[i]) + scene.surface.originWorld;
        EXPECT_NEAR(scene.surface.pointVectors[i].x, 2 * (1 + p.x), 1e-5);
        EXPECT_NEAR(scene.surface.pointScalars[i], 2 * sampleScalar(p.x, p.y, p.z), 1e-3);
    }
}

TEST_F(LoadedMoments, SurfaceAndFieldHaveTimesOfTheirOwn)
{
    writeField({1, 3});  // At 10 and 11.
    SheetSample sheet, moved;
    moved.shift = {0.1, 0, 0};
    for (SheetSample* s : {&sheet, &moved}) s->shift[2] += 0.5;
    writeSheetFile(folder.file("a.vtp"), sheet);
    writeSheetFile(folder.file("b.vtp"), moved);
    writeBytes(folder.file("s.vtp.series"),
               R"({"files": [{"name": "a.vtp", "time": 9.5}, {"name": "b.vtp", "time": 10.5}]})");
    LoadedScene loaded(describe(folder.file("s.vtp.series"), folder.file("field.pvd")), {}, alone);
    const Scene& scene = loaded.scene();
    EXPECT_EQ(loaded.times(), (std::vector<double>{9.5, 10, 10.5, 11}));
    loaded.moveTo(9.75);
    EXPECT_NEAR(scene.surface.bounds().lo.x, 0.025, 1e-6);
    EXPECT_EQ(sampleOf(scene), glm::vec3(1, 1, -1));
    loaded.moveTo(10.75);
    EXPECT_NEAR(scene.surface.bounds().lo.x, 0.1, 1e-6);
    EXPECT_EQ(sampleOf(scene), glm::vec3(2.5, 2.5, -2.5));
}

TEST_F(LoadedMoments, BuiltInsHaveAnyMoment)
{
    LoadedScene loaded(describe("wave:800", "gyre:8,8,8"), {}, alone);
    const Scene& scene = loaded.scene();
    EXPECT_EQ(loaded.times().front(), 0);
    EXPECT_EQ(loaded.times().back(), 10);
    const Bounds bounds = scene.boundsWorld;
    EXPECT_FLOAT_EQ(float(bounds.hi.z), 0.1f);
    EXPECT_TRUE(loaded.moveTo(1.2345).field);
    EXPECT_EQ(scene.boundsWorld.hi, bounds.hi);
    EXPECT_EQ(scene.field->originWorld.z, bounds.lo.z) << "the flow's box stays";
    EXPECT_FALSE(loaded.moveTo(1.2345).any()) << "nothing more to change";
}

TEST_F(LoadedMoments, WhatDoesNotChangeHasNoTimes)
{
    LoadedScene loaded(describe("teapot:600", "abc:8,8,8"), {}, alone);
    EXPECT_FALSE(loaded.moves());
    EXPECT_FALSE(loaded.moveTo(3).any());
}

}  // namespace
}  // namespace aeolic
