#include <gtest/gtest.h>
#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkHDFReader.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLMultiBlockDataWriter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <string>
#include <vector>

#include "aeolic/error.h"
#include "data/fingerprint.h"
#include "data/load/file_info.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "data/vtk/testing/sample_vtkhdf.h"
#include "reader/hdf5/testing/sample_hdf5.h"

/// VTKHDF files that are sound, beside VTK's XML files of the same data. Damaged ones: vtkhdf_damaged_test.cpp.
namespace aeolic {
namespace {

using namespace test;
using Sets = std::vector<vtkSmartPointer<vtkDataSet>>;

GridSample gridSample(bool doubles, bool onCells = false, double stretch = 0, double scale = 1)
{
    GridSample sample;
    sample.doubles = doubles;
    sample.onCells = onCells;
    sample.stretch = stretch;
    sample.scale = scale;
    return sample;
}

template <class Reader>
vtkSmartPointer<vtkDataSet> readXml(const std::string& path)
{
    vtkNew<Reader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader->GetOutput();
}

/// The sample sheets of strips, lines and vertices have no values on their cells.
vtkSmartPointer<vtkDataSet> withCells(vtkSmartPointer<vtkDataSet> set, double first = 0)
{
    vtkNew<vtkFloatArray> vectors, numbers;
    vectors->SetName("cellTau");
    vectors->SetNumberOfComponents(3);
    numbers->SetName("cellQ");
    for (vtkIdType i = 0; i < set->GetNumberOfCells(); ++i) {
        vectors->InsertNextTuple3(1, 0.01 * (first + double(i)), 0);
        numbers->InsertNextValue(float(first + double(i)));
    }
    set->GetCellData()->AddArray(vectors);
    set->GetCellData()->AddArray(numbers);
    return set;
}

void writePolygons(const std::string& path, vtkDataSet& set)
{
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(&set);
    writer->SetFileName(path.c_str());
    writer->Write();
}

class VtkHdf : public testing::Test {
protected:
    vtkSmartPointer<vtkDataSet> grid(const char* ending, const GridSample& sample = {}) const
    {
        const std::string path = folder_.file(std::string("grid") + ending);
        writeGridFile(path, sample);
        return std::string(ending) == ".vti" ? readXml<vtkXMLImageDataReader>(path)
                                             : readXml<vtkXMLUnstructuredGridReader>(path);
    }

    vtkSmartPointer<vtkDataSet> sheet(const SheetSample& sample = {}) const
    {
        writeSheetFile(folder_.file("sheet.vtp"), sample);
        return readXml<vtkXMLPolyDataReader>(folder_.file("sheet.vtp"));
    }

    static SceneDescription describe(const std::string& surface, const std::string& field = "",
                                     const std::string& vectors = "", const std::string& colorBy = "")
    {
        SceneDescription description;
        description.surface.spec = surface;
        description.field.spec = field;
        description.field.vectors = vectors;
        description.shading.colorBy = colorBy;
        return description;
    }

