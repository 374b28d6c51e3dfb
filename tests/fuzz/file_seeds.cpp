#include "file_seeds.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLDataSetWriter.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <filesystem>
#include <set>
#include <stdexcept>

#include "data/vtk/testing/sample_vtkhdf.h"
#include "data/vtk/testing/sample_writers.h"
#include "description/file_kinds.h"
#include "odd_data.h"
#include "reader/cgns/testing/sample_cgns.h"
#include "reader/ensight/testing/sample_ensight.h"
#include "reader/exodus/testing/sample_exodus.h"
#include "reader/fluent/testing/sample_fluent.h"
#include "reader/hdf5/testing/sample_hdf5.h"
#include "reader/netcdf/testing/sample_netcdf.h"
#include "reader/openfoam/testing/sample_case.h"
#include "reader/tecplot/testing/sample_tecplot.h"

namespace aeolic::test {
namespace {

/// A hexahedron, two tetrahedra and a polyhedron.
vtkSmartPointer<vtkUnstructuredGrid> mixedCells()
{
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkNew<vtkPoints> points;
    for (int i = 0; i < 12; ++i) points->InsertNextPoint(i & 1, (i >> 1) & 1, i >> 2);
    grid->SetPoints(points);
    const vtkIdType hexahedron[] = {0, 1, 3, 2, 4, 5, 7, 6}, first[] = {4, 5, 6, 8}, second[] = {5, 6, 8, 9};
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, hexahedron);
    grid->InsertNextCell(VTK_TETRA, 4, first);
    grid->InsertNextCell(VTK_TETRA, 4, second);
    const vtkIdType corners[] = {6, 7, 10, 11, 9},
                    faces[] = {3, 6, 7, 9, 3, 7, 11, 9, 3, 11, 10, 9, 3, 10, 6, 9, 4, 6, 7, 11, 10};
    grid->InsertNextCell(VTK_POLYHEDRON, 5, corners, 5, faces);
    auto vectors = newArray(false, "U", 3, 12);
    for (int i = 0; i < 12; ++i) vectors->SetTuple3(i, 1, 0.1 * i, 0.2);
    grid->GetPointData()->AddArray(vectors);
    return grid;
}

/// What the sample writers have no word for: values within the elements, in base64, and other compressors.
void writeXml(const std::string& path, vtkDataObject& data, bool inlined, bool compressed, bool base64)
{
    vtkNew<vtkXMLDataSetWriter> writer;
    writer->SetInputData(&data);
    writer->SetFileName(path.c_str());
    inlined ? writer->SetDataModeToBinary() : writer->SetDataModeToAppended();
    writer->SetEncodeAppendedData(base64);
    if (!compressed) writer->SetCompressorTypeToNone();
    writer->SetBlockSize(1024);
    writer->Write();
}

void writeSurfaces(const std::string& folder)
{
    const Encoding encodings[] = {Encoding::raw, Encoding::zlib, Encoding::ascii};
    int number = 0;
    for (const Encoding encoding : encodings)
        for (const auto cells : {SheetSample::Cells::quads, SheetSample::Cells::strips}) {
            SheetSample sheet;
            sheet.encoding = encoding;
            sheet.cells = cells;
            sheet.normals = true;
            const std::string name = folder + "/sheet" + std::to_string(number++);
            for (const char* ending : {".vtp", ".pvtp", ".vtk"}) writeSheetFile(name + ending, sheet);
            if (cells == SheetSample::Cells::strips) continue;
            sheet.cells = SheetSample::Cells::triangles;
            for (const char* ending : {".stl", ".ply"}) writeSheetFile(name + ending, sheet);
        }
    const auto odd = oddPolygons(false);
    writeXml(folder + "/odd0.vtp", *odd, true, false, true);
    writeXml(folder + "/odd1.vtp", *odd, false, false, false);
    for (const bool binary : {false, true}) {
        vtkNew<vtkPolyDataWriter> legacy;
        legacy->SetInputData(oddPolygons(true));
        legacy->SetFileName((folder + "/odd" + (binary ? "-binary" : "") + ".vtk").c_str());
        binary ? legacy->SetFileTypeToBinary() : legacy->SetFileTypeToASCII();
        legacy->Write();
    }
    writeSheetFile(folder + "/sheets.vtm");
    writeBytes(folder + "/levels.vthb", R"(<VTKFile type="vtkOverlappingAMR" version="1.1"><vtkOverlappingAMR>
<Block level="0"><DataSet index="0" amr_box="0 8 0 7 0 6" file="grid0.vti"/></Block>
<Block level="1"><DataSet index="0" amr_box="0 8 0 7 0 6" file="grid1.vti"/></Block></vtkOverlappingAMR></VTKFile>)");
    writeBytes(folder + "/nested.vtmb", R"(<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>
<Block index="0" name="outer"><DataSet index="0" name="inner" file="sheets.vtm"/><DataSet index="1"/></Block>
<Piece index="1" name="pieces"><DataSet index="0" file="sheet0.vtp"/><DataSet index="1" file="sheet1.vtp"/></Piece>
<DataSet index="2" name="cells" file="grid0.vtu"/></vtkMultiBlockDataSet></VTKFile>)");
    writeSheetFile(folder + "/sheet.obj");
    writeBytes(
        folder + "/full.obj",
        "# a comment\nmtllib m.mtl\no name\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n"
        "vn 0 1 0\ng part\nusemtl red\ns off\nf 1/1/1 2/2/1 3/3/1\nf 1//1 3//2 4//2\nf -4 -2 -1\nf 1/1 2/2 3/3 "
        "\\\n4/1\n"
        "l 1 2 3\np 1\n");
}

void writeGrids(const std::string& folder)
{
    int number = 0;
    for (const Encoding encoding : {Encoding::raw, Encoding::zlib, Encoding::ascii}) {
        GridSample grid;
        grid.dims = {5, 4, 3};
        grid.encoding = encoding;
        grid.stretch = 0.1;
        grid.maskedPoints = {3};
        const std::string name = folder + "/grid" + std::to_string(number++);
        for (const char* ending : {".vti", ".vtr", ".vts", ".vtu", ".pvti", ".pvtr", ".pvts", ".pvtu"})
            writeGridFile(name + ending, grid);
        for (grid.legacyKind = 0; grid.legacyKind < 4; ++grid.legacyKind)
            writeGridFile(name + "-" + std::to_string(grid.legacyKind) + ".vtk", grid);
        grid.onCells = true;
        writeGridFile(name + "-cells.vti", grid);
    }
    writeGridSteps(folder + "/steps.vti", {GridSample{}, GridSample{}});
    const auto mixed = mixedCells();
    writeXml(folder + "/mixed0.vtu", *mixed, true, false, true);
    writeXml(folder + "/mixed1.vtu", *mixed, true, true, true);
    writeXml(folder + "/mixed2.vtu", *mixed, false, true, true);
    writeXml(folder + "/mixed3.vtu", *mixed, false, false, false);
    const auto odd = oddCells();
    writeXml(folder + "/oddcells0.vtu", *odd, true, false, true);
    writeXml(folder + "/oddcells1.vtu", *odd, false, false, false);
    vtkNew<vtkUnstructuredGridWriter> legacy;
    for (const bool old : {false, true})
        for (const bool binary : {false, true}) {
            legacy->SetInputData(mixed);
            legacy->SetFileName((folder + "/mixed" + (old ? "-old" : "") + (binary ? "-binary" : "") + ".vtk").c_str());
            if (old) legacy->SetFileVersion(42);
            binary ? legacy->SetFileTypeToBinary() : legacy->SetFileTypeToASCII();
            legacy->Write();
        }
}

void writeNrrd(const std::string& folder)
{
    const std::string start = "NRRD0004\n# a comment\ntype: float\ndimension: 4\nsizes: 3 4 4 4\n",
                      kinds = "kinds: vector domain domain domain\n",
                      end = "spacings: nan 0.1 0.1 0.1\nspace origin: (0,0,0)\nendian: little\n";
    std::string values;
    for (int i = 0; i < 3 * 64; ++i) {
        const float value = 0.01F * float(i);
        values.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    writeBytes(folder + "/values.raw", values);
    writeBytes(folder + "/raw.nhdr", start + kinds + end + "encoding: raw\ndata file: values.raw\n");
    writeBytes(folder + "/blank.nhdr", start + kinds + end + "encoding: raw\ndata file: values.raw\n\n");
    writeBytes(folder + "/list.nhdr", start + kinds + end + "encoding: raw\ndata file: LIST\nvalues.raw\n");
    writeBytes(folder + "/within.nrrd", start + kinds + end + "encoding: raw\n\n" + values);
}

void writeCases(const std::string& folder)
{
    const SampleCase cases[] = {{},
                                {.binary = true},
                                {.gzip = true, .times = {"1"}, .region = "air"},
                                {.binary = true, .gzip = true, .longLabels = true, .processors = 2},
                                {.binary = true, .bigEndian = true, .processors = 2, .collated = 2}};
    int number = 0;
    for (const SampleCase& sample : cases) {
        const std::string name = folder + "/case" + std::to_string(number++);
        writeSampleCase(name, sample);
        writeBytes(name + "/case.foam", "");
    }
}

void writeEnSight(const std::string& folder)
{
    const SampleEnSight samples[] = {
        {.mixed = true, .gaps = true, .blocks = true},
        {{EnSightEncoding::binary, false}, true, true, true, true, true},
        {{EnSightEncoding::binary, true}, false, false, true, false, true},
        {{EnSightEncoding::fortran, false}, true, false, true, true, false},
    };
    int number = 0;
    for (const SampleEnSight& sample : samples) {
        const std::string name = folder + "/ensight" + std::to_string(number++);
        std::filesystem::create_directories(name);
        writeSampleEnSight(name, sample);
    }
    std::filesystem::create_directories(folder + "/ensight6");
    writeSampleEnSight6(folder + "/ensight6");
}

void writeNetcdfs(const std::string& folder)
{
    writeSampleNetcdf(folder + "/sea0.nc", NetcdfForm::classic);
    writeSampleNetcdf(folder + "/sea1.cdf", NetcdfForm::offsets64);
    writeSampleNetcdf(folder + "/sea2.nc4", NetcdfForm::netcdf4);
}

/// Each as the CGNS library writes it, and in HDF5's oldest form: there no checksum stops what is damaged.
void writeCgns(const std::string& folder)
{
    using Cells = SampleCgns::Cells;
    const SampleCgns samples[] = {
        {.doubles = false, .rind = true, .steps = 2, .secondBase = true},
        {.cells = Cells::hexahedra, .lists = true, .onFaces = true},
        {.cells = Cells::mixed, .parents = false, .faces = false, .byPoints = true},
        {.cells = Cells::polyhedra, .doubles = false, .steps = 2},
    };
    int number = 0;
    for (const SampleCgns& sample : samples) {
        const std::string name = folder + "/zone" + std::to_string(number++);
        writeSampleCgns(name + ".cgns", sample);
        copyInOldForm(name + ".cgns", name + "-old.cgns");
    }
}

void writeExodus(const std::string& folder)
{
    using Form = SampleExodus::Form;
    writeSampleExodus(folder + "/blocks0.e", {.form = Form::classic, .doubles = false, .shells = true});
    writeSampleExodus(folder + "/blocks1.ex2", {.moves = true});
    writeSampleExodus(folder + "/blocks2.exo", {.form = Form::data64, .polyhedra = true});
    writeSampleExodus(folder + "/blocks3.exii", {.form = Form::netcdf4, .names = false});
    writeExodusElements(folder + "/elements.e");
}

void writeTecplot(const std::string& folder)
{
    writeSampleTecplot(folder + "/zones0.tec");
    writeSampleTecplot(folder + "/zones1.tec", {.ordered = false, .block = false, .steps = 2});
    writeSampleTecplot(folder + "/zones2.dat", {.ordered = false, .repeats = true});
    writeSampleTecplot(folder + "/zones3.dat", {.shared = true});
}

void writeFluent(const std::string& folder)
{
    using Form = SampleFluent::Form;
    writeSampleFluent(folder + "/fluent0.cas");
    writeSampleFluent(folder + "/fluent1.cas", {.form = Form::floats, .flat = true});
    writeSampleFluent(folder + "/fluent2.cas", {.form = Form::doubles, .shapes = true});
    writeSampleFluent(folder + "/fluent3.msh", {.data = false, .names = false});
    writeSampleFluent(folder + "/fluent4.msh", {.form = Form::doubles, .data = false});
}

template <class Reader>
vtkSmartPointer<vtkDataSet> readBack(const std::string& path)
{
    vtkNew<Reader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader->GetOutput();
}

/// What the other seeds hold.
void writeVtkHdfs(const std::string& folder)
{
    const auto image = readBack<vtkXMLImageDataReader>(folder + "/grid0.vti");
    const auto cells = readBack<vtkXMLUnstructuredGridReader>(folder + "/grid0.vtu");
    const auto quads = readBack<vtkXMLPolyDataReader>(folder + "/sheet0.vtp"),
               strips = readBack<vtkXMLPolyDataReader>(folder + "/sheet1.vtp");
    writeVtkHdf(folder + "/image0.vtkhdf", {image});
    writeVtkHdf(folder + "/image1.vtkhdf", {image, image}, {.newest = true, .packed = true, .steps = true});
    writeVtkHdf(folder + "/cells0.vtkhdf", {cells}, {.packed = true});
    writeVtkHdf(folder + "/cells1.hdf", {cells, cells}, {.steps = true, .still = true});
    writeVtkHdf(folder + "/sheet0.vtkhdf", {quads, quads});
    writeVtkHdf(folder + "/sheet1.hdf", {strips, strips}, {.newest = true, .steps = true});
    writeVtkHdfBlocks(folder + "/sheet2.vtkhdf", {quads, strips, cells});
}

void writeColorMaps(const std::string& folder)
{
    writeBytes(folder + "/map.json",
               R"([{"ColorSpace": "Diverging", "Name": "a map", "NanColor": [1, 1, 0], "BelowRangeColor": [0, 0, 1],
"UseBelowRangeColor": 1, "RGBPoints": [0, 0.23, 0.3, 0.75, 0.5, 0.87, 0.87, 0.87, 1, 0.71, 0.02, 0.15]}])");
    writeBytes(folder + "/map.xml",
               R"(<ColorMaps><ColorMap name="a map" space="Lab" indexedLookup="false">
<Point x="-1" o="0" r="0" g="0" b="0"/><Point x="1" o="0.5" r="1" g="0.4" b="0"/><NaN r="0" g="1" b="0"/>
</ColorMap></ColorMaps>)");
    writeBytes(folder + "/bytes.csv", "scalar,R,G,B\n0,0,0,40\n0.5,128,64,0\n1,255,255,200\n");
    writeBytes(folder + "/parts.csv", "# a comment\n0 0 0.2\n0.5 0.25 0\n1 1 0.8\n");
}

