#include "data/vtk/file_formats.h"

#include <fmt/format.h>
#include <vtkDataObjectTypes.h>
#include <vtkNrrdReader.h>
#include <vtkOBJReader.h>
#include <vtkSTLReader.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLPImageDataReader.h>
#include <vtkXMLPPolyDataReader.h>
#include <vtkXMLPRectilinearGridReader.h>
#include <vtkXMLPStructuredGridReader.h>
#include <vtkXMLPUnstructuredGridReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "aeolic/error.h"
#include "data/vtk/checks/checked_pieces.h"

namespace aeolic {

namespace {

constexpr const char* surfaceFiles = ".vtp .pvtp .vtm .stl .ply .obj, or .vtk with polygons";
constexpr const char* fieldFiles = ".vti .vtr .vts .vtu .pvti .pvtr .pvts .pvtu .nhdr .nrrd, or .vtk with a grid";

template <class Reader>
vtkSmartPointer<vtkAlgorithm> make()
{
    return vtkSmartPointer<Reader>::New();
}

using Use = FileUse;
const FileFormat formats[] = {
    {".vtp", Use::surface, "polygons", make<vtkXMLPolyDataReader>},
    {".pvtp", Use::surface, "polygons", make<vtkXMLPPolyDataReader>},
    {".vtm", Use::surface, "a multi-block data set", make<vtkXMLMultiBlockDataReader>},
    {".stl", Use::surface, "triangles", make<vtkSTLReader>},
    {".ply", Use::surface, "polygons", nullptr},  // Our own readPly().
    {".obj", Use::surface, "polygons", make<vtkOBJReader>},
    {".vtk", Use::any, "a legacy VTK file", nullptr},  // Our own readLegacy().
    {".vti", Use::field, "image data", make<vtkXMLImageDataReader>},
    {".pvti", Use::field, "image data", make<CheckedPieces<vtkXMLPImageDataReader>>},
    {".nhdr", Use::field, "image data", make<vtkNrrdReader>},
    {".nrrd", Use::field, "image data", make<vtkNrrdReader>},
    {".vtr", Use::field, "a rectilinear grid", make<vtkXMLRectilinearGridReader>},
    {".pvtr", Use::field, "a rectilinear grid", make<CheckedPieces<vtkXMLPRectilinearGridReader>>},
    {".vts", Use::field, "a structured grid", make<vtkXMLStructuredGridReader>},
    {".pvts", Use::field, "a structured grid", make<CheckedPieces<vtkXMLPStructuredGridReader>>},
    {".vtu", Use::field, "an unstructured grid", make<vtkXMLUnstructuredGridReader>},
    {".pvtu", Use::field, "an unstructured grid", make<vtkXMLPUnstructuredGridReader>},
};

}  // namespace

const FileFormat& chooseFormat(const std::string& path, const std::string& extension, FileUse use)
{
    const auto* format = std::find_if(std::begin(formats), std::end(formats),
                                      [&](const FileFormat& f) { return extension == f.extension; });
    const std::string expected = use == Use::surface ? fmt::format("a surface: {}", surfaceFiles)
                                 : use == Use::field ? fmt::format("a field: {}", fieldFiles)
                                                     : fmt::format("{}; {}", surfaceFiles, fieldFiles);
    if (format == std::end(formats))
        throw InputError(
            path, extension.empty() ? "the name has no extension" : "unknown extension '" + extension + "'", expected);
    if (use == Use::surface && format->use == Use::field)
        throw InputError(path, fmt::format("{} is a field, not a surface", format->kind),
                         fmt::format("{} (cut a surface out with --field {} --surface boundary)", expected, path));
    if (use == Use::field && format->use == Use::surface)
        throw InputError(path, fmt::format("{} are a surface, not a field", format->kind),
                         fmt::format("{} (a surface goes to --surface)", expected));
    return *format;
}

std::string extensionOf(const std::string& path)
{
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

std::string kindOf(vtkDataObject& data)
{
    switch (data.GetDataObjectType()) {
        case VTK_POLY_DATA:
            return "polygons";
        case VTK_IMAGE_DATA:
        case VTK_STRUCTURED_POINTS:
        case VTK_UNIFORM_GRID:
            return "image data";
        case VTK_RECTILINEAR_GRID:
            return "a rectilinear grid";
        case VTK_STRUCTURED_GRID:
            return "a structured grid";
        case VTK_UNSTRUCTURED_GRID:
            return "an unstructured grid";
        case VTK_MULTIBLOCK_DATA_SET:
            return "a multi-block data set";
        default:
            return data.GetClassName();
    }
}

}  // namespace aeolic