    TempFolder folder_;
    std::string file_ = folder_.file("a.vtkhdf");
};

const SampleVtkHdf allForms[] = {{}, {.newest = true}, {.packed = true}, {.newest = true, .packed = true}};

TEST_F(VtkHdf, ImageData)
{
    for (const bool doubles : {false, true})
        for (const bool onCells : {false, true})
            for (const SampleVtkHdf& form : allForms) {
                GridSample sample = gridSample(doubles, onCells);
                sample.nanPoints = {5};
                sample.hiddenPoints = {6};
                const auto image = grid(".vti", sample);
                writeVtkHdf(file_, {image}, form);
                for (const char* surface : {"slice:0,0.5,1:0,0,1", "boundary"})
                    EXPECT_EQ(fingerprint(loadScene(describe(surface, file_, "U", "p"))),
                              fingerprint(loadScene(describe(surface, folder_.file("grid.vti"), "U", "p"))));
            }
}

TEST_F(VtkHdf, UnstructuredGrids)
{
    for (const bool doubles : {false, true})
        for (const bool onCells : {false, true})
            for (const SampleVtkHdf& form : allForms) {
                const auto cells = grid(".vtu", gridSample(doubles, onCells, 0.1));
                writeVtkHdf(file_, {cells}, form);
                for (const char* surface : {"slice:0,0.5,1:0,0,1", "boundary"})
                    EXPECT_EQ(fingerprint(loadScene(describe(surface, file_, "U", "p"))),
                              fingerprint(loadScene(describe(surface, folder_.file("grid.vtu"), "U", "p"))));
            }
}

TEST_F(VtkHdf, Polygons)
{
    for (const auto cells : {SheetSample::Cells::triangles, SheetSample::Cells::quads, SheetSample::Cells::strips})
        for (const bool normals : {false, true})
            for (const SampleVtkHdf& form : allForms) {
                SheetSample sample;
                sample.cells = cells;
                sample.normals = normals;
                const auto polygons = withCells(sheet(sample));
                writePolygons(folder_.file("sheet.vtp"), *polygons);
                writeVtkHdf(file_, {polygons}, form);
                for (const char* vectors : {"tau", "cellTau"})
                    for (const char* color : {"q", "cellQ"})
                        EXPECT_EQ(fingerprint(loadScene(describe(file_, "", vectors, color))),
                                  fingerprint(loadScene(describe(folder_.file("sheet.vtp"), "", vectors, color))));
            }
}

/// Lines and vertices count among the cells, whose values come in the order vertices, lines, polygons, strips.
TEST_F(VtkHdf, PolygonsAmongLinesAndVertices)
{
    vtkNew<vtkAppendPolyData> append;
    for (const auto cells : {SheetSample::Cells::lines, SheetSample::Cells::strips, SheetSample::Cells::vertices,
                             SheetSample::Cells::quads}) {
        SheetSample sample;
        sample.cells = cells;
        sample.shift = {double(cells), 0, 0};
        append->AddInputData(vtkPolyData::SafeDownCast(withCells(sheet(sample))));
    }
    append->Update();
    writePolygons(folder_.file("all.vtp"), *append->GetOutput());
    writeVtkHdf(file_, {vtkSmartPointer<vtkDataSet>(append->GetOutput())});
    EXPECT_EQ(fingerprint(loadScene(describe(file_, "", "cellTau", "cellQ"))),
              fingerprint(loadScene(describe(folder_.file("all.vtp"), "", "cellTau", "cellQ"))));
}

TEST_F(VtkHdf, PiecesAreOne)
{
    Sets sheets;
    for (int i = 0; i < 3; ++i) {
        SheetSample sample;
        sample.cells = i == 1 ? SheetSample::Cells::strips : SheetSample::Cells::quads;
        sample.shift = {double(i), 0, 0};
        sheets.push_back(withCells(sheet(sample), 100 * i));
    }
    vtkNew<vtkAppendPolyData> append;
    for (const auto& each : sheets) append->AddInputData(vtkPolyData::SafeDownCast(each));
    append->Update();
    writePolygons(folder_.file("all.vtp"), *append->GetOutput());
    writeVtkHdf(file_, sheets);
    for (const char* color : {"q", "cellQ"})
        EXPECT_EQ(fingerprint(loadScene(describe(file_, "", "cellTau", color))),
                  fingerprint(loadScene(describe(folder_.file("all.vtp"), "", "cellTau", color))));

    GridSample left, right;
    right.origin[0] += 2;
    writeVtkHdf(file_, {grid(".vtu", left), grid(".vtu", right)});
    const Scene scene = loadScene(describe("slice:0,0.5,1:0,0,1", file_, "U", "p"));
    EXPECT_NEAR(scene.surface.bounds().hi.x - scene.surface.bounds().lo.x, 4, 1e-5);
    for (std::size_t i = 0; i < scene.surface.positions.size(); ++i) {
        const glm::dvec3 p = glm::dvec3(scene.surface.positions[i]) + scene.surface.originWorld;
        EXPECT_NEAR(double(scene.surface.pointScalars[i]), sampleScalar(p.x, p.y, p.z), 1e-4);
    }
}

TEST_F(VtkHdf, StepsAreTimes)
{
    for (const bool offsets : {true, false})
        for (const bool still : {false, true}) {
            if (still && !offsets) continue;  // Then nothing says where a step's values begin.
            SampleVtkHdf form;
            form.steps = true;
            form.offsets = offsets;
            form.still = still;
            Sets sheets, cells, images;
            for (const double scale : {1.0, 3.0, 4.0}) {
                SheetSample sample;
                sample.scale = scale;
                sheets.push_back(sheet(sample));
                cells.push_back(grid(".vtu", gridSample(false, false, 0.1, scale)));
                images.push_back(grid(".vti", gridSample(false, false, 0, scale)));
            }
            const auto expectSteps = [&](const std::string& spec, const std::string& field, const char* vectors) {
                for (const double time : {0.0, 0.5, 1.0, 0.25}) {
                    SceneDescription description = describe(spec, field, vectors);
                    description.time.moment = time;
                    const Scene scene = loadScene(description);
                    const double scale = time == 0.25 ? 2 : time == 0 ? 1 : time == 0.5 ? 3 : 4;
                    if (scene.field) {
                        if (time == 0.25) continue;  // Between two steps it is that of the longer one.
                        EXPECT_NEAR(scene.field->maxMagnitude, 3.716517187 * scale, 1e-4);
                        continue;
                    }
                    ASSERT_FALSE(scene.surface.pointVectors.empty());
                    const glm::dvec3 p = glm::dvec3(scene.surface.positions[3]) + scene.surface.originWorld;
                    const double expected = std::string(vectors) == "cellTau" ? 2
                                            : field.empty()                   ? 1
                                                                              : sampleVector(p.x, p.y, p.z)[0];
                    EXPECT_NEAR(double(scene.surface.pointVectors[3].x), expected * scale, 1e-4) << time;
                }
            };
            writeVtkHdf(file_, sheets, form);
            expectSteps(file_, "", "tau");
            expectSteps(file_, "", "cellTau");
            writeVtkHdf(file_, cells, form);
            expectSteps("slice:0,0.5,1:0,0,1", file_, "U");
            writeVtkHdf(file_, images, form);
            expectSteps("boundary", file_, "U");
        }
}

TEST_F(VtkHdf, BlocksAreParts)
{
    SheetSample second;
    second.shift = {1, 0, 0.1};
    second.scale = 2;
    writeVtkHdfBlocks(file_, {sheet(), sheet(second), grid(".vtu")});
    writeSheetFile(folder_.file("one.vtp"));
    EXPECT_EQ(fingerprint(loadScene(describe(file_ + ":block0", "", "tau", "q"))),
              fingerprint(loadScene(describe(folder_.file("one.vtp"), "", "tau", "q"))));
    EXPECT_EQ(loadScene(describe(file_, "", "tau")).surface.triangles.size(), 2 * 2 * 16U);
    EXPECT_EQ(loadScene(describe(file_ + ":odd", "", "tau")).surface.triangles.size(), 2 * 16U);
    EXPECT_EQ(fingerprint(loadScene(describe("slice:0,0.5,1:0,0,1", file_, "U"))),
              fingerprint(loadScene(describe("slice:0,0.5,1:0,0,1", folder_.file("grid.vtu"), "U"))));
    EXPECT_THROW(loadScene(describe("slice:0,0.5,1:0,0,1", file_ + ":odd", "U")), InputError);
    const std::string told = describeFile(file_);
    for (const char* text :
         {"a VTKHDF file", "block0  polygons                 16  all, even", "block2  an unstructured grid"})
        EXPECT_NE(told.find(text), std::string::npos) << text << " is not in:\n" << told;
}

/// Version 1.0 knew two types, and files without the attribute.
TEST_F(VtkHdf, FilesThatDoNotSayTheirType)
{
    for (const char* ending : {".vti", ".vtu"}) {
        writeVtkHdf(file_, {grid(ending)});
        const std::string sound = fingerprint(loadScene(describe("slice:0,0.5,1:0,0,1", file_, "U", "p")));
        const hid_t opened = H5Fopen(file_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
        EXPECT_GE(H5Adelete_by_name(opened, "/VTKHDF", "Type", H5P_DEFAULT), 0);
        H5Fclose(opened);
        EXPECT_EQ(fingerprint(loadScene(describe("slice:0,0.5,1:0,0,1", file_, "U", "p"))), sound);
    }
}

/// As VTK 9.4 writes them: a block has the name of its link, and may stand in a file of its own.
TEST_F(VtkHdf, BlocksOfAMultiBlockDataSet)
{
    writeVtkHdf(folder_.file("part.vtkhdf"), {sheet()});
    {
        Hdf5Writer writer(file_);
        writer.group("/VTKHDF", true);
        writer.text("/VTKHDF", "Type", "MultiBlockDataSet");
        writer.attribute<std::int64_t>("/VTKHDF", "Version", {2, 2});
        H5Lcreate_external("part.vtkhdf", "/VTKHDF", writer.file(), "/VTKHDF/Block_1", H5P_DEFAULT, H5P_DEFAULT);
        writer.group("/VTKHDF/Assembly/hull", true);
        writer.softLink("/VTKHDF/Assembly/hull/keel", "/VTKHDF/Block_1");
    }
    writeSheetFile(folder_.file("one.vtp"));
    const std::string sound = fingerprint(loadScene(describe(folder_.file("one.vtp"), "", "tau", "q")));
    for (const char* part : {":keel", ":hull"})
        EXPECT_EQ(fingerprint(loadScene(describe(file_ + part, "", "tau", "q"))), sound) << part;
    std::filesystem::remove(folder_.file("part.vtkhdf"));
    EXPECT_THROW(loadScene(describe(file_, "", "tau", "q")), InputError);
}

/// The sample writer is not the only one that says so: VTK's own reader reads its files.
TEST_F(VtkHdf, VtksReaderReadsTheSame)
{
    const auto image = grid(".vti"), cells = grid(".vtu");
    for (const auto& [set, name] : {std::pair{image, "image.hdf"}, {cells, "cells.hdf"}}) {
        writeVtkHdf(folder_.file(name), {set});
        const auto read = readXml<vtkHDFReader>(folder_.file(name));
        ASSERT_TRUE(read);
        EXPECT_EQ(read->GetNumberOfPoints(), set->GetNumberOfPoints());
        EXPECT_EQ(read->GetNumberOfCells(), set->GetNumberOfCells());
        EXPECT_TRUE(read->GetPointData()->HasArray("U"));
        EXPECT_NE(describeFile(folder_.file(name)).find("U "), std::string::npos);
    }
}

TEST_F(VtkHdf, InfoNamesTypesAndTimes)
{
    writeVtkHdf(file_, {grid(".vti", gridSample(true)), grid(".vti", gridSample(true))}, {.steps = true});
    const std::string told = describeFile(file_);
    for (const char* text : {"image data", "dimensions  9 x 8 x 7", "time steps  2, from 0 to 0.5",
                             "U      points  double", "--surface slice:"})
        EXPECT_NE(told.find(text), std::string::npos) << text << " is not in:\n" << told;
}

}  // namespace
}  // namespace aeolic
