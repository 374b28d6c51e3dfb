#include <gtest/gtest.h>

#include <fmt/format.h>

#include <filesystem>

#include "data/load/file_info.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "load_testing.h"
#include "reader/openfoam/testing/sample_case.h"
#include "same_bytes_testing.h"

/// The walls of an OpenFOAM case with the flow of its own cells.
namespace aeolic {
namespace {

using namespace test;

class OpenFoamNearWall : public testing::Test {
protected:
    SceneDescription describe(const std::string& part, const SampleCase& sample = {}) const
    {
        const std::string path = folder_.file("case");
        writeSampleCase(path, sample);
        SceneDescription description;
        description.surface.spec = path + part;
        description.field.spec = path;
        description.field.vectors = "U";
        return description;
    }

    /// The cells beside the wall have `speed` along x, and up to 0.4 more than `time` along z. The last of the roof's
    /// has another number than its place has, and so another value.
    static void expectFlowBeside(const Scene& scene, float speed, float time)
    {
        EXPECT_FALSE(scene.field);
        EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
        ASSERT_GE(scene.surface.pointVectors.size(), 36u);
        for (std::size_t i = 0; i < scene.surface.positions.size(); ++i) {
            if (scene.surface.originWorld.x + double(scene.surface.positions[i].x) > 1.7) continue;
            const glm::vec3& v = scene.surface.pointVectors[i];
            EXPECT_NEAR(v.x, speed, 1e-5f);
            EXPECT_GE(v.z, time - 1e-5f);
            EXPECT_LE(v.z, time + 0.4f + 1e-5f);
        }
    }

    const TempFolder folder_;
};

TEST_F(OpenFoamNearWall, WallsHaveTheFlowOfTheCellsBesideThem)
{
    for (const int processors : {0, 3}) {
        const SampleCase sample{.binary = true, .processors = processors};
        expectFlowBeside(loadScene(describe(":floor", sample)), 1, 1);
        expectFlowBeside(loadScene(describe(":roof", sample)), 4, 1);
    }
}

TEST_F(OpenFoamNearWall, EveryTimeHasItsOwn)
{
    OneRank alone;
    LoadedScene loaded(describe(":floor", {.times = {"0", "1", "3"}}), {}, alone);
    EXPECT_EQ(loaded.times(), (std::vector<double>{1, 3}));
    for (const double time : {3.0, 2.0, 1.0}) {
        loaded.moveTo(time);
        expectFlowBeside(loaded.scene(), 1, float(time));
    }
}

TEST_F(OpenFoamNearWall, TheShearIsTheCellsFlowOverItsHeight)
{
    SceneDescription description = describe(":roof");
    description.field.vectors = "wallShear(U)";
    description.shading.colorBy = "wallShear(U):mag";
    const Scene scene = loadScene(description);
    for (std::size_t i = 0; i < scene.surface.positions.size(); ++i) {
        const double x = scene.surface.originWorld.x + double(scene.surface.positions[i].x);
        if (x > 0.3) continue;  // Where the floor is flat the uppermost cells are a quarter high.
        EXPECT_NEAR(scene.surface.pointVectors[i].x, 4 / 0.125, 0.3);
    }
}

TEST_F(OpenFoamNearWall, ColoursAreOfEitherPlace)
{
    SceneDescription description = describe(":floor");
    description.shading.colorBy = "p";
    const Scene ofCells = loadScene(description);
    EXPECT_GE(ofCells.scalarRange[0], 1 - 1e-4);
    EXPECT_LE(ofCells.scalarRange[1], 208 + 1e-4) << "the lowest row: at most 7 + 200 + 1";
    description.shading.colorBy = "surface:wallShearStress:mag";
    const Scene ofWall = loadScene(description);
    EXPECT_EQ(ofWall.scalarName, "|wallShearStress|");
    EXPECT_GT(ofWall.scalarRange[0], 2);
}

TEST_F(OpenFoamNearWall, InfoSaysHowWallsGetTheirFlow)
{
    const std::string path = folder_.file("case");
    writeSampleCase(path);
    EXPECT_EQ(describeFile(path).find("--field " + path + " --vectors U --color-by"), std::string::npos);
    for (const char* time : {"0", "1"}) std::filesystem::remove(folder_.path() / "case" / time / "wallShearStress");
    EXPECT_NE(describeFile(path).find("--surface " + path + " --field " + path + " --vectors U"), std::string::npos)
        << describeFile(path);
}

TEST_F(OpenFoamNearWall, TheSameBytesFromRanksAndThreads)
{
    SceneDescription description = describe("", {.binary = true, .gzip = true, .processors = 3});
    description.output.width = 160;
    description.output.height = 120;
    for (const char* vectors : {"U", "wallShear(U)"}) {
        description.field.vectors = vectors;
        description.shading.colorBy = fmt::format("{}:mag", vectors);
        const testkit::Case c{"walls", description, {}};
        RunOptions options;
        options.threads = 1;
        const auto expected = testkit::draw("cpu", c, options, 1, 1);
        for (const int threads : {2, 4}) {
            options.threads = threads;
            testkit::expectSameBytes("cpu", c, expected, options, 1);
        }
        for (const int ranks : {2, 3, 4}) testkit::expectSameBytes("cpu", c, expected, {}, ranks);
    }
}

}  // namespace
}  // namespace aeolic
