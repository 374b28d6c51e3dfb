#include "data/vtk/sample_files.h"

#include <unistd.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetTriangleFilter.h>
#include <vtkDataSetWriter.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkImageDataToPointSet.h>
#include <vtkMatrix3x3.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOBJWriter.h>
#include <vtkPLYWriter.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>
#include <vtkSTLWriter.h>
#include <vtkStripper.h>
#include <vtkStructuredGrid.h>
#include <vtkTriangleFilter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLDataSetWriter.h>
#include <vtkXMLMultiBlockDataWriter.h>
#include <vtkXMLPImageDataWriter.h>
#include <vtkXMLPPolyDataWriter.h>
#include <vtkXMLPRectilinearGridWriter.h>
#include <vtkXMLPStructuredGridWriter.h>
#include <vtkXMLPUnstructuredGridWriter.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace aeolic::test {

namespace {

std::string extension(const std::string& path)
{
    return std::filesystem::path(path).extension().string();
}

double stretched(double x, double stretch)
{
    return x + stretch * x * x;
}

vtkSmartPointer<vtkDataArray> newArray(bool doubles, const char* name, int components, vtkIdType tuples)
{
    vtkSmartPointer<vtkDataArray> array;
    if (doubles)
        array = vtkSmartPointer<vtkDoubleArray>::New();
    else
        array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(tuples);
    return array;
}

vtkSmartPointer<vtkUnsignedCharArray> flags(const char* name, vtkIdType count, int value, const std::vector<int>& at, int atValue)
{
    auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
    array->SetName(name);
    array->SetNumberOfTuples(count);
    array->FillValue(static_cast<unsigned char>(value));
    for (const int i : at) array->SetValue(i, static_cast<unsigned char>(atValue));
    return array;
}

void addGridArrays(vtkDataSet& data, const GridSample& sample)
{
    const vtkIdType count = sample.onCells ? data.GetNumberOfCells() : data.GetNumberOfPoints();
    auto vectors = newArray(sample.doubles, "U", sample.components, count);
    auto second = newArray(sample.doubles, "W", 3, count);
    auto scalars = newArray(sample.doubles, "p", 1, count);
    double x[3], bounds[6];
    for (vtkIdType i = 0; i < count; ++i) {
        data.GetPoint(sample.onCells ? 0 : i, x);
        if (sample.onCells) {
            data.GetCellBounds(i, bounds);
            for (int c = 0; c < 3; ++c) x[c] = 0.5 * (bounds[2 * c] + bounds[2 * c + 1]);
        }
        const auto u = sampleVector(x[0], x[1], x[2]);
        for (int c = 0; c < sample.components; ++c) vectors->SetComponent(i, c, u[std::size_t(c)]);
        second->SetTuple(i, u.data());
        scalars->SetTuple1(i, sampleScalar(x[0], x[1], x[2]));
    }
    for (const int i : sample.nanPoints) vectors->SetComponent(i, 1, std::numeric_limits<double>::quiet_NaN());
    for (const int i : sample.infinitePoints) vectors->SetComponent(i, 2, std::numeric_limits<double>::infinity());
    auto* attributes = sample.onCells ? static_cast<vtkDataSetAttributes*>(data.GetCellData()) : data.GetPointData();
    const auto keep = [&](const char* name) {
        return std::find(sample.leaveOut.begin(), sample.leaveOut.end(), name) == sample.leaveOut.end();
    };
    if (keep("U")) attributes->AddArray(vectors);
    if (sample.secondVectors) attributes->AddArray(second);
    if (keep("p")) attributes->AddArray(scalars);
    if (!sample.maskedPoints.empty()) attributes->AddArray(flags("vtkValidPointMask", count, 1, sample.maskedPoints, 0));
    if (!sample.hiddenPoints.empty())
        attributes->AddArray(flags(vtkDataSetAttributes::GhostArrayName(), count, 0, sample.hiddenPoints,
                                   vtkDataSetAttributes::HIDDENPOINT));
}

vtkSmartPointer<vtkImageData> makeImage(const GridSample& sample)
{
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(sample.dims.data());
    image->SetOrigin(sample.origin.data());
    image->SetSpacing(sample.spacing.data());
    if (sample.turned) image->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
    return image;
}

vtkSmartPointer<vtkDataSet> makeRectilinear(const GridSample& sample)
{
    auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
    grid->SetDimensions(sample.dims.data());
    vtkNew<vtkDoubleArray> axes[3];
    for (std::size_t c = 0; c < 3; ++c)
        for (int i = 0; i < sample.dims[c]; ++i) {
            const double x = sample.origin[c] + i * sample.spacing[c];
            axes[c]->InsertNextValue(c == 0 ? stretched(x, sample.stretch) : x);
        }
    grid->SetXCoordinates(axes[0]);
    grid->SetYCoordinates(axes[1]);
    grid->SetZCoordinates(axes[2]);
    return grid;
}

vtkSmartPointer<vtkDataSet> makeStructured(const GridSample& sample)
{
    vtkNew<vtkImageDataToPointSet> convert;
    convert->SetInputData(makeImage(sample));
    convert->Update();
    vtkSmartPointer<vtkStructuredGrid> grid = convert->GetOutput();
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i) {
        double x[3];
        grid->GetPoint(i, x);
        grid->GetPoints()->SetPoint(i, stretched(x[0], sample.stretch), x[1], x[2]);
    }
    return grid;
}

