#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "aeolic/error.h"
#include "data/load/loaded_scene.h"
#include "data/mesh/testing/mesh_topology_testing.h"
#include "data/vtk/testing/sample_files.h"
#include "describe_testing.h"

/// What vtkGhostType hides is left out in the same way from every kind of grid: what is shown is closed.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

class HiddenCells : public testing::Test {
protected:
    /// A box from -1 to 1 in x, of which what is beyond 0 is hidden.
    std::string write(const std::string& name, bool cells, bool onCells = false) const
    {
        GridSample sample;
        sample.hiddenBeyondX = cells ? 0 : 0.01;
        sample.hidesCells = cells;
        sample.onCells = onCells;
        sample.hexahedra = true;
        writeGridFile(folder_.file(name), sample);
        return folder_.file(name);
    }

    const TempFolder folder_;
};

TEST_F(HiddenCells, TheBoundaryOfWhatIsShownIsClosedInEveryFormat)
{
    for (const char* name : {"a.vti", "a.vtr", "a.vts", "a.vtu"})
        for (const bool cells : {false, true})
            for (const bool onCells : {false, true}) {
                SCOPED_TRACE(testing::Message()
                             << name << (cells ? " cells" : " points") << (onCells ? ", on cells" : ""));
                const Scene scene = loadScene(describe("boundary", write(name, cells, onCells), "p"));
                EXPECT_NEAR(scene.boundsWorld.lo.x, -1, 1e-6);
                EXPECT_NEAR(scene.boundsWorld.hi.x, 0, 1e-6);
                EXPECT_EQ(topologyOf(scene.surface).boundaryEdges, 0u);
                EXPECT_EQ(scene.surface.triangles.size(), 2u * 2 * (4 * 7 + 4 * 6 + 7 * 6));
                for (std::size_t i = 0; i < scene.surface.positions.size(); ++i) {
                    const glm::dvec3 p = scene.surface.originWorld + glm::dvec3(scene.surface.positions[i]);
                    if (onCells)
                        EXPECT_TRUE(std::isfinite(scene.surface.pointScalars[i]));
                    else
                        EXPECT_NEAR(scene.surface.pointScalars[i], sampleScalar(p.x, p.y, p.z), 1e-3);
                    EXPECT_TRUE(std::isfinite(scene.surface.pointVectors[i].x));
                }
            }
}

TEST_F(HiddenCells, ASliceEndsWhereTheShownCellsDo)
{
    for (const char* name : {"a.vti", "a.vtr", "a.vts", "a.vtu"}) {
        const Scene scene = loadScene(describe("slice:0,0,1:0,0,1", write(name, true), "p"));
        EXPECT_NEAR(scene.boundsWorld.hi.x, 0, 1e-6) << name;
        EXPECT_NEAR(scene.scalarRange[1], 0 + 12.5 + 100, 0.01) << name << ": nothing from beyond";
    }
}

/// A uniform field on another surface stays one, whose hidden samples are masked.
TEST_F(HiddenCells, HiddenPointsOfAUniformFieldAreMasked)
{
    const Scene scene = loadScene(describe("sphere", write("a.vti", false)));
    ASSERT_TRUE(scene.field);
    EXPECT_TRUE(std::isnan(scene.field->floats()[3 * 8]));
    EXPECT_FALSE(std::isnan(scene.field->floats()[0]));
}

TEST_F(HiddenCells, AGridThatHidesAllIsRefused)
{
    GridSample sample;
    sample.hiddenBeyondX = -10;
    sample.hidesCells = true;
    writeGridFile(folder_.file("a.vts"), sample);
    EXPECT_THROW(loadScene(describe("boundary", folder_.file("a.vts"))), InputError);
}

}  // namespace
}  // namespace aeolic
