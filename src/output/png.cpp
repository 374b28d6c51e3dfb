#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <cstring>
#include <stdexcept>

#include "aeolic/picture.h"
#include "data/vtk/messages.h"
#include "output/output_check.h"

namespace aeolic {

namespace {

/// A higher level would cost more time than the smaller file saves: LIC pictures are noise, and noise does not
/// compress.
constexpr int compressionLevel = 3;

std::string encoded(const Picture& picture, const std::string& path)
{
    const std::size_t rowBytes = std::size_t(picture.width) * std::size_t(picture.channels);
    if (picture.width <= 0 || picture.height <= 0 || (picture.channels != 3 && picture.channels != 4) ||
        picture.pixels.size() != rowBytes * std::size_t(picture.height))
        throw std::runtime_error(path + ": not a picture: its size and its pixels do not agree");

    vtkNew<vtkImageData> image;
    image->SetDimensions(picture.width, picture.height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, picture.channels);
    auto* rows = static_cast<std::uint8_t*>(image->GetScalarPointer());
    for (int y = 0; y < picture.height; ++y)  // VTK's images begin at the bottom.
        std::memcpy(rows + std::size_t(picture.height - 1 - y) * rowBytes,
                    picture.pixels.data() + std::size_t(y) * rowBytes, rowBytes);

    const VtkMessages messages;
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->SetCompressionLevel(compressionLevel);
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray* file = writer->GetResult();
    if (messages.failed() || !file)
        throw std::runtime_error(path + ": cannot be encoded as PNG: " + messages.firstError());
    return {reinterpret_cast<const char*>(file->GetPointer(0)), std::size_t(file->GetNumberOfValues())};
}

}  // namespace

std::string pngOf(const Picture& picture)
{
    return encoded(picture, "PNG");
}

void writePng(const Picture& picture, const std::string& path)
{
    writeTextFile(path, encoded(picture, path));
}

}  // namespace aeolic
