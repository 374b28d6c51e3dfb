#include "data/load/value_percentiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "describe_testing.h"
#include "load_testing.h"
#include "pieces_testing.h"

namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

/// Rows of triangles of different areas, each with a value.
Scene sceneOf(const std::vector<float>& values, const std::vector<float>& areas)
{
    Scene scene;
    SurfaceMesh& mesh = scene.surface;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto first = std::uint32_t(3 * i);
        const float x = float(i), width = 2 * areas[i];
        mesh.positions.insert(mesh.positions.end(), {{x, 0, 0}, {x, width, 0}, {x, 0, 1}});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    mesh.cellScalars = values;
    scene.boundsWorld = mesh.bounds();
    scene.hasScalar = true;
    return scene;
}

TEST(ValuePercentiles, CountByArea)
{
    std::mt19937 random(7);
    std::vector<float> values, areas;
    for (int i = 0; i < 5000; ++i) {
        values.push_back(std::normal_distribution<float>(0, 3)(random));
        areas.push_back(std::uniform_real_distribution<float>(0.5f, 2)(random));
    }
    std::vector<std::pair<float, double>> sorted;
    double all = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        sorted.emplace_back(values[i], areas[i]);
        all += double(areas[i]);
    }
    std::sort(sorted.begin(), sorted.end());
    double sum = 0, low = sorted.back().first, high = sorted.front().first;
    for (const auto& [value, area] : sorted) {
        const double before = sum;
        sum += area;
        if (before <= 0.02 * all && sum > 0.02 * all) low = value;
        if (before < 0.98 * all && sum >= 0.98 * all) high = value;
    }
    const auto found = robustRangeOf(sceneOf(values, areas), nullptr);
    ASSERT_TRUE(found);
    EXPECT_EQ((*found)[0], low);
    EXPECT_EQ((*found)[1], high);
}

TEST(ValuePercentiles, AFewWildValuesDoNotCount)
{
    std::vector<float> values(1000, 1);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(i) / 1000 - 0.5f;
    values[3] = 4e18f;
    values[4] = -std::numeric_limits<float>::max();
    values[5] = std::numeric_limits<float>::quiet_NaN();
    const auto found = robustRangeOf(sceneOf(values, std::vector<float>(1000, 1)), nullptr);
    ASSERT_TRUE(found);
    EXPECT_NEAR((*found)[0], -0.48, 0.003);
    EXPECT_NEAR((*found)[1], 0.48, 0.003);
    EXPECT_FALSE(robustRangeOf(sceneOf({std::nanf("")}, {1}), nullptr));
    EXPECT_EQ(robustRangeOf(sceneOf({-0.25f}, {1}), nullptr), (std::array{-0.25, -0.25}));
}

/// Values of a field are taken as densely as its cells are, also in large triangles.
TEST(ValuePercentiles, OfAFieldOnALargeTriangle)
{
    const TempFolder folder;
    writeGridFile(folder.file("a.vti"));  // x from -1 to 1 on the slice.
    const Scene scene = loadScene(describe("slice:0,0,1:0,0,1", folder.file("a.vti"), "U:x"));
    EXPECT_NEAR(scene.robustRange[0], 0.04, 0.02);
    EXPECT_NEAR(scene.robustRange[1], 1.96, 0.02);
}

TEST(ValuePercentiles, AreTheSameFromAnyNumberOfRanks)
{
    const TempFolder folder;
    const std::string torus = writeTorusPieces(folder.path().string(), "torus"), field = folder.file("w.vti");
    writeWindingField(field);
    SceneDescription pieces, bricks = describe("boundary", field, "p");
    pieces.surface.spec = torus;
    pieces.shading.colorBy = "q";
    for (const auto& [description, split] :
         {std::pair{pieces, Split{false, true}}, std::pair{bricks, Split{true, false}}}) {
        const Scene alone = loadScene(description);
        EXPECT_LT(alone.scalarRange[0], alone.robustRange[0]);
        EXPECT_LT(alone.robustRange[0], alone.robustRange[1]);
        EXPECT_GT(alone.scalarRange[1], alone.robustRange[1]);
        for (const int ranks : {2, 3, 5})
            for (const Scene& part : loadParts(description, split, ranks))
                EXPECT_EQ(part.robustRange, alone.robustRange) << ranks;
    }
}

}  // namespace
}  // namespace aeolic
