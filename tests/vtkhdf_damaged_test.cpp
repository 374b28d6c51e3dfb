#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <string>
#include <vector>

#include "aeolic/error.h"
#include "data/load/file_info.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "data/vtk/testing/sample_vtkhdf.h"
#include "part_formats_testing.h"
#include "reader/hdf5/testing/sample_hdf5.h"

namespace aeolic {
namespace {

using namespace test;
using namespace testkit;
using Wholes = std::vector<std::int64_t>;

template <class Reader>
vtkSmartPointer<vtkDataSet> readXml(const std::string& path)
{
    vtkNew<Reader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader->GetOutput();
}

class VtkHdfDamaged : public testing::Test {
protected:
    void SetUp() override
    {
        writeGridFile(folder_.file("a.vti"));
        writeGridFile(folder_.file("a.vtu"));
        writeSheetFile(folder_.file("a.vtp"));
        image_ = readXml<vtkXMLImageDataReader>(folder_.file("a.vti"));
        cells_ = readXml<vtkXMLUnstructuredGridReader>(folder_.file("a.vtu"));
        sheet_ = readXml<vtkXMLPolyDataReader>(folder_.file("a.vtp"));
    }

    void writeImage() const { writeVtkHdf(file_, {image_}); }
    void writeCells(const SampleVtkHdf& sample = {}) const { writeVtkHdf(file_, {cells_, cells_}, sample); }
    void writeSheet() const { writeVtkHdf(file_, {sheet_}); }

    /// What is refused is one line; empty where nothing is.
    std::string complaint(bool surface, const char* vectors = nullptr) const
    {
        SceneDescription description;
        description.surface.spec = surface ? file_ : "boundary";
        description.field.spec = surface ? "" : file_;
        description.field.vectors = vectors ? vectors : surface ? "tau" : "U";
        return complaintOf([&] { loadScene(description); });
    }

    void expectComplaint(const std::vector<std::string>& texts, bool surface = false) const
    {
        expectSays(complaint(surface), texts);
    }

    template <class Number>
    void replace(const std::string& name, const std::vector<std::uint64_t>& shape,
                 const std::vector<Number>& values) const
    {
        replaceHdf5(file_, "/VTKHDF/" + name, shape, values);
    }

