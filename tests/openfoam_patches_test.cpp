#include <filesystem>
#include <fstream>

#include "data/vtk/surface/surface_file.h"
#include "openfoam_testing.h"
#include "reader/openfoam/testing/sample_case.h"

/// Which of several entries of a boundaryField a patch takes.
namespace aeolic {
namespace {

using namespace openfoam_testing;

class OpenFoamPatches : public testing::Test {
protected:
    void SetUp() override { writeSampleCase(folder.file("case"), {.times = {"1"}}); }

    /// The x component on patch `floor`, a wall of the groups wall and solid, where these are the entries, in this
    /// order, and each has its own value: 1, 2, 3 …
    float valueOnFloor(const std::vector<std::string>& keys) const
    {
        std::ofstream out(folder.path() / "case/1/wallShearStress");
        out << "FoamFile { version 2.0; format ascii; class volVectorField; object wallShearStress; }\n"
               "dimensions [0 2 -2 0 0 0 0];\ninternalField uniform (0 0 0);\nboundaryField\n{\n";
        for (std::size_t i = 0; i < keys.size(); ++i)
            out << keys[i] << " { type calculated; value uniform (" << i + 1 << " 0 0); }\n";
        out << "}\n";
        out.close();
        SurfaceArrays arrays{true, "wallShearStress", ""};
        arrays.parts = {"floor"};
        const LoadedSurface surface = readSurfaceFile(folder.file("case"), arrays, {});
        EXPECT_EQ(surface.mesh.cellVectors.size(), 2u * kSampleFloorFaces);
        const float found = surface.mesh.cellVectors.front().x;
        for (const glm::vec3& v : surface.mesh.cellVectors) EXPECT_EQ(v, glm::vec3(found, 0, 0));
        return found;
    }

    const TempFolder folder;
};

TEST_F(OpenFoamPatches, OfSeveralGroupsTheLastCounts)
{
    EXPECT_EQ(valueOnFloor({"solid", "wall"}), 2);
    EXPECT_EQ(valueOnFloor({"wall", "solid"}), 2);
    EXPECT_EQ(valueOnFloor({"wall", "solid", "inlet"}), 2) << "another patch's";
}

TEST_F(OpenFoamPatches, OfSeveralPatternsTheLastCounts)
{
    EXPECT_EQ(valueOnFloor({"\"fl.*\"", "\".*r\""}), 2);
    EXPECT_EQ(valueOnFloor({"\".*r\"", "\"fl.*\"", "\"in.*\""}), 2);
    EXPECT_EQ(valueOnFloor({"\"f(loor|all)\"", "\"floo\""}), 1) << "a pattern is for all of the name";
}

TEST_F(OpenFoamPatches, ANameCountsMoreThanAGroupAndAGroupMoreThanAPattern)
{
    EXPECT_EQ(valueOnFloor({"solid", "\".*\""}), 1);
    EXPECT_EQ(valueOnFloor({"\".*\"", "solid"}), 2);
    EXPECT_EQ(valueOnFloor({"floor", "solid", "\".*\""}), 1);
    EXPECT_EQ(valueOnFloor({"solid", "\".*\"", "floor"}), 3);
    EXPECT_EQ(valueOnFloor({"\"floor\"", "solid"}), 2) << "a name in quotes is a pattern";
}

}  // namespace
}  // namespace aeolic
