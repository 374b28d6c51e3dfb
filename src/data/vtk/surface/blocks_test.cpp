#include "data/vtk/surface/blocks.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataSet.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkXMLMultiBlockDataWriter.h>

#include "aeolic/error.h"
#include "data/load/file_info.h"
#include "data/vtk/sample_files.h"
#include "data/vtk/surface/surface_file.h"

namespace aeolic {
namespace {

/// A square of two triangles.
vtkSmartPointer<vtkPolyData> square(double x)
{
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    const vtkIdType corners[] = {0, 1, 2, 3};
    points->InsertNextPoint(x, 0, 0);
    points->InsertNextPoint(x + 1, 0, 0);
    points->InsertNextPoint(x + 1, 1, 0);
    points->InsertNextPoint(x, 1, 0);
    cells->InsertNextCell(4, corners);
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    return data;
}

/// "car" with the squares "left" and "right", beside "box", which has cells.
void writeBlocks(const std::string& path)
{
    vtkNew<vtkMultiBlockDataSet> all, car;
    const auto name = [](vtkMultiBlockDataSet& blocks, unsigned number, const char* text) {
        blocks.GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), text);
    };
    for (const unsigned side : {0u, 1u}) {
        car->SetBlock(side, square(3.0 * side));
        name(*car, side, side == 0 ? "left" : "right");
    }
    vtkNew<vtkImageData> box;
    box->SetDimensions(3, 3, 3);
    all->SetBlock(0, car);
    name(*all, 0, "car");
    all->SetBlock(1, box);
    name(*all, 1, "box");
    vtkNew<vtkXMLMultiBlockDataWriter> writer;
    writer->SetFileName(path.c_str());
    writer->SetInputData(all);
    writer->Write();
}

std::size_t triangles(const std::string& path, const std::vector<std::string>& parts)
{
    SurfaceArrays arrays;
    arrays.parts = parts;
    return readSurfaceFile(path, arrays, {}).mesh.triangles.size();
}

TEST(Blocks, AreChosenByNameInTheirTree)
{
    const test::TempFolder folder;
    const std::string path = folder.file("a.vtm");
    writeBlocks(path);
    EXPECT_EQ(triangles(path, {"car/left"}), 2u);
    EXPECT_EQ(triangles(path, {"left"}), 2u);
    EXPECT_EQ(triangles(path, {"car"}), 4u);
    EXPECT_EQ(triangles(path, {}), 4u) << "the box has no polygons";
    EXPECT_EQ(triangles(path, {"box"}), 48u) << "its outer surface: 6 sides of 4 squares";
    EXPECT_EQ(triangles(path, {"*"}), 4u + 48);
    try {
        triangles(path, {"lef"});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("car/left, car/right, box"), std::string::npos) << error.what();
    }
    EXPECT_NE(describeFile(path).find("car/right"), std::string::npos);
}

TEST(Blocks, AFileOfOnePieceHasNoParts)
{
    const test::TempFolder folder;
    test::writeSheetFile(folder.file("a.vtp"));
    EXPECT_THROW(triangles(folder.file("a.vtp"), {"left"}), InputError);
}

}  // namespace
}  // namespace aeolic
