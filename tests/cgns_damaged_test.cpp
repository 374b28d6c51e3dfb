#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
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

namespace aeolic {
namespace {

using namespace test;
using namespace testkit;
using Cells = SampleCgns::Cells;
using Wholes = std::vector<std::int64_t>;

class CgnsDamaged : public testing::Test {
protected:
    void write(const SampleCgns& sample) const { writeSampleCgns(file_, sample); }

    /// Loads a boundary with all that it has, and the field. What is refused is one line; empty where nothing is.
    std::string complaint(const std::string& part = ":floor") const
    {
        SceneDescription description;
        description.surface.spec = file_ + part;
        description.field.vectors = "Velocity";
        description.shading.colorBy = "Pressure";
        return complaintOf([&] {
            loadScene(description);
            description.field.spec = file_;
            loadScene(description);
        });
    }

    void expectComplaint(const std::vector<std::string>& texts, const std::string& part = ":floor") const
    {
        expectSays(complaint(part), texts);
    }

    template <class Number>
    void replace(const std::string& node, const std::vector<std::uint64_t>& shape,
                 const std::vector<Number>& values) const
    {
        replaceHdf5(file_, node + "/ data", shape, values);
    }

    void replace(const std::string& node, const std::string& text) const
    {
        replace(node, {text.size()}, std::vector<std::int8_t>(text.begin(), text.end()));
    }

