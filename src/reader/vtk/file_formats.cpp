#include "reader/vtk/file_formats.h"

#include <fmt/format.h>
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
#include "reader/vtk/checks/checked_pieces.h"
#include "reader/vtk/large_arrays.h"
#include "reader/vtk/modules/modules.h"

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

vtkSmartPointer<vtkAlgorithm> makeStl()
{
    return vtkModule().makeStl();
}

vtkSmartPointer<vtkAlgorithm> makeObj()
{
    return vtkModule().makeObj();
}

vtkSmartPointer<vtkAlgorithm> makeNrrd()
{
    return vtkModule().makeNrrd();
}

/// Files of other kinds are read by our own code.
const Maker makers[] = {
    {".vtp", make<LargeArrays<vtkXMLPolyDataReader>>},
    {".pvtp", make<vtkXMLPPolyDataReader>},
    {".stl", makeStl},
    {".obj", makeObj},
    {".vti", make<LargeArrays<vtkXMLImageDataReader>>},
    {".pvti", make<CheckedPieces<vtkXMLPImageDataReader>>},
    {".nhdr", makeNrrd},
    {".nrrd", makeNrrd},
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

}  // namespace aeolic