    TempFolder folder_;
    std::string file_ = folder_.file("a.vtkhdf");
    vtkSmartPointer<vtkDataSet> image_, cells_, sheet_;
};

TEST_F(VtkHdfDamaged, OtherFiles)
{
    writeBytes(file_, "no HDF5 at all");
    expectComplaint({"a.vtkhdf", "does not begin like an HDF5 file"});
    {
        Hdf5Writer writer(file_);
    }
    expectComplaint({"a.vtkhdf", "not one of VTK", "VTKHDF"});
    const auto write = [&](const char* type, std::int64_t version) {
        Hdf5Writer writer(file_);
        writer.group("VTKHDF");
        writer.text("VTKHDF", "Type", type);
        writer.attribute<std::int64_t>("VTKHDF", "Version", {version, 0});
    };
    write("HyperTreeGrid", 2);
    expectComplaint({"a.vtkhdf", "of the type 'HyperTreeGrid'", "PolyData"});
    write("PolyData", 3);
    expectComplaint({"a.vtkhdf", "its version is 3.0", "1 or 2"});
    write("PartitionedDataSetCollection", 2);
    expectComplaint({"a.vtkhdf", "no blocks"});
    write("PolyData", 2);
    expectComplaint({"a.vtkhdf"}, true);
    writeSheet();
    EXPECT_NE(complaint(false, "tau").find("it holds polygons; expected a grid to sample"), std::string::npos);
    writeImage();
    EXPECT_NE(complaint(true, "U").find("it holds image data, which is a field, not a surface; expected polygons"),
              std::string::npos);
}

TEST_F(VtkHdfDamaged, Images)
{
    writeImage();
    replace("PointData/U", {7, 8, 9}, std::vector<float>(7 * 8 * 9));
    expectComplaint({"a.vtkhdf", "1 component", "3 for vectors"});
    replace("PointData/U", {7, 8, 8, 3}, std::vector<float>(7 * 8 * 8 * 3));
    expectComplaint({"'/VTKHDF/PointData/U'", "7 x 8 x 8 x 3 numbers", "7 x 8 x 9"});
    const auto extent = [&](const Wholes& numbers) {
        Hdf5Writer writer(file_);
        writer.group("VTKHDF");
        writer.text("VTKHDF", "Type", "ImageData");
        writer.attribute<std::int64_t>("VTKHDF", "Version", {1, 0});
        writer.attribute<std::int64_t>("VTKHDF", "WholeExtent", numbers);
        writer.data<float>("VTKHDF/PointData/U", {2, 2, 2, 3}, std::vector<float>(24));
    };
    extent({0, 1, 0, 1, 0, 1});
    EXPECT_EQ(complaint(false), "");
    extent({0, 1, 0, 1, 0});
    expectComplaint({"'/VTKHDF'", "no WholeExtent"});
    extent({0, 1, 0, 1, 1, 0});
    expectComplaint({"'/VTKHDF'", "its WholeExtent is 0 1 0 1 1 0"});
    extent({0, 1, 0, 1, 0, std::int64_t{1} << 62});
    expectComplaint({"'/VTKHDF'", "its WholeExtent is"});
    extent({0, 2147483646, 0, 2147483646, 0, 1});
    expectComplaint({"'/VTKHDF/PointData/U'", "2 x 2147483647 x 2147483647"});
    extent({0, 100000, 0, 1000, 0, 1});
    expectComplaint({"'/VTKHDF/PointData/U'", "2 x 2 x 2 x 3 numbers", "2 x 1001 x 100001"});
}

TEST_F(VtkHdfDamaged, Cells)
{
    writeCells();
    const std::uint64_t cells = std::uint64_t(cells_->GetNumberOfCells()),
                        points = std::uint64_t(cells_->GetNumberOfPoints());
    replace("NumberOfPoints", {2}, Wholes{std::int64_t(points), -1});
    expectComplaint({"'/VTKHDF/NumberOfPoints'", "the count -1"});
    replace("NumberOfPoints", {2}, Wholes{std::int64_t(points), std::int64_t{1} << 60});
    expectComplaint({"'/VTKHDF/Points'", "1152921504606847480 x 3 from 0 on"});
    replace("NumberOfPoints", {2}, Wholes{std::int64_t(points), 2});
    expectComplaint({"'/VTKHDF'", "the corner", "its piece"});
    replace("NumberOfPoints", {3}, Wholes{1, 1, 1});
    expectComplaint({"'/VTKHDF/NumberOfCells'", "2 numbers", "3 from 0 on"});
    writeCells();
    replace("NumberOfCells", {2}, Wholes{std::int64_t(cells), std::int64_t(cells) + 1});
    expectComplaint({"a.vtkhdf"});
    writeCells();
    replace("Connectivity", {16 * cells}, Wholes(16 * cells, -1));
    expectComplaint({"'/VTKHDF'", "the corner -1"});
    writeCells();
    replace("Offsets", {2 * cells + 2}, Wholes(2 * cells + 2, 8));
    expectComplaint({"'/VTKHDF/Offsets'", "from 8 to 8", "0 to"});
    writeCells();
    replace("Types", {2 * cells}, std::vector<std::uint8_t>(2 * cells, 42));
    expectComplaint({"'/VTKHDF/Types'", "polyhedra"});
    replace("Types", {2 * cells}, std::vector<std::uint8_t>(2 * cells, 12));
    expectComplaint({"a.vtkhdf", "type 12 has 4 corners", "8"});
    replace("Types", {2 * cells}, std::vector<std::uint8_t>(2 * cells, 200));
    expectComplaint({"a.vtkhdf", "the type 200"});
    replace("Types", {3}, std::vector<std::uint8_t>(3, 12));
    expectComplaint({"'/VTKHDF/Types'", "3 numbers", "one for each cell"});
    writeCells();
    replace("Points", {2 * points, 2}, std::vector<float>(4 * points));
    expectComplaint({"'/VTKHDF/Points'", "x 3"});
    writeCells();
    replace("PointData/U", {7, 3}, std::vector<float>(21));
    expectComplaint({"'/VTKHDF/PointData/U'", "7 values", "one for each of the points"});
    writeCells();
    removeHdf5(file_, "/VTKHDF/Connectivity");
    expectComplaint({"'/VTKHDF'", "no 'Connectivity'"});
}

TEST_F(VtkHdfDamaged, Polygons)
{
    writeSheet();
    replace("Polygons/Connectivity", {64}, Wholes(64, 25));
    expectComplaint({"'/VTKHDF/Polygons'", "the corner 25", "0 to 24"}, true);
    writeSheet();
    replace("Polygons/Offsets", {17}, Wholes(17, 0));
    expectComplaint({"'/VTKHDF/Polygons/Offsets'", "from 0 to 0", "0 to 64"}, true);
    writeSheet();
    replace("Polygons/NumberOfCells", {1}, Wholes{17});
    expectComplaint({"'/VTKHDF/Polygons'", "17 offsets", "18"}, true);
    writeSheet();
    removeHdf5(file_, "/VTKHDF/Polygons");
    expectComplaint({"a.vtkhdf"}, true);
}

/// All pieces but the first are empty. Each costs a few bytes of the file, and must cost no more than that to read.
TEST_F(VtkHdfDamaged, HundredsOfThousandsOfPieces)
{
    constexpr std::uint64_t pieces = 300000;
    const auto first = [&](const std::string& name, std::int64_t value) {
        Wholes counts(pieces);
        counts[0] = value;
        replace(name, {pieces}, counts);
    };
    const auto many = [&](const std::string& group, vtkDataSet& set, std::int64_t corners) {
        first("NumberOfPoints", set.GetNumberOfPoints());
        first(group + "NumberOfCells", set.GetNumberOfCells());
        first(group + "NumberOfConnectivityIds", corners * set.GetNumberOfCells());
        Wholes offsets(pieces + std::uint64_t(set.GetNumberOfCells()));
        for (vtkIdType i = 0; i <= set.GetNumberOfCells(); ++i) offsets[std::size_t(i)] = corners * i;
        replace(group + "Offsets", {offsets.size()}, offsets);
    };
    writeSheet();
    for (const char* other : {"Vertices", "Lines", "Strips"}) removeHdf5(file_, std::string("/VTKHDF/") + other);
    many("Polygons/", *sheet_, 4);
    EXPECT_EQ(complaint(true), "");
    writeVtkHdf(file_, {cells_});
    many("", *cells_, 4);
    EXPECT_EQ(complaint(false), "");
}

TEST_F(VtkHdfDamaged, Steps)
{
    const auto write = [&] { writeCells({.steps = true}); };
    write();
    replace("Steps/Values", {2}, std::vector<double>{1, 1});
    expectComplaint({"'/VTKHDF/Steps'", "its time 1 is 1", "increase"});
    replace("Steps/Values", {0}, std::vector<double>{});
    expectComplaint({"'/VTKHDF/Steps'", "no times"});
    write();
    replace("Steps/PartOffsets", {2}, Wholes{7, 7});
    expectComplaint({"'/VTKHDF/Steps'", "begin at 7", "2 at most"});
    write();
    replace("Steps/NumberOfParts", {2}, Wholes{3, 3});
    expectComplaint({"'/VTKHDF/Steps'", "3 pieces", "2 in all"});
    write();
    replace("Steps/PointOffsets", {2}, Wholes{-5, 0});
    expectComplaint({"'/VTKHDF/Steps/PointOffsets'", "the number -5"});
    replace("Steps/PointOffsets", {2}, Wholes{1000000, 0});
    expectComplaint({"'/VTKHDF/Points'", "from 1000000 on"});
    write();
    replace("Steps/CellOffsets", {0}, Wholes{});
    expectComplaint({"'/VTKHDF/Steps/CellOffsets'", "2 times"});
    write();
    replace("Steps/PointDataOffsets/U", {2}, Wholes{100000, 0});
    expectComplaint({"'/VTKHDF/PointData/U'", "from 100000 on"});
}

TEST_F(VtkHdfDamaged, EveryLengthOfAFileThatIsCutOffIsRefused)
{
    for (const bool newest : {false, true}) {
        writeCells({.newest = newest, .packed = true});
        const std::string sound = readBytes(file_);
        for (std::size_t size = 0; size < sound.size(); size += 1 + sound.size() / 60) {
            writeBytes(file_, sound.substr(0, size));
            EXPECT_THROW(describeFile(file_), InputError) << size;
        }
    }
}

}  // namespace
}  // namespace aeolic
