#include "data/vtk/surface/surface_file.h"

#include <fmt/format.h>
#include <vtkAppendPolyData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>

#include "aeolic/error.h"
#include "data/named_file.h"
#include "data/piece_run.h"
#include "data/reading/file_questions.h"
#include "data/vtk/data_objects.h"
#include "data/vtk/file_reader.h"
#include "data/vtk/grid/cell_means.h"
#include "data/vtk/messages.h"
#include "data/vtk/surface/outer_surface.h"
#include "data/vtk/surface/polydata_mesh.h"

namespace aeolic {

namespace {

vtkSmartPointer<vtkPolyData> appended(vtkAppendPolyData& append, const std::string& path, const char* expected)
{
    const VtkMessages messages;
    append.Update();
    if (messages.failed()) throw InputError(path, messages.firstError(), expected);
    return append.GetOutput();
}

/// Blocks as one; arrays survive where every block has them. Blocks of faces in grids are faces. Blocks that fill space
/// give their outer surface, if they are asked for: `named`.
vtkSmartPointer<vtkPolyData> appendBlocks(const std::vector<Block>& blocks, bool named, const std::string& path)
{
    vtkNew<vtkAppendPolyData> append;
    int used = 0, skipped = 0;
    std::string skippedKind;
    for (const Block& block : blocks) {
        vtkSmartPointer<vtkPolyData> polyData = vtkPolyData::SafeDownCast(block.data);
        if (auto* cells = vtkDataSet::SafeDownCast(block.data);
            cells && !polyData && (named || dimensionOfCells(*cells) == 2))
            polyData = outerSurface(*cells, path);
        if (polyData && polyData->GetNumberOfCells() > 0) {
            append->AddInputData(polyData);
            ++used;
        } else if (!polyData) {
            ++skipped;
            skippedKind = kindOf(*block.data);
        }
    }
    if (used == 0)
        throw InputError(path,
                         skipped          ? "its blocks are " + skippedKind
                         : blocks.empty() ? "it has no blocks"
                                          : "its blocks have no polygons",
                         "blocks of faces, or " + path + ":PART for the outside of a block that fills space");
    return appended(*append, path, "blocks that can be put together");
}

/// Blocks that are not read because they are no polygons, and nobody asked for them.
void warnOfOthers(const std::vector<PartInfo>& parts, const std::string& path, std::vector<std::string>& warnings)
{
    std::size_t others = 0;
    std::string kind;
    for (const PartInfo& part : parts) {
        if (part.dimension == 2) continue;
        ++others;
        kind = part.type;
    }
    if (others > 0 && others < parts.size())
        warnings.push_back(fmt::format("{}: {} of {} blocks left out: they are not polygons but {}", path, others,
                                       parts.size(), kind));
}

/// All pieces' polygons in one; nothing where they have none. VTK's own reader of parallel files, asked for all pieces
/// at once, mixes up the cells' values where some are strips. `sizes` gets every piece's numbers of points and cells.
vtkSmartPointer<vtkDataObject> readPieces(FileReader& reader, const PieceRun& run, const std::string& path,
                                          const ProgressReport& progress, std::vector<std::uint64_t>& sizes)
{
    vtkNew<vtkAppendPolyData> append;
    int used = 0;
    for (int i = run.begin; i < run.end; ++i) {
        progress("reading the surface", double(i - run.begin) / (run.end - run.begin));
        const auto data = reader.readPiece(i);
        auto* polyData = vtkPolyData::SafeDownCast(data);
        const bool empty = !polyData || polyData->GetNumberOfCells() == 0;
        sizes.push_back(empty ? 0 : std::uint64_t(polyData->GetNumberOfPoints()));
        sizes.push_back(empty ? 0 : std::uint64_t(polyData->GetNumberOfCells()));
        if (empty) continue;
        append->AddInputData(polyData);
        ++used;
    }
    if (used == 0) return vtkSmartPointer<vtkPolyData>::New();
    return appended(*append, path, "pieces that can be put together");
}

/// Which pieces these are, behind the file's name in front of messages.
std::string namePieces(const PieceRun& run)
{
    return run.end - run.begin == 1 ? fmt::format(", piece {}", run.begin)
                                    : fmt::format(", pieces {} to {}", run.begin, run.end - 1);
}

std::vector<ArrayInfo> neededArrays(FileReader& reader, const SurfaceArrays& arrays, const std::string& path)
{
    std::vector<ArrayInfo> needed;
    const std::vector<ArrayInfo>& all = reader.announcedArrays();
    for (const ArrayInfo& array : all)
        if (array.activeNormals || array.name == "Normals") needed.push_back(array);
    if (arrays.wantVectors) needed.push_back(chooseVectors(all, arrays.vectors, path));
    if (!arrays.colorBy.empty())
        if (const auto scalar = findScalar(all, arrays.colorBy, path)) needed.push_back(scalar->array);
    return needed;
}

}  // namespace

LoadedSurface readSurfaceFile(const std::string& path, const SurfaceArrays& arrays, const ProgressReport& progress)
{
    const std::vector<std::uint64_t> pieces = pieceBytesOf(path);  // Before the reader is taken.
    FileReader reader(path, FileReader::Use::surface, arrays.timeInFile);
    reader.keepParts(arrays.parts);
    reader.requireAtTime({arrays.wantVectors ? arrays.vectors : "", arrays.colorBy});
    if (reader.announcesArrays()) reader.keepOnly(neededArrays(reader, arrays, path));
    const bool piece = arrays.part.split();
    const PieceRun run = runOf(arrays.part, arrays.shares.size() == pieces.size() ? arrays.shares : pieces);
    std::vector<std::uint64_t> sizes{pieces.size()};
    const auto data = !pieces.empty()          ? readPieces(reader, run, path, progress, sizes)
                      : !arrays.joined.empty() ? reader.readPieces(runOf(arrays.part, arrays.joined))
                                               : reader.read(progress, "reading the surface");

    std::vector<std::string> warnings;
    if (namedKindHas(path, kHasBlocks) && arrays.parts.empty()) warnOfOthers(reader.parts(), path, warnings);
    vtkSmartPointer<vtkPolyData> polyData = vtkPolyData::SafeDownCast(data);
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data)) {
        polyData = appendBlocks(blocksOf(*blocks), !arrays.parts.empty(), path);
    } else if (!arrays.parts.empty() && arrays.joined.empty()) {
        throw InputError(path, fmt::format("no part '{}': it is all one", arrays.parts.front()),
                         "the file's name alone");
    }
    auto* cells = vtkDataSet::SafeDownCast(data);
    if (cells && !polyData && dimensionOfCells(*cells) == 2) polyData = outerSurface(*cells, path);
    if (!polyData)
        throw InputError(path,
                         "it holds " + kindOf(*data) +
                             (cells && cells->GetNumberOfCells() > 0 ? ", which is a field, not a surface" : ""),
                         "polygons (cut a surface out with --field " + path + " --surface boundary)");
    SurfaceArrays chosen = arrays;
    if (arrays.wantVectors && arrays.vectors.empty() && reader.announcesArrays())
        // What is active was decided before the others were left out.
        chosen.vectors = chooseVectors(reader.announcedArrays(), arrays.vectors, path).name;
    LoadedSurface surface =
        meshFromPolyData(*polyData, path, chosen, false, piece && !pieces.empty() ? namePieces(run) : "");
    // A rank interpolates its own pieces, so a surface cut into other pieces counts as another one. That holds for a
    // rank with all pieces too: any number of ranks must draw the same.
    if (!pieces.empty()) surface.topology = withNumbers(surface.topology, sizes);
    surface.timeSteps = reader.timeSteps();
    if (reader.announcesArrays()) {
        surface.arrays = listArrays(reader.announcedArrays());
        surface.offered = offeredArrays(reader.announcedArrays());
        // A piece may be empty, and then has no arrays to go by.
        if (const auto scalar = piece && !arrays.colorBy.empty()
                                    ? findScalar(reader.announcedArrays(), arrays.colorBy, path)
                                    : std::nullopt)
            tellColors(*scalar, surface);
    }
    surface.warnings.insert(surface.warnings.begin(), warnings.begin(), warnings.end());
    return surface;
}

}  // namespace aeolic