    TempFolder folder_;
    std::string file_ = folder_.file("box.cgns");
};

TEST_F(CgnsDamaged, OtherFiles)
{
    writeBytes(file_, "no CGNS at all");
    expectComplaint({"box.cgns", "does not begin like an HDF5 file"});
    writeBytes(file_, std::string("@(#)ADF Database Version B02012>") + std::string(200, ' '));
    expectComplaint({"box.cgns", "cannot be read as ADF"});
    {
        Hdf5Writer writer(file_);
    }
    expectComplaint({"box.cgns", "not one of CGNS"});
    write({});
    removeHdf5(file_, "/Base/box");
    expectComplaint({"box.cgns", "no zones"});
}

TEST_F(CgnsDamaged, Zones)
{
    write({});
    replace("/Base/box", {3, 3}, Wholes{5, 5, 1 << 30, 4, 4, 4, 0, 0, 0});
    expectComplaint({"box.cgns", "'/Base/box/GridCoordinates/CoordinateX'", "5 x 5 x 5", "5 x 5 x 1073741824"});
    replace("/Base/box", {3, 3}, Wholes{5, 5, std::int64_t{1} << 60, 4, 4, 4, 0, 0, 0});
    expectComplaint({"box.cgns", "5 x 5 x 5", "5 x 5 x 1152921504606846976"});
    replace("/Base/box", {3, 3}, Wholes{5, 5, -5, 4, 4, 4, 0, 0, 0});
    expectComplaint({"'/Base/box'", "5 x 5 x -5 points"});
    replace("/Base/box", {3, 3}, Wholes{5, 5, 0, 4, 4, 0, 0, 0, 0});
    expectComplaint({"'/Base/box'", "5 x 5 x 0 points"});
    replace("/Base/box", {2}, Wholes{5, 5});
    expectComplaint({"'/Base/box'", "its size has 2 numbers", "9"});
    replace("/Base/box", {1}, std::vector<double>{5});
    expectComplaint({"'/Base/box'", "no whole numbers"});
    write({});
    replace("/Base", {2}, Wholes{7, 3});
    expectComplaint({"'/Base'", "how many dimensions"});
    write({});
    removeHdf5(file_, "/Base/box/GridCoordinates/CoordinateY");
    expectComplaint({"'/Base/box/GridCoordinates'", "no CoordinateX or CoordinateY"});
    removeHdf5(file_, "/Base/box/GridCoordinates");
    expectComplaint({"'/Base/box'", "no coordinates"});
    write({});
    std::vector<double> far(125, 1e31);
    replace("/Base/box/GridCoordinates/CoordinateX", {5, 5, 5}, far);
    expectComplaint({"box.cgns", "'box/floor'", "a coordinate is 1e+31", "1e30"});
    write({.rind = true});
    replace("/Base/box/GridCoordinates/Rind", {6}, Wholes{-1, 1, 1, 1, 1, 1});
    expectComplaint({"'/Base/box/GridCoordinates/CoordinateX'", "-1 and 1 layers"});
}

TEST_F(CgnsDamaged, Elements)
{
    const std::string cells = "/Base/box/cells", corners = cells + "/ElementConnectivity",
                      offsets = cells + "/ElementStartOffset";
    write({.cells = Cells::hexahedra});
    replace(corners, {8 * 64}, Wholes(8 * 64, 126));
    expectComplaint({"'/Base/box/cells'", "the corner 126", "1 to 125"}, ":box");
    replace(corners, {8 * 64}, Wholes(8 * 64, 0));
    expectComplaint({"'/Base/box/cells'", "the corner 0", "1 to 125"}, ":box");
    replace(corners, {7}, Wholes(7, 1));
    expectComplaint({"'/Base/box/cells'", "element 1 of kind 17 is not there"}, ":box");
    replace(corners, {8 * 65}, Wholes(8 * 65, 1));
    expectComplaint({"'/Base/box/cells'", "520 corners", "512"}, ":box");
    removeHdf5(file_, corners);
    expectComplaint({"'/Base/box/cells'", "no ElementConnectivity"}, ":box");
    write({.cells = Cells::hexahedra});
    replace(cells, {2}, Wholes{99, 0});
    expectComplaint({"'/Base/box/cells'", "unknown kind 99"});
    replace(cells, {2}, Wholes{17, 0});
    replace(cells + "/ElementRange", {2}, Wholes{1, std::int64_t{1} << 50});
    expectComplaint({"'/Base/box/floorFaces'", "begin at 65", "more than 1125899906842624"});
    replace(cells + "/ElementRange", {2}, Wholes{1, 70});
    expectComplaint({"'/Base/box/floorFaces'", "begin at 65", "more than 70"});
    replace(cells + "/ElementRange", {2}, Wholes{-5, 64});
    expectComplaint({"'/Base/box/cells'", "which elements"});
    write({.cells = Cells::mixed});
    Wholes wrong(9 * 64, 1);
    wrong[0] = 17;
    replace(corners, {9 * 64}, wrong);
    expectComplaint({"'/Base/box/cells'", "element 2 of kind 1 is not there"}, ":box");
    write({.cells = Cells::polyhedra});
    replace(offsets, {65}, Wholes(65, 6));
    expectComplaint({"ElementStartOffset'", "65 numbers", "from 0 on"}, ":box");
    Wholes falling(65, 0);
    falling[3] = 12;
    replace(offsets, {65}, falling);
    expectComplaint({"ElementStartOffset'", "none smaller than the one before"}, ":box");
    Wholes without(65);
    for (std::size_t i = 0; i < without.size(); ++i) without[i] = i == 1 ? 0 : 6 * std::int64_t(i);
    replace(offsets, {65}, without);
    expectComplaint({"'/Base/box/cells'", "element 241 has 0 faces"}, ":box");
    write({.cells = Cells::polyhedra});
    replace(corners, {6 * 64}, Wholes(6 * 64, 1));
    expectComplaint({"'/Base/box/cells'", "the face 1 belongs to three cells"}, ":box");
    replace(corners, {6 * 64}, Wholes(6 * 64, 300));
    expectComplaint({"'/Base/box/cells'", "a cell has the face 300", "a polygon"}, ":box");
    replace(corners, {6 * 64}, Wholes(6 * 64, std::numeric_limits<std::int64_t>::min()));
    expectComplaint({"'/Base/box/cells'", "a cell has the face -9223372036854775807"}, ":box");
}

TEST_F(CgnsDamaged, Boundaries)
{
    const std::string floor = "/Base/box/ZoneBC/floor";
    write({});
    replace(floor + "/PointRange", {2, 3}, Wholes{1, 1, 1, 5, 6, 1});
    expectComplaint({"'/Base/box/ZoneBC/floor'", "from 1 to 6", "1 to 5 in the direction j"});
    replace(floor + "/PointRange", {2, 3}, Wholes{1, 1, 0, 5, 5, 0});
    expectComplaint({"'/Base/box/ZoneBC/floor'", "from 0 to 0", "1 to 5 in the direction k"});
    replace(floor + "/PointRange", {2, 3}, Wholes{1, 1, 1, 5, 5, 5});
    expectComplaint({"'/Base/box/ZoneBC/floor'", "not one layer"});
    replace(floor + "/PointRange", {3}, Wholes{1, 1, 1});
    expectComplaint({"'/Base/box/ZoneBC/floor'", "one by one"});
    write({.cells = Cells::hexahedra});
    replace(floor + "/PointRange", {2}, Wholes{65, 1000});
    expectComplaint({"'/Base/box/ZoneBC/floor'", "the number 1000", "1 to 112"});
    replace(floor + "/PointRange", {2}, Wholes{80, 65});
    expectComplaint({"'/Base/box/ZoneBC/floor'", "its range is 80 to 65"});
    replace(floor + "/PointRange", {2}, Wholes{60, 70});
    expectComplaint({"'/Base/box/ZoneBC/floor'", "the element 60 is not a face"});
    write({.cells = Cells::hexahedra, .byPoints = true});
    replace(floor + "/PointList", {2}, Wholes{1, 126});
    expectComplaint({"'/Base/box/ZoneBC/floor'", "the number 126", "1 to 125"});
    write({.onFaces = true});
    replace("/Base/box/onFloor/Pressure", {3}, std::vector<double>{1, 2, 3});
    expectComplaint({"'/Base/box/ZoneBC/floor'", "3 values on its faces", "16"});
    write({});
    expectComplaint({"box.cgns", "no part 'flor'", "box/floor", "floor?"}, ":flor");
}

TEST_F(CgnsDamaged, Values)
{
    write({});
    replace("/Base/box/Points/VelocityX", {25, 5}, std::vector<double>(125));
    EXPECT_EQ(complaint(), "");  // As many, in another shape.
    replace("/Base/box/Points/VelocityX", {124}, std::vector<double>(124));
    expectComplaint({"'/Base/box/Points/VelocityX'", "124 numbers", "5 x 5 x 5"});
    removeHdf5(file_, "/Base/box/Points/VelocityX");
    expectComplaint({"box.cgns", "'Velocity'", "VelocityY"});
    write({.cells = Cells::hexahedra});
    replace("/Base/box/Cells/Pressure", {63}, std::vector<double>(63));
    expectComplaint({"box.cgns", "'box'", "'Pressure' has 63 values", "64"}, ":box");
    write({.steps = 3});
    replace("/Base/BaseIterativeData/TimeValues", {3}, std::vector<double>{0, 2, 1});
    expectComplaint({"'/Base/BaseIterativeData/TimeValues'", "its time 2 is 1", "increase"});
    replace("/Base/BaseIterativeData/TimeValues", {3}, std::vector<double>{0, 1, 2});
    replace("/Base/box/ZoneIterativeData/FlowSolutionCenterPointers", "Nowhere");
    expectComplaint({"FlowSolutionCenterPointers'", "names 'Nowhere'"});
}

TEST_F(CgnsDamaged, LayersAroundAList)
{
    write({.rind = true, .onFaces = true});
    EXPECT_EQ(complaint(), "");
    const hid_t opened = H5Fopen(file_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    H5Ocopy(opened, "/Base/box/GridCoordinates/Rind", opened, "/Base/box/onFloor/Rind", H5P_DEFAULT, H5P_DEFAULT);
    H5Fclose(opened);
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
    replace("/Base/box/onFloor/Rind", {3}, Wholes{most, most, 2});  // In 64 bits their sum is 0.
    expectComplaint({"'/Base/box/onFloor/Pressure'", "9223372036854775807 layers around it"});
}

TEST_F(CgnsDamaged, Links)
{
    const std::string grid = folder_.file("grid.cgns");
    writeSampleCgns(grid);
    write({.grid = grid});
    EXPECT_EQ(complaint(), "");
    removeHdf5(grid, "/Base/box");
    expectComplaint({"box.cgns", "'/Base/box'", "leads to '/Base/box'", "not in grid.cgns"});
    std::filesystem::remove(grid);
    expectComplaint({"box.cgns", "'grid.cgns' leads nowhere"});
    write({.grid = file_});  // A link to itself.
    expectComplaint({"box.cgns"});
}

TEST_F(CgnsDamaged, HDF5InItsOldestFormGivesTheSame)
{
    for (const Cells cells : {Cells::structured, Cells::polyhedra}) {
        write({.cells = cells, .steps = 2});
        SceneDescription description;
        description.surface.spec = file_ + ":floor";
        description.field.vectors = "Velocity";
        description.shading.colorBy = "Pressure";
        const std::string sound = fingerprint(loadScene(description));
        const std::string old = folder_.file("old.cgns");
        copyInOldForm(file_, old);
        description.surface.spec = old + ":floor";
        EXPECT_EQ(fingerprint(loadScene(description)), sound);
    }
}

TEST_F(CgnsDamaged, EveryLengthOfAFileThatIsCutOffIsRefused)
{
    write({.cells = Cells::hexahedra});
    const std::string sound = readBytes(file_);
    for (std::size_t size = 0; size < sound.size(); size += 1 + sound.size() / 60) {
        writeBytes(file_, sound.substr(0, size));
        EXPECT_THROW(describeFile(file_), InputError) << size;
    }
}

}  // namespace
}  // namespace aeolic