/// A format without a file would not be tried.
void requireAllEndings(const std::string& folder)
{
    std::set<const FileKind*> found;
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder))
        found.insert(fileKindOf(file.path().string()));
    for (const FileKind& kind : fileKinds)
        if (!found.contains(&kind)) throw std::runtime_error(std::string("no seed ends in ") + kind.endings);
}

}  // namespace

void writeFileSeeds(const std::string& folder)
{
    writeSurfaces(folder);
    writeGrids(folder);
    writeNrrd(folder);
    writeCases(folder);
    writeEnSight(folder);
    writeCgns(folder);
    writeExodus(folder);
    writeNetcdfs(folder);
    writeVtkHdfs(folder);
    writeTecplot(folder);
    writeFluent(folder);
    writeColorMaps(folder);
    writeBytes(folder + "/steps.pvd",
               "<VTKFile type=\"Collection\" version=\"0.1\"><Collection>\n<DataSet timestep=\"0\" part=\"0\" "
               "file=\"sheet0.vtp\"/>\n"
               "<DataSet timestep=\"1\" file=\"sheet2.vtp\"/></Collection></VTKFile>\n");
    writeBytes(
        folder + "/steps.vti.series",
        R"({"file-series-version": "1.0", "files": [{"name": "grid0.vti", "time": 0}, {"name": "grid1.vti", "time": 1.5}]})");
    requireAllEndings(folder);
}

}  // namespace aeolic::test
