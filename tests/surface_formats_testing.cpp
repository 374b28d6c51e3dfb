#include "surface_formats_testing.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>
#include <vtkXMLMultiBlockDataWriter.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "data/vtk/testing/sample_vtkhdf.h"
#include "data/vtk/testing/sample_writers.h"
#include "reader/cgns/testing/sample_cgns.h"
#include "reader/ensight/testing/sample_ensight.h"
#include "reader/exodus/testing/sample_exodus.h"
#include "reader/tecplot/testing/sample_tecplot.h"

namespace aeolic::test {
namespace {

namespace fs = std::filesystem;

vtkSmartPointer<vtkPolyData> polyDataOf(const SampleSurface& surface)
{
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    if (surface.doubles) points->SetDataTypeToDouble();
    for (const glm::dvec3& p : surface.points) points->InsertNextPoint(p.x, p.y, p.z);
    vtkNew<vtkCellArray> cells;
    for (const auto& t : surface.triangles) {
        const vtkIdType corners[] = {t[0], t[1], t[2]};
        cells->InsertNextCell(3, corners);
    }
    data->SetPoints(points);
    data->SetPolys(cells);
    const auto count = vtkIdType(surface.vectors.size());
    auto vectors = newArray(surface.doubles, "Vector", 3, count),
         scalars = newArray(surface.doubles, "Scalar", 1, count);
    for (vtkIdType i = 0; i < count; ++i) {
        const glm::dvec3& v = surface.vectors[std::size_t(i)];
        vectors->SetTuple3(i, v.x, v.y, v.z);
        scalars->SetTuple1(i, surface.scalars[std::size_t(i)]);
    }
    auto* all = surface.onCells ? static_cast<vtkFieldData*>(data->GetCellData()) : data->GetPointData();
    if (count > 0) all->AddArray(vectors);
    if (count > 0) all->AddArray(scalars);
    return data;
}

void writeMultiBlock(const std::string& path, const SampleSurface& surface)
{
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, polyDataOf(surface));
    vtkNew<vtkXMLMultiBlockDataWriter> writer;
    writer->SetInputData(blocks);
    writer->SetFileName(path.c_str());
    writer->Write();
}

void writeEnSight(const std::string& path, const SampleSurface& surface, const EnSightFormat& format)
{
    const std::string folder = fs::path(path).parent_path().string();
    EnSightBytes geometry(format), vectors(format), scalars(format);
    if (format.encoding == EnSightEncoding::binary) geometry.text("C Binary");
    if (format.encoding == EnSightEncoding::fortran) geometry.text("Fortran Binary");
    const auto component = [](const std::vector<glm::dvec3>& values, int c) {
        std::vector<float> numbers;
        for (const glm::dvec3& value : values) numbers.push_back(float(value[c]));
        return numbers;
    };
    geometry.text("a surface").text("").text("node id off").text("element id off");
    geometry.text("part").whole({1}).text("Surface").text("coordinates").whole({int(surface.points.size())});
    for (int c = 0; c < 3; ++c) geometry.reals(component(surface.points, c));
    std::vector<int> corners;
    for (const auto& t : surface.triangles)
        for (const std::int64_t corner : t) corners.push_back(int(corner) + 1);
    geometry.text("tria3").whole({int(surface.triangles.size())}).whole(corners);
    const char* where = surface.onCells ? "tria3" : "coordinates";
    vectors.text("Vector").text("part").whole({1}).text(where);
    for (int c = 0; c < 3; ++c) vectors.reals(component(surface.vectors, c));
    scalars.text("Scalar").text("part").whole({1}).text(where).reals({surface.scalars.begin(), surface.scalars.end()});
    writeBytes(folder + "/a.geo", geometry.bytes());
    writeBytes(folder + "/a.v", vectors.bytes());
    writeBytes(folder + "/a.s", scalars.bytes());
    writeBytes(path, fmt::format("FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: a.geo\nVARIABLE\nvector per {0}: Vector "
                                 "a.v\nscalar per {0}: Scalar a.s\n",
                                 surface.onCells ? "element" : "node"));
}

/// A case of one wall, whose faces are the triangles. All of them belong to one cell.
void writeOpenFoam(const std::string& folder, const SampleSurface& surface)
{
    const auto write = [&](const std::string& name, const char* type, const std::string& body) {
        fs::create_directories((fs::path(folder) / name).parent_path());
        writeBytes((fs::path(folder) / name).string(),
                   fmt::format("FoamFile\n{{\n version 2.0;\n format ascii;\n class {};\n object {};\n}}\n{}\n", type,
                               fs::path(name).filename().string(), body));
    };
    const auto list = [](std::size_t count, const std::string& values) {
        return fmt::format("{}\n({})\n", count, values);
    };
    std::string points, faces, owners, vectors, scalars;
    for (const glm::dvec3& p : surface.points) points += fmt::format("({} {} {})\n", p.x, p.y, p.z);
    for (const auto& t : surface.triangles) faces += fmt::format("3({} {} {})\n", t[0], t[1], t[2]);
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) owners += "0\n";
    for (const glm::dvec3& v : surface.vectors) vectors += fmt::format("({} {} {})\n", v.x, v.y, v.z);
    for (const double s : surface.scalars) scalars += fmt::format("{}\n", s);
    const std::size_t count = surface.triangles.size();
    write("constant/polyMesh/points", "vectorField", list(surface.points.size(), points));
    write("constant/polyMesh/faces", "faceList", list(count, faces));
    write("constant/polyMesh/owner", "labelList", list(count, owners));
    write("constant/polyMesh/neighbour", "labelList", list(0, ""));
    write("constant/polyMesh/boundary", "polyBoundaryMesh",
          fmt::format("1\n(\nSurface {{ type wall; nFaces {}; startFace 0; }}\n)", count));
    const auto field = [&](const char* name, const char* type, const char* zero, const char* element,
                           const std::string& values) {
        write(std::string("0/") + name, type,
              fmt::format("dimensions [0 0 0 0 0 0 0];\ninternalField uniform {};\nboundaryField\n{{\nSurface {{ type "
                          "fixedValue; value "
                          "nonuniform List<{}> {}; }}\n}}",
                          zero, element, list(count, values)));
    };
    field("Vector", "volVectorField", "(0 0 0)", "vector", vectors);
    field("Scalar", "volScalarField", "0", "scalar", scalars);
}