/// Tetrahedra.
vtkSmartPointer<vtkDataSet> makeUnstructured(const GridSample& sample)
{
    vtkNew<vtkDataSetTriangleFilter> split;
    split->SetInputData(makeStructured(sample));
    split->Update();
    return split->GetOutput();
}

vtkSmartPointer<vtkDataSet> makeGrid(const std::string& extension, const GridSample& sample)
{
    const std::string kinds[] = {".vti", ".vtr", ".vts", ".vtu"};
    std::string kind = extension == ".vtk" ? kinds[sample.legacyKind] : extension;
    if (kind.starts_with(".p")) kind.erase(1, 1);
    vtkSmartPointer<vtkDataSet> data = kind == ".vti"   ? vtkSmartPointer<vtkDataSet>(makeImage(sample))
                                       : kind == ".vtr" ? makeRectilinear(sample)
                                       : kind == ".vts" ? makeStructured(sample)
                                                        : makeUnstructured(sample);
    addGridArrays(*data, sample);
    return data;
}

void encode(vtkXMLWriter& writer, Encoding encoding)
{
    writer.EncodeAppendedDataOff();
    if (encoding == Encoding::raw) writer.SetCompressorTypeToNone();
    if (encoding == Encoding::zlib) writer.SetCompressorTypeToZLib();
    if (encoding == Encoding::ascii) writer.SetDataModeToAscii();
}

template <class Writer>
void writePieces(const std::string& path, vtkDataObject& data, Encoding encoding)
{
    vtkNew<Writer> writer;
    encode(*writer, encoding);
    writer->SetInputData(&data);
    writer->SetFileName(path.c_str());
    writer->SetNumberOfPieces(1);
    writer->Write();
}

void writeDataSet(const std::string& path, vtkDataSet& data, Encoding encoding)
{
    const std::string kind = extension(path);
    if (kind == ".vtk") {
        vtkNew<vtkDataSetWriter> writer;
        writer->SetInputData(&data);
        writer->SetFileName(path.c_str());
        if (encoding != Encoding::ascii) writer->SetFileTypeToBinary();
        writer->Write();
    } else if (kind == ".pvti") {
        writePieces<vtkXMLPImageDataWriter>(path, data, encoding);
    } else if (kind == ".pvtr") {
        writePieces<vtkXMLPRectilinearGridWriter>(path, data, encoding);
    } else if (kind == ".pvts") {
        writePieces<vtkXMLPStructuredGridWriter>(path, data, encoding);
    } else if (kind == ".pvtu") {
        writePieces<vtkXMLPUnstructuredGridWriter>(path, data, encoding);
    } else if (kind == ".pvtp") {
        writePieces<vtkXMLPPolyDataWriter>(path, data, encoding);
    } else {
        vtkNew<vtkXMLDataSetWriter> writer;
        encode(*writer, encoding);
        writer->SetInputData(&data);
        writer->SetFileName(path.c_str());
        writer->Write();
    }
}

void addSheetArrays(vtkPolyData& sheet, const SheetSample& sample)
{
    const vtkIdType points = sheet.GetNumberOfPoints(), cells = sheet.GetNumberOfCells();
    auto tau = newArray(false, "tau", sample.tauComponents, points), q = newArray(false, "q", 1, points);
    auto normals = newArray(false, "Normals", 3, points);
    auto cellTau = newArray(false, "cellTau", 3, cells), cellQ = newArray(true, "cellQ", 1, cells);
    for (vtkIdType i = 0; i < points; ++i) {
        const double x = double(i % (sample.n + 1)) / sample.n, y = double(i / (sample.n + 1)) / sample.n;
        const double vector[3] = {1, x, 0.1};
        for (int c = 0; c < sample.tauComponents; ++c) tau->SetComponent(i, c, vector[c]);
        q->SetTuple1(i, x + y);
        normals->SetTuple3(i, 0, 0, -5);  // Not those of the sheet: to be told from computed ones.
    }
    for (vtkIdType i = 0; i < cells; ++i) {
        cellTau->SetTuple3(i, 2, 0, 0.2);
        cellQ->SetTuple1(i, double(i));
    }
    sheet.GetPointData()->AddArray(tau);
    sheet.GetPointData()->AddArray(q);
    sheet.GetCellData()->AddArray(cellTau);
    sheet.GetCellData()->AddArray(cellQ);
    if (sample.normals) sheet.GetPointData()->SetNormals(normals);
}

