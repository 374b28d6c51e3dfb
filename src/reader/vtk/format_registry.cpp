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
#include <filesystem>
#include <string_view>

#include "aeolic/error.h"
#include "base/text.h"
#include "data/named_file.h"
#include "reader/ensight/ensight_case.h"
#include "reader/lists/series_files.h"
#include "reader/openfoam/foam_parts.h"
#include "reader/parts/open_parts.h"
#include "reader/vtk/format_readers.h"
#include "reader/vtk/modules/modules.h"
#include "reader/vtk/part_blocks.h"
#include "reader/vtk/summarize.h"
#include "reader/vtk/xml/xml_reader.h"
#include "reader/vtk/xml/xml_tree.h"

namespace aeolic {

namespace {

template <class Reader>
vtkSmartPointer<vtkAlgorithm> make()
{
    return vtkSmartPointer<Reader>::New();
}

/// A function of a module, which is loaded when such a file comes.
template <auto Function, class... Given>
auto fromHdf5(Given... given)
{
    return (hdf5Module().*Function)(given...);
}

template <auto Function>
vtkSmartPointer<vtkAlgorithm> fromVtk()
{
    return (vtkModule().*Function)();
}

std::unique_ptr<OwnReader> openFoam(const std::string& path, FileUse use, std::optional<double> time)
{
    return std::make_unique<PartBlocks>(openFoamCase(path, use, time), path, use);
}

std::vector<std::uint64_t> bytesOfPieces(const std::string& path, FileUse, const std::vector<std::string>&)
{
    checkReadableFile(path);
    std::vector<std::uint64_t> bytes;
    for (const std::string& piece : pieceFilesOf(path)) bytes.push_back(checkReadableFile(piece));
    return bytes;
}

std::unique_ptr<OwnReader> openEnSight(const std::string& path, FileUse use, std::optional<double> time)
{
    if (readEnSightCase(path).isForVtk) return vtkModule().openEnSight6(path, use, time);
    return std::make_unique<PartBlocks>(openEnSightCase(path, time), path, use);
}

std::vector<double> timesOfEnSight(const std::string& path, const std::vector<std::string>&)
{
    checkReadableFile(path);
    const EnSightCase text = readEnSightCase(path);
    return text.isForVtk ? openEnSight(path, FileUse::any, {})->times() : text.times();
}

// What a damaged file claims to hold may fill the memory. LZMA packs zeros to a few thousandths of their size; a digit
// and a blank become a number of eight bytes, of which there are several copies.
constexpr std::uint64_t kXml = 20000, kPlain = 100;

// clang-format off
constexpr FormatReader readers[] = {
    {.endings = ".foam .openfoam", .open = openFoam, .times = foamTimes, .pieces = foamPieces,
     .summary = summaryOfFoam},
    {.endings = ".vtp", .unpacked = kXml, .makeReader = make<XmlReader<vtkXMLPolyDataReader>>,
     .counts = countsOfXml},
    {.endings = ".pvtp", .makeReader = make<XmlPiecesReader<vtkXMLPPolyDataReader, vtkXMLPolyDataReader>>, .pieces = bytesOfPieces},
    {.endings = ".vtm .vtmb", .open = openMultiBlock},
    {.endings = ".vthb", .open = openMultiBlock},
    {.endings = ".case .encas", .open = openEnSight, .times = timesOfEnSight},
    {.endings = ".cgns", .openParts = fromHdf5<&Hdf5Module::openCgns>},
    {.endings = ".e .exo .ex2 .exii .g", .openParts = fromHdf5<&Hdf5Module::openExodus>},
    {.endings = ".vtkhdf .hdf", .open = fromHdf5<&Hdf5Module::openVtkHdf>},
    {.endings = ".nc .nc4 .cdf", .open = fromHdf5<&Hdf5Module::openNetcdfGrid>},
    {.endings = ".tec .dat .plt", .unpacked = kPlain, .openParts = openTecplotFile},
    {.endings = ".cas", .unpacked = kPlain, .openParts = openFluentFile},
    {.endings = ".msh", .unpacked = kPlain, .openParts = openFluentFile},
    {.endings = ".stl", .unpacked = kPlain, .makeReader = fromVtk<&VtkModule::makeStl>,
     .check = checkStl, .counts = countsOfStl},
    {.endings = ".ply", .unpacked = kPlain, .read = readPly, .counts = countsOfPly},
    {.endings = ".obj", .unpacked = kPlain, .read = readObj},
    {.endings = ".vtk", .unpacked = kPlain, .read = readLegacy},
    {.endings = ".vti", .unpacked = kXml, .makeReader = make<XmlReader<vtkXMLImageDataReader>>},
    {.endings = ".pvti", .makeReader = make<XmlPiecesReader<vtkXMLPImageDataReader, vtkXMLImageDataReader>>},
    {.endings = ".nhdr", .makeReader = fromVtk<&VtkModule::makeNrrd>},
    {.endings = ".nrrd", .makeReader = fromVtk<&VtkModule::makeNrrd>},
    {.endings = ".vtr", .unpacked = kXml, .makeReader = make<XmlReader<vtkXMLRectilinearGridReader>>},
    {.endings = ".pvtr", .makeReader = make<XmlPiecesReader<vtkXMLPRectilinearGridReader, vtkXMLRectilinearGridReader>>},
    {.endings = ".vts", .unpacked = kXml, .makeReader = make<XmlReader<vtkXMLStructuredGridReader>>},
    {.endings = ".pvts", .makeReader = make<XmlPiecesReader<vtkXMLPStructuredGridReader, vtkXMLStructuredGridReader>>},
    {.endings = ".vtu", .unpacked = kXml, .makeReader = make<XmlReader<vtkXMLUnstructuredGridReader>>},
    {.endings = ".pvtu", .makeReader = make<XmlPiecesReader<vtkXMLPUnstructuredGridReader, vtkXMLUnstructuredGridReader>>, .pieces = bytesOfPieces},
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

const FormatReader& formatOf(const FileKind& kind)
{
    return readers[&kind - fileKinds];
}

std::uint64_t mostMemoryOf(const std::string& path)
{
    const FileKind* kind = namedKind(path);
    std::error_code error;
    const std::uint64_t unpacked = kind ? formatOf(*kind).unpacked : 0, bytes = std::filesystem::file_size(path, error);
    return unpacked == 0 || error ? UINT64_MAX : unpacked * bytes;
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
        if (const UnreadKind* unread = unreadKindOf(path))
            throw InputError(path, fmt::format("it is {}, which is not read", unread->format), unread->instead);
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
