#include <gtest/gtest.h>

#include <mutex>

#include "data/vtk/testing/sample_files.h"
#include "load_testing.h"
#include "pieces_testing.h"

/// What is said of a scene is said of all of it, however many ranks hold its parts.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;
using Lines = std::vector<std::string>;

SceneDescription describe(const std::string& surface, const std::string& field, const std::string& colorBy = "")
{
    SceneDescription description;
    description.surface.spec = surface;
    description.field.spec = field;
    description.shading.colorBy = colorBy;
    description.run.bricks = BrickChoice::on;
    return description;
}

Lines warningsOfRanks(const SceneDescription& description, int ranks)
{
    std::vector<Lines> all(std::size_t(ranks), Lines{});
    runRanks(ranks, [&](Communicator& communicator) {
        all[std::size_t(communicator.rank())] = loadOnRank(communicator, description).warnings;
    });
    for (const Lines& lines : all) EXPECT_EQ(lines, all[0]) << "every rank's";
    return all[0];
}

/// A sphere is larger than the sample grids, so some scenes have less than half of their surface in the field.
Lines withoutBlanks(Lines lines)
{
    std::erase_if(lines, [](const std::string& line) { return line.find("has no streaks") != std::string::npos; });
    return lines;
}

/// The one-rank warnings, which have to be `expected` but for blank surfaces, from any number of ranks.
void expectWarnings(const SceneDescription& description, const Lines& expected)
{
    const Lines alone = loadScene(description).warnings;
    EXPECT_EQ(withoutBlanks(alone), expected);
    for (const int ranks : {1, 2, 3, 5, 13}) EXPECT_EQ(warningsOfRanks(description, ranks), alone) << ranks << " ranks";
}

class Warnings : public testing::Test {
protected:
    std::string grid(const GridSample& sample) const
    {
        writeGridFile(folder_.file("a.vti"), sample);
        return folder_.file("a.vti");
    }
    /// Every fifth sample of 9 x 8 x 7: some are ghosts of any brick, and some lie at every face.
    static GridSample manyHoles()
    {
        GridSample sample;
        for (int i = 0; i < 9 * 8 * 7; i += 5) sample.nanPoints.push_back(i);
        sample.maskedPoints = {1, 2, 251, 503};
        return sample;
    }
    TempFolder folder_;
};

TEST_F(Warnings, CountMaskedSamplesOnce)
{
    const std::string file = grid(manyHoles());
    for (const char* surface : {"sphere", "boundary", "slice:0,0.4,1:0,0,1"})
        expectWarnings(describe(surface, file, "p"),
                       {file + ": array 'U': 4 masked, 101 not finite of 504 points, left blank",
                        file + ": array 'p': 4 masked of 504 points, left blank"});
}

/// Bricks then hold a layer of their neighbours' samples on every side.
TEST_F(Warnings, CountMaskedSamplesOnceWhereAnIsosurfaceIsCut)
{
    GridSample sample;
    sample.nanPoints = {251, 260};
    sample.maskedPoints = {252};
    const std::string file = grid(sample);
    expectWarnings(describe("isosurface:p=104", file),
                   {file + ": array 'U': 1 masked, 2 not finite of 504 points, left blank",
                    file + ": array 'p': 1 masked of 504 points, left blank"});
}

TEST_F(Warnings, CountValuesTooLargeForHalvesOnce)
{
    GridSample sample;
    sample.scale = 33000;  // U = (1 + x, 2 y, x - z) comes to (2, 2.5, 2).
    const std::string file = grid(sample);
    SceneDescription description = describe("sphere", file);
    description.field.precision = FieldPrecision::float16;
    const Lines alone = withoutBlanks(loadScene(description).warnings);
    ASSERT_EQ(alone.size(), 1u);
    EXPECT_NE(alone[0].find(" values beyond 65504, the largest half, were set to it"), std::string::npos) << alone[0];
    expectWarnings(description, alone);
}

/// Vectors are long enough in some bricks and too short in others.
TEST_F(Warnings, ShortVectorsInOneBrickAreNoReasonToWarn)
{
    SceneDescription description = describe("sphere", "rotation:40,40,40");
    description.field.precision = FieldPrecision::float16;
    expectWarnings(description, {});
    GridSample sample;
    sample.scale = 1e-5;
    const std::string file = grid(sample);
    description = describe("sphere", file);
    description.field.precision = FieldPrecision::float16;
    const Lines alone = withoutBlanks(loadScene(description).warnings);
    ASSERT_EQ(alone.size(), 1u);
    EXPECT_NE(alone[0].find("lose accuracy"), std::string::npos) << alone[0];
    expectWarnings(description, alone);
}

TEST_F(Warnings, CountTrianglesOfAllPieces)
{
    TorusPieces bad;
    bad.pieces = 7;
    bad.empty = {2};
    bad.noArea = 5;
    bad.notFinite = 3;
    const std::string file = writeTorusPieces(folder_.path().string(), "torus", bad);
    const SceneDescription description = describe(file, "", "q");
    const Lines alone = withoutBlanks(loadScene(description).warnings);
    ASSERT_EQ(alone.size(), 2u);
    EXPECT_NE(alone[0].find("cells left out: a corner is not finite"), std::string::npos) << alone[0];
    EXPECT_NE(alone[1].find("triangles left out: they have no area"), std::string::npos) << alone[1];
    expectWarnings(description, alone);
}

}  // namespace
}  // namespace aeolic
