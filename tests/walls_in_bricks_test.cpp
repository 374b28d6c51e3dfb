/// Walls at rest in a uniform field of which every rank holds a brick: the same bytes as of a field that is whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "aeolic/error.h"
#include "data/vtk/testing/sample_files.h"
#include "load_testing.h"
#include "pieces_testing.h"
#include "same_bytes_testing.h"

namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

/// Flow around the torus of TorusPieces, `strength` times as fast; within `rest` of the middle of its tube nothing
/// flows, or nothing is known.
void writeFlow(const std::string& path, double rest, double strength = 1, bool masked = false)
{
    constexpr int kN[] = {25, 24, 19};
    std::ofstream file(path);
    file << R"(<?xml version="1.0"?>
<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian">
<ImageData WholeExtent="0 24 0 23 0 18" Origin="998.5 -21.725 3.65" Spacing="0.15 0.15 0.15"><Piece Extent="0 24 0 23 0 18"><PointData>
<DataArray type="Float64" Name="U" NumberOfComponents="3" format="ascii">
)";
    std::vector<double> scalars;
    for (int k = 0; k < kN[2]; ++k)
        for (int j = 0; j < kN[1]; ++j)
            for (int i = 0; i < kN[0]; ++i) {
                const double x = 998.5 + 0.15 * i - 1000.3, y = 0.15 * j - 21.725 + 20, z = 3.65 + 0.15 * k - 5,
                             fromTube = std::hypot(std::hypot(x, y) - 1, z);
                if (fromTube < rest)
                    file << (masked ? "nan nan nan\n" : "0 -0 0\n");
                else
                    file << strength * (1 + 0.3 * std::sin(2 * z)) << ' ' << strength * std::cos(3 * x) << ' '
                         << strength * std::sin(2 * y) << '\n';
                scalars.push_back(x + y * z);
            }
    file << "</DataArray><DataArray type=\"Float64\" Name=\"p\" format=\"ascii\">\n";
    for (const double p : scalars) file << p << '\n';
    file << "</DataArray></PointData></Piece></ImageData></VTKFile>\n";
}

constexpr double kThick = 0.68;  // More than a cell's diagonal beyond the wall, which is 0.4 from the tube's middle.
constexpr Split kField{true, false}, kSurface{false, true}, kBoth{true, true};

class WallsInBricks : public testing::Test {
protected:
    WallsInBricks() { writeFlow(flow_, kThick); }

    Case describe() const
    {
        Case c{"walls", {}, {}};
        c.description.surface.spec = writeTorusPieces(folder_.path().string(), "torus");
        c.description.field.spec = flow_;
        c.description.shading.colorBy = "field:p";
        c.description.output.width = 130;
        c.description.output.height = 110;
        return c;
    }

    /// From every number of ranks and however the scene is split; looked up on the surface, or not.
    static void expectSamePictures(Case c, bool lookedUp)
    {
        const Scene whole = loadScene(c.description);
        EXPECT_EQ(whole.field == nullptr, lookedUp);
        const auto expected = draw("cpu", c, {}, 1, 1);
        for (const Split& split : {kField, kSurface, kBoth})
            for (const int ranks : {2, 3, 5}) {
                SCOPED_TRACE(testing::Message() << ranks << " ranks, " << (split.field ? "bricks " : "")
                                                << (split.surface ? "pieces" : ""));
                c.split = split;
                expectSameBytes("cpu", c, expected, {}, ranks);
                for (const Scene& part : loadParts(c.description, split, ranks)) {
                    EXPECT_EQ(part.field == nullptr, lookedUp);
                    EXPECT_EQ(part.warnings, whole.warnings);
                }
            }
    }

    const TempFolder folder_;
    const std::string flow_ = folder_.file("flow.vti");
};

TEST_F(WallsInBricks, TakeTheFlowBesideThem)
{
    expectSamePictures(describe(), true);
}

TEST_F(WallsInBricks, WithNothingKnownInTheBody)
{
    writeFlow(flow_, kThick, 1, true);
    expectSamePictures(describe(), true);
}

TEST_F(WallsInBricks, WithAnOffset)
{
    Case c = describe();
    c.description.field.offset = 0.4;
    expectSamePictures(c, true);
}

TEST_F(WallsInBricks, WithTheWallsShear)
{
    Case c = describe();
    c.description.field.vectors = "wallShear(U)";
    c.description.shading.colorBy = "wallShear(U):mag";
    expectSamePictures(c, true);
}

TEST_F(WallsInBricks, BetweenTwoSteps)
{
    writeFlow(folder_.file("step_0.vti"), kThick);
    writeFlow(folder_.file("step_1.vti"), kThick, 3);
    Case c = describe();
    c.description.field.spec = folder_.file("step_%d.vti");
    c.description.time.moment = 0.25;
    expectSamePictures(c, true);
}

TEST_F(WallsInBricks, NotWhereTheFlowReachesThem)
{
    writeFlow(flow_, 0.1);
    expectSamePictures(describe(), false);
}

/// Most of the surface is at rest, and beside it nothing flows either.
TEST_F(WallsInBricks, NotWhereNothingFlowsBesideThem)
{
    writeFlow(flow_, 1.3);
    expectSamePictures(describe(), false);
}

}  // namespace
}  // namespace aeolic