vtkSmartPointer<vtkPolyData> makeSheet(const SheetSample& sample)
{
    auto sheet = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> polys, lines, vertices;
    const int n = sample.n;
    const auto bad = std::numeric_limits<double>::quiet_NaN();
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double x = double(i) / n, y = double(j) / n;
            points->InsertNextPoint(sample.allNan ? bad : x + sample.shift[0], y + sample.shift[1], 0.1 * x + sample.shift[2]);
        }
    for (const int i : sample.nanPoints) points->SetPoint(i, bad, 0, 0);
    for (vtkIdType j = 0; j < n; ++j)
        for (vtkIdType i = 0; i < n; ++i) {
            const vtkIdType a = j * (n + 1) + i;
            const vtkIdType quad[4] = {a, a + 1, a + n + 2, a + n + 1};
            if (sample.cells == SheetSample::Cells::lines)
                lines->InsertNextCell(2, quad);
            else if (sample.cells == SheetSample::Cells::vertices)
                vertices->InsertNextCell(1, quad);
            else
                polys->InsertNextCell(4, quad);
        }
    for (int k = 0; k < sample.degenerate; ++k) {
        const vtkIdType line[3] = {0, 1, 0};
        polys->InsertNextCell(3, line);
    }
    if (sample.badIndex) {
        const vtkIdType far[3] = {0, 1, 1000000};
        polys->InsertNextCell(3, far);
    }
    sheet->SetPoints(points);
    sheet->SetVerts(vertices);
    sheet->SetLines(lines);
    sheet->SetPolys(polys);
    if (sample.arrays) addSheetArrays(*sheet, sample);
    if (sample.cells != SheetSample::Cells::triangles && sample.cells != SheetSample::Cells::strips) return sheet;
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(sheet);
    vtkNew<vtkStripper> strips;
    strips->SetInputConnection(triangles->GetOutputPort());
    vtkPolyDataAlgorithm* last = triangles;
    if (sample.cells == SheetSample::Cells::strips) last = strips;
    last->Update();
    vtkSmartPointer<vtkPolyData> result = last->GetOutput();
    return result;
}

template <class Writer>
void writeWith(const std::string& path, vtkDataObject& data)
{
    vtkNew<Writer> writer;
    writer->SetInputData(&data);
    writer->SetFileName(path.c_str());
    writer->Write();
}

}  // namespace

TempFolder::TempFolder()
{
    std::string name = (std::filesystem::temp_directory_path() / "aeolic-test-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path_ = name;
}

TempFolder::~TempFolder()
{
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::array<double, 3> sampleVector(double x, double y, double z)
{
    return {1 + x, 2 * y, x - z};
}

double sampleScalar(double x, double y, double z)
{
    return x + 10 * y + 100 * z;
}

void writeGridFile(const std::string& path, const GridSample& sample)
{
    writeDataSet(path, *makeGrid(extension(path), sample), sample.encoding);
}

void writeSheetFile(const std::string& path, const SheetSample& sample)
{
    const auto sheet = makeSheet(sample);
    const std::string kind = extension(path);
    if (kind == ".stl") {
        vtkNew<vtkSTLWriter> writer;
        writer->SetInputData(sheet);
        writer->SetFileName(path.c_str());
        if (sample.encoding != Encoding::ascii) writer->SetFileTypeToBinary();
        writer->Write();
    } else if (kind == ".ply") {
        vtkNew<vtkPLYWriter> writer;
        writer->SetInputData(sheet);
        writer->SetFileName(path.c_str());
        if (sample.encoding == Encoding::ascii) writer->SetFileTypeToASCII();
        writer->Write();
    } else if (kind == ".obj") {
        writeWith<vtkOBJWriter>(path, *sheet);
    } else if (kind == ".vtm") {
        SheetSample other = sample;
        other.shift = {1, 0, 0.1};
        vtkNew<vtkMultiBlockDataSet> blocks;
        blocks->SetBlock(0, sheet);
        blocks->SetBlock(1, makeSheet(other));
        writeWith<vtkXMLMultiBlockDataWriter>(path, *blocks);
    } else {
        writeDataSet(path, *sheet, sample.encoding);
    }
}

DecodedPng readPng(const std::string& path)
{
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    DecodedPng png;
    png.width = image->GetDimensions()[0];
    png.height = image->GetDimensions()[1];
    png.channels = image->GetNumberOfScalarComponents();
    const std::size_t rowBytes = std::size_t(png.width) * std::size_t(png.channels);
    const auto* rows = static_cast<const unsigned char*>(image->GetScalarPointer());
    for (int y = png.height - 1; y >= 0; --y)
        png.pixels.insert(png.pixels.end(), rows + std::size_t(y) * rowBytes, rows + std::size_t(y + 1) * rowBytes);
    return png;
}

std::string readBytes(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void writeBytes(const std::string& path, const std::string& bytes)
{
    std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace aeolic::test
