#include "reader/vtk/format_registry.h"

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
#include <string_view>

#include "aeolic/error.h"
#include "base/text.h"
#include "data/named_file.h"
#include "reader/ensight/ensight_case.h"
#include "reader/ensight/ensight_parts.h"
#include "reader/fluent/fluent_parts.h"
#include "reader/lists/series_json.h"
#include "reader/tecplot/tecplot_parts.h"
#include "reader/vtk/checks/checked_pieces.h"
#include "reader/vtk/file_checks.h"
#include "reader/vtk/foam_file.h"
#include "reader/vtk/large_arrays.h"
#include "reader/vtk/legacy/legacy_reader.h"
#include "reader/vtk/modules/modules.h"
#include "reader/vtk/multi_block_file.h"
#include "reader/vtk/ply_reader.h"
#include "reader/vtk/pvd_file.h"
#include "reader/vtk/surface_header.h"

namespace aeolic {

namespace {

template <class Reader>
vtkSmartPointer<vtkAlgorithm> make()
{
    return vtkSmartPointer<Reader>::New();
}

std::unique_ptr<PartSource> openCgns(const std::string& path, std::optional<double> time)
{
    return hdf5Module().openCgns(path, time);
}

std::unique_ptr<PartSource> openExodus(const std::string& path, std::optional<double> time)
{
    return hdf5Module().openExodus(path, time);
}

std::unique_ptr<OwnReader> openHdf(const std::string& path, FileUse use, std::optional<double> time)
{
    return hdf5Module().openVtkHdf(path, use, time);
}

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

vtkSmartPointer<vtkDataObject> readPolygons(const std::string& path, const ProgressReport& progress)
{
    return readPly(path, progress);
}

std::vector<std::uint64_t> bytesOfPieces(const std::string& path)
{
    checkReadableFile(path);
    std::vector<std::uint64_t> bytes;
    for (const std::string& piece : pieceFilesOf(path)) bytes.push_back(checkReadableFile(piece));
    return bytes;
}

std::vector<double> timesOfEnSight(const std::string& path)
{
    checkReadableFile(path);
    return readEnSightCase(path).times();
}

// clang-format off
constexpr FormatReader readers[] = {
    {.endings = "", .open = openFoam, .times = foamTimes, .pieces = foamPieces, .summary = summaryOfFoam},
    {.endings = ".foam .openfoam", .open = openFoam, .times = foamTimes, .pieces = foamPieces,
     .summary = summaryOfFoam},
    {.endings = ".vtp", .makeReader = make<LargeArrays<vtkXMLPolyDataReader>>, .check = checkXml,
     .counts = countsOfXml},
    {.endings = ".pvtp", .makeReader = make<vtkXMLPPolyDataReader>, .check = checkXml, .pieces = bytesOfPieces},
    {.endings = ".vtm .vtmb", .open = openMultiBlock},
    {.endings = ".case .encas", .openParts = openEnSightCase, .times = timesOfEnSight},
    {.endings = ".cgns", .openParts = openCgns},
    {.endings = ".e .exo .ex2 .exii .g", .openParts = openExodus},
    {.endings = ".vtkhdf .hdf", .open = openHdf},
    {.endings = ".tec .dat .plt", .openParts = openTecplotFile},
    {.endings = ".cas", .openParts = openFluentFile},
    {.endings = ".msh", .openParts = openFluentFile},
    {.endings = ".stl", .makeReader = makeStl, .check = checkStl, .counts = countsOfStl},
    {.endings = ".ply", .read = readPolygons, .counts = countsOfPly},
    {.endings = ".obj", .makeReader = makeObj},
    {.endings = ".vtk", .read = readLegacy},
    {.endings = ".vti", .makeReader = make<LargeArrays<vtkXMLImageDataReader>>, .check = checkXml},
    {.endings = ".pvti", .makeReader = make<CheckedPieces<vtkXMLPImageDataReader>>, .check = checkXml},
    {.endings = ".nhdr", .makeReader = makeNrrd, .check = checkNrrd},
    {.endings = ".nrrd", .makeReader = makeNrrd, .check = checkNrrd},
    {.endings = ".vtr", .makeReader = make<LargeArrays<vtkXMLRectilinearGridReader>>, .check = checkXml},
    {.endings = ".pvtr", .makeReader = make<CheckedPieces<vtkXMLPRectilinearGridReader>>, .check = checkXml},
    {.endings = ".vts", .makeReader = make<LargeArrays<vtkXMLStructuredGridReader>>, .check = checkXml},
    {.endings = ".pvts", .makeReader = make<CheckedPieces<vtkXMLPStructuredGridReader>>, .check = checkXml},
    {.endings = ".vtu", .makeReader = make<LargeArrays<vtkXMLUnstructuredGridReader>>, .check = checkXml},
    {.endings = ".pvtu", .makeReader = make<vtkXMLPUnstructuredGridReader>, .check = checkXml, .pieces = bytesOfPieces},
    {.endings = ".pvd", .listed = readPvdFile},
    {.endings = ".series", .listed = readSeriesFile},
    {.endings = ".json .xml .csv"},  // Read by data/color_map/, which asks for what stands in XML.
};
// clang-format on

static_assert(std::ranges::equal(
                  readers, fileKinds, {}, [](const FormatReader& row) { return std::string_view(row.endings); },
                  [](const FileKind& row) { return std::string_view(row.endings); }),
              "each kind of file has its row here, in the same order");

}  // namespace

std::span<const FormatReader> formatReaders()
{
    return readers;
}

const FormatReader& formatOf(const FileKind& kind)
{
    return readers[&kind - fileKinds];
}

const FileKind& chooseKind(const std::string& path, FileUse use)
{
    const FileKind* kind = namedKind(path);
    if (kind == &folderKind) return *kind;
    const std::string surfaces = fileKindsText(FileUse::surface), fields = fileKindsText(FileUse::field);
    const std::string expected = use == FileUse::surface ? "a surface: " + surfaces
                                 : use == FileUse::field ? "a field: " + fields
                                                         : fileKindsText(FileUse::any);
    if (!kind || !kind->holdsData()) {
        const std::string extension = lowerExtension(path);
        throw InputError(
            path, extension.empty() ? "the name has no extension" : "unknown extension '" + extension + "'", expected);
    }
    if (use == FileUse::surface && kind->use == FileUse::field)
        throw InputError(path, fmt::format("{} is a field, not a surface", kind->kind),
                         fmt::format("{} (cut a surface out with --field {} --surface boundary)", expected, path));
    if (use == FileUse::field && kind->use == FileUse::surface)
        throw InputError(path, fmt::format("{} are a surface, not a field", kind->kind),
                         fmt::format("{} (a surface goes to --surface)", expected));
    return *kind;
}

}  // namespace aeolic
