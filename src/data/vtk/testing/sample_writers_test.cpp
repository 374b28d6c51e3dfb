#include "data/vtk/testing/sample_writers.h"

#include <unistd.h>
#include <vtkDataSetWriter.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkXMLDataSetWriter.h>
#include <vtkXMLPImageDataWriter.h>
#include <vtkXMLPPolyDataWriter.h>
#include <vtkXMLPRectilinearGridWriter.h>
#include <vtkXMLPStructuredGridWriter.h>
#include <vtkXMLPUnstructuredGridWriter.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace aeolic::test {

namespace {

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

}  // namespace

std::string extension(const std::string& path)
{
    return std::filesystem::path(path).extension().string();
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