/// Names of values are numbers in Fluent: these are wall shear and pressure.
void writeFluent(const std::string& path, const SampleSurface& surface)
{
    const std::size_t points = surface.points.size(), faces = surface.triangles.size();
    std::string text = fmt::format("(2 3)\n(10 (1 1 {:x} 1 3)(\n", points);
    for (const glm::dvec3& p : surface.points) text += fmt::format("{} {} {}\n", p.x, p.y, p.z);
    text += fmt::format("))\n(12 (2 1 1 1 2))\n(13 (3 1 {:x} 3 3)(\n", faces);
    // Turned around a thumb that points into the cell.
    for (const auto& t : surface.triangles) text += fmt::format("{:x} {:x} {:x} 1 0\n", t[2] + 1, t[1] + 1, t[0] + 1);
    writeBytes(path, text + "))\n(45 (3 wall Surface)())\n");
    std::string values = fmt::format("(300 (19 3 3 0 0 1 {})(\n", faces);
    for (const glm::dvec3& v : surface.vectors) values += fmt::format("{} {} {}\n", v.x, v.y, v.z);
    values += fmt::format("))\n(300 (1 3 1 0 0 1 {})(\n", faces);
    for (const double s : surface.scalars) values += fmt::format("{}\n", s);
    writeBytes(fs::path(path).replace_extension(".dat").string(), values + "))\n");
}

template <class Writer>
void writeBy(const std::string& path, const SampleSurface& surface)
{
    vtkNew<Writer> writer;
    writer->SetInputData(polyDataOf(surface));
    writer->SetFileName(path.c_str());
    writer->SetFileTypeToBinary();
    writer->Write();
}

void writeObj(const std::string& path, const SampleSurface& surface)
{
    std::string text;
    for (const glm::dvec3& p : surface.points) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    for (const auto& t : surface.triangles) text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
    writeBytes(path, text);
}

}  // namespace

