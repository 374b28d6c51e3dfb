#include <fmt/format.h>
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include "aeolic/error.h"
#include "data/load/file_info.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "data/vtk/testing/sample_writers.h"

/// Uniform grids in levels, of which finer ones lie over coarser ones.

namespace aeolic {
namespace {

using namespace test;

/// A box of cells from `origin` with the flow (1, 0.5, 0.2); p is the level.
void writeBlock(const std::string& path, const std::array<int, 3>& cells, const glm::dvec3& origin, double width,
                float level)
{
    vtkNew<vtkImageData> grid;
    grid->SetDimensions(cells[0] + 1, cells[1] + 1, cells[2] + 1);
    grid->SetOrigin(origin.x, origin.y, origin.z);
    grid->SetSpacing(width, width, width);
    vtkNew<vtkFloatArray> vectors, levels;
    vectors->SetName("U");
    vectors->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i) vectors->InsertNextTuple3(1, 0.5, 0.2);
    levels->SetName("p");
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i) levels->InsertNextValue(level);
    grid->GetCellData()->AddArray(vectors);
    grid->GetCellData()->AddArray(levels);
    writeDataSet(path, *grid, Encoding::raw);
}

constexpr double kRim = 0.05;  // A slice ends a little before its data.

class Amr : public testing::Test {
protected:
    TempFolder folder_;

    /// 4 x 4 x 4 cells of width 1, of which 2 x 2 x 2 in the middle are refined.
    std::string write(const char* type = "vtkOverlappingAMR")
    {
        writeBlock(folder_.file("coarse.vti"), {4, 4, 4}, {0, 0, 0}, 1, 0);
        writeBlock(folder_.file("fine.vti"), {4, 4, 4}, {1, 1, 1}, 0.5, 1);
        writeBytes(
            folder_.file("a.vthb"),
            fmt::format("<VTKFile type=\"{0}\" version=\"1.1\"><{0} origin=\"0 0 0\" grid_description=\"XYZ\">"
                        "<Block level=\"0\" spacing=\"1 1 1\">"
                        "<DataSet index=\"0\" amr_box=\"0 3 0 3 0 3\" file=\"coarse.vti\"/></Block>"
                        "<Block level=\"1\" spacing=\"0.5 0.5 0.5\">"
                        "<DataSet index=\"0\" amr_box=\"2 5 2 5 2 5\" file=\"fine.vti\"/></Block></{0}></VTKFile>",
                        type));
        return folder_.file("a.vthb");
    }
    static Scene sliceOf(const std::string& field)
    {
        SceneDescription description;
        description.surface.spec = "slice:2,2,2.2:0,0,1";
        description.field.spec = field;
        description.field.vectors = "U";
        description.shading.colorBy = "p";
        return loadScene(description);
    }
    static double areaOf(const SurfaceMesh& mesh)
    {
        double area = 0;
        for (const auto& t : mesh.triangles)
            area += 0.5 * double(glm::length(glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                                                        mesh.positions[t[2]] - mesh.positions[t[0]])));
        return area;
    }
};

TEST_F(Amr, FinerLevelsAreDrawnInThePlaceOfCoarserOnes)
{
    const Scene whole = sliceOf(write());
    EXPECT_NEAR(areaOf(whole.surface), 16, kRim) << "nothing lies there twice";
    EXPECT_EQ(whole.scalarRange, (std::array<double, 2>{0, 1}));
    EXPECT_NEAR(areaOf(sliceOf(folder_.file("a.vthb") + ":level1/0").surface), 4, kRim);
    const Scene coarse = sliceOf(folder_.file("a.vthb") + ":level0/*");
    EXPECT_NEAR(areaOf(coarse.surface), 16, kRim) << "what finer levels hide shows where they are not drawn";
    EXPECT_EQ(coarse.scalarRange, (std::array<double, 2>{0, 0}));
}

TEST_F(Amr, InfoTellsTheLevels)
{
    const auto withoutFirstLine = [](const std::string& told) { return told.substr(told.find('\n')); };
    const std::string text = describeFile(write());
    for (const char* word : {"level0/0", "level1/0", "an AMR data set"})
        EXPECT_NE(text.find(word), std::string::npos) << word << " is not in:\n" << text;
    for (const char* type : {"vtkHierarchicalBoxDataSet", "vtkNonOverlappingAMR"})
        EXPECT_EQ(withoutFirstLine(describeFile(write(type))), withoutFirstLine(text)) << type;
    EXPECT_THROW(describeFile(write("vtkTable")), InputError);
}

}  // namespace
}  // namespace aeolic
