#include "data/vtk/file_formats.h"

#include <fmt/format.h>
#include <vtkDataObjectTypes.h>
#include <vtkNrrdReader.h>
#include <vtkOBJReader.h>
#include <vtkSTLReader.h>
#include <vtkXMLImageDataReader.h>
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
#include <iterator>

#include "aeolic/error.h"
#include "data/vtk/checks/checked_pieces.h"
#include "data/vtk/large_arrays.h"

namespace aeolic {

namespace {

template <class Reader>
vtkSmartPointer<vtkAlgorithm> make()
{
    return vtkSmartPointer<Reader>::New();
}

struct Maker {
    const char* extension;
    ReaderMaker make;
};

/// Files of other kinds are read by our own code.
const Maker makers[] = {
    {".vtp", make<LargeArrays<vtkXMLPolyDataReader>>},
    {".pvtp", make<vtkXMLPPolyDataReader>},
    {".stl", make<vtkSTLReader>},
    {".obj", make<vtkOBJReader>},
    {".vti", make<LargeArrays<vtkXMLImageDataReader>>},
    {".pvti", make<CheckedPieces<vtkXMLPImageDataReader>>},
    {".nhdr", make<vtkNrrdReader>},
    {".nrrd", make<vtkNrrdReader>},
    {".vtr", make<LargeArrays<vtkXMLRectilinearGridReader>>},
    {".pvtr", make<CheckedPieces<vtkXMLPRectilinearGridReader>>},
    {".vts", make<LargeArrays<vtkXMLStructuredGridReader>>},
    {".pvts", make<CheckedPieces<vtkXMLPStructuredGridReader>>},
    {".vtu", make<LargeArrays<vtkXMLUnstructuredGridReader>>},
    {".pvtu", make<vtkXMLPUnstructuredGridReader>},
};

}  // namespace

FileFormat chooseFormat(const std::string& path, const std::string& extension, FileUse use)
{
    const auto* row = std::find_if(std::begin(fileKinds), std::end(fileKinds), [&](const FileKind& kind) {
        return !extension.empty() && extension == kind.extension;
    });
    const std::string surfaces = fileKindsText(FileUse::surface), fields = fileKindsText(FileUse::field);
    const std::string expected = use == FileUse::surface ? "a surface: " + surfaces
                                 : use == FileUse::field ? "a field: " + fields
                                                         : surfaces + "; " + fields;
    if (row == std::end(fileKinds))
        throw InputError(
            path, extension.empty() ? "the name has no extension" : "unknown extension '" + extension + "'", expected);
    if (use == FileUse::surface && row->use == FileUse::field)
        throw InputError(path, fmt::format("{} is a field, not a surface", row->kind),
                         fmt::format("{} (cut a surface out with --field {} --surface boundary)", expected, path));
    if (use == FileUse::field && row->use == FileUse::surface)
        throw InputError(path, fmt::format("{} are a surface, not a field", row->kind),
                         fmt::format("{} (a surface goes to --surface)", expected));
    const auto* maker =
        std::find_if(std::begin(makers), std::end(makers), [&](const Maker& m) { return extension == m.extension; });
    return {row->kind, maker == std::end(makers) ? nullptr : maker->make};
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