std::vector<SurfaceFormat> surfaceFormats()
{
    std::vector<SurfaceFormat> formats;
    const auto xml = [](Encoding encoding) {
        return [encoding](const std::string& path, const SampleSurface& surface) {
            writeDataSet(path, *polyDataOf(surface), encoding);
        };
    };
    formats.push_back({"VTK XML, raw", "a.vtp", xml(Encoding::raw)});
    formats.push_back({"VTK XML, packed", "a.vtp", xml(Encoding::zlib)});
    formats.push_back({"VTK XML, text", "a.vtp", xml(Encoding::ascii)});
    formats.push_back({"VTK XML in pieces", "a.pvtp", xml(Encoding::raw)});
    formats.push_back({"legacy VTK", "a.vtk", xml(Encoding::raw)});
    formats.push_back({"VTK multi-block", "a.vtm", writeMultiBlock});
    formats.push_back({"VTK multi-block, other ending", "a.vtmb", writeMultiBlock});
    for (const bool newest : {false, true})
        formats.push_back({newest ? "VTKHDF, newest and packed" : "VTKHDF", newest ? "a.hdf" : "a.vtkhdf",
                           [newest](const std::string& path, const SampleSurface& surface) {
                               writeVtkHdf(path, {polyDataOf(surface)}, {.newest = newest, .packed = newest});
                           }});
    formats.push_back({"CGNS", "a.cgns", writeCgnsSurface});
    using Form = SampleExodus::Form;
    for (const auto& [form, name] : {std::pair{Form::classic, "Exodus, classic"},
                                     {Form::offsets64, "Exodus, 64-bit offsets"},
                                     {Form::data64, "Exodus, CDF-5"},
                                     {Form::netcdf4, "Exodus, netCDF-4"}})
        formats.push_back({name, "a.e", [form](const std::string& path, const SampleSurface& surface) {
                               writeExodusSurface(path, surface, form);
                           }});
    formats.push_back({"Tecplot", "a.tec", writeTecplotSurface});
    using InEnSight = EnSightEncoding;
    for (const auto& [format, name] : {std::pair{EnSightFormat{InEnSight::ascii, false}, "EnSight, text"},
                                       {{InEnSight::binary, false}, "EnSight, C Binary"},
                                       {{InEnSight::binary, true}, "EnSight, C Binary swapped"},
                                       {{InEnSight::fortran, false}, "EnSight, Fortran Binary"}}) {
        SurfaceFormat ensight{name, "a.case", [format](const std::string& path, const SampleSurface& surface) {
                                  writeEnSight(path, surface, format);
                              }};
        ensight.doubles = false;  // The format has numbers of 32 bits alone.
        formats.push_back(ensight);
    }
    SurfaceFormat foam{"OpenFOAM", "case", writeOpenFoam},
        fluent{"Fluent", "a.cas", writeFluent, "WALL_SHEAR", "PRESSURE"};
    foam.onPoints = fluent.onPoints = false;  // Values stand on faces.
    formats.push_back(foam);
    formats.push_back(fluent);
    return formats;
}

std::vector<SurfaceFormat> bareSurfaceFormats()
{
    std::vector<SurfaceFormat> formats = surfaceFormats();
    SurfaceFormat ply{"PLY", "a.ply", writeBy<vtkPLYWriter>}, stl{"STL", "a.stl", writeBy<vtkSTLWriter>},
        obj{"OBJ", "a.obj", writeObj};
    ply.doubles = stl.doubles = obj.doubles = false;  // VTK's writers and its reader of OBJ have numbers of 32 bits.
    formats.push_back(ply);
    formats.push_back(stl);
    formats.push_back(obj);
    return formats;
}

SampleSurface bentSheet(bool onCells, bool doubles, bool exact)
{
    SampleSurface surface;
    surface.onCells = onCells;
    surface.doubles = doubles;
    constexpr int across = 12;
    const auto number = [&](double value) {
        if (exact) return std::round(value * 64) / 64;
        return doubles ? value : double(float(value));
    };
    for (int j = 0; j <= across; ++j)
        for (int i = 0; i <= across; ++i) {
            const double x = i / 5.0, y = j / 7.0;
            surface.points.emplace_back(number(x), number(y), number(0.3 * std::sin(2 * x + y)));
        }
    for (int j = 0; j < across; ++j)
        for (int i = 0; i < across; ++i) {
            const std::int64_t at = i + (across + 1) * j;
            surface.triangles.push_back({at, at + 1, at + across + 2});
            surface.triangles.push_back({at, at + across + 2, at + across + 1});
        }
    for (std::size_t i = 0; i < (onCells ? surface.triangles.size() : surface.points.size()); ++i) {
        glm::dvec3 p(0);
        for (const std::int64_t corner : surface.triangles[i % surface.triangles.size()])
            p += surface.points[std::size_t(corner)] / 3.0;
        if (!onCells) p = surface.points[i];
        surface.vectors.emplace_back(number(1 + p.y / 3), number(std::cos(p.x)), number(0.1 * p.x));
        surface.scalars.push_back(number(p.x * p.y + 0.1));
    }
    return surface;
}

}  // namespace aeolic::test
