#include <algorithm>
#include <utility>

#include "aeolic/error.h"
#include "data/load/load_steps.h"
#include "data/load/scene_facts.h"
#include "data/load/surface_message.h"
#include "data/named_file.h"
#include "data/reading/file_questions.h"
#include "data/vtk/grid/grid_file.h"

namespace aeolic {
namespace {

using Grids = std::vector<std::shared_ptr<GridFile>>;

/// The facts of all pieces: the header says the same of each, and what each counts is added up.
FieldFacts unitedFacts(const Grids& own, Agreement& agreement)
{
    Bytes message;
    agreement.together([&] {
        if (own.empty()) return;
        FieldFacts facts = own.front()->facts();
        for (const auto& piece : own)
            for (const Tally& tally : piece->tallies()) addTally(facts.tallies, tally);
        message = byteMessage(facts);
    });
    FieldFacts all;
    bool found = false;
    for (const Bytes& some : agreement.gatherAll(std::move(message))) {
        if (some.empty()) continue;
        ByteReader reader(some);
        FieldFacts facts;
        reader.read(facts);
        if (std::exchange(found, true))
            for (const Tally& tally : facts.tallies) addTally(all.tallies, tally);
        else
            all = std::move(facts);
    }
    return all;
}

/// Values of cells become those of points, of all cells that meet there.
void uniteOuterMeans(const Grids& own, Agreement& agreement)
{
    Bytes message;
    agreement.together([&] {
        ByteWriter writer;
        for (const auto& piece : own) writer.add(messageOf(piece->outerMeans()));
        message = writer.take();
    });
    const std::vector<Bytes> all = agreement.gatherAll(std::move(message));
    agreement.together([&] {
        std::vector<PointMeans> pieces;
        std::size_t firstOwn = 0;
        for (std::size_t rank = 0; rank < all.size(); ++rank) {
            if (int(rank) == agreement.part().rank) firstOwn = pieces.size();
            ByteReader reader(all[rank]);
            for (std::span<const std::byte> means; !reader.atEnd();) {
                reader.read(means);
                pieces.push_back(meansOf(means));
            }
        }
        uniteMeans(pieces);
        for (std::size_t i = 0; i < own.size(); ++i) own[i]->takeMeans(pieces[firstOwn + i]);
    });
}

/// The bytes of files that are parts of a volume of cells; empty where they may be something else.
std::vector<std::uint64_t> bytesOfParts(const std::vector<std::string>& files)
{
    std::vector<std::uint64_t> bytes;
    const FileKind* kind = fileKindOf(files.front());
    if (!kind || kind->pieces != FilePieces::piece) return bytes;
    for (const std::string& file : files) bytes.push_back(checkReadableFile(file));
    return bytes;
}

}  // namespace

/// No piece can tell the outside of the whole, nor whether data lie on one grid.
std::vector<std::uint64_t> StepReader::piecesOf(const StepFile& file) const
{
    if (part.split() || description.field.resampleSpacing) return {};
    for (const SurfaceTrack& surface : sources.surfaces)
        if (surface.spec.kind == SurfaceSpec::Kind::boundary || surface.spec.kind == SurfaceSpec::Kind::image)
            return {};
    return file.others.empty() ? volumePiecesOf(file.path) : bytesOfParts(file.files());
}

/// Cuts a surface out of all pieces. Collective.
LoadedSurface StepReader::cutPieces(const FieldStep& read, std::size_t index, const FieldFacts& facts,
                                    Agreement& agreement) const
{
    const Grids& own = read.pieces;
    const SurfaceSpec& spec = sources.surfaces[index].spec;
    const CutArrays wanted{asks[index].fieldVectors, asks[index].colorsFromField};
    CutOutline all;
    agreement.together([&] {
        for (const auto& piece : own) all.add(piece->outlineOf(spec));
    });
    uniteBounds(agreement, all.boundsWorld);
    all.range = {agreement.least(all.range[0]), agreement.greatest(all.range[1])};
    all.crossed = std::uint64_t(agreement.sum(std::int64_t(all.crossed)));
    Bytes message;
    agreement.readTogether([&] {
        requireCut(all, spec, read.name, ranksOnHost);
        ByteWriter writer;
        for (std::size_t i = 0; i < own.size(); ++i)
            writer.add(messageOf(own[i]->cutPiece(spec, wanted, all, read.firstPiece + int(i))));
        message = writer.take();
    });
    const std::vector<Bytes> messages = agreement.gatherAll(std::move(message));
    LoadedSurface surface;
    agreement.together([&] {
        std::vector<LoadedSurface> cuts;
        for (const Bytes& some : messages) {
            ByteReader reader(some);
            for (std::span<const std::byte> cut; !reader.atEnd();) {
                reader.read(cut);
                cuts.push_back(surfaceOf(cut));
            }
        }
        surface = joinPieces(std::move(cuts), spec.kind == SurfaceSpec::Kind::isosurface);
        requirePolygons(surface.mesh.triangles.size(), all, spec, read.name);
        surface.topology = withPlaces(surface.topology, surface.mesh);
        surface.mesh.name = spec.text;
        surface.arrays = facts.arrays;
        surface.offered = facts.offered;
    });
    return surface;
}

/// The step of what all ranks have read. Collective.
FieldStep StepReader::unitePieces(const FieldStep& read, Agreement& agreement) const
{
    const Grids& own = read.pieces;
    FieldStep step;
    static_cast<FieldFacts&>(step) = unitedFacts(own, agreement);
    step.name = read.name;
    const auto isEmpty = [](const auto& piece) { return piece->empty(); };
    const bool empty = agreement.all(std::ranges::all_of(own, isEmpty));
    agreement.together([&] {
        if (empty) throw InputError(step.name, "no cells in any of its pieces", "a grid with cells");
        nameShear(step);
        requireColors(step);
    });
    uniteOuterMeans(own, agreement);

    bool looksUp = false;
    step.cuts.resize(asks.size());
    for (std::size_t i = 0; i < asks.size(); ++i) {
        const SurfaceSpec& spec = sources.surfaces[i].spec;
        if (!spec.isCut()) {
            looksUp = looksUp || asks[i].fieldVectors || asks[i].colorsFromField;
            continue;
        }
        agreement.together([&] { requireNoShear(i); });
        step.cuts[i] = cutPieces(read, i, step, agreement);
    }
    if (!looksUp) return step;
    std::vector<std::shared_ptr<const CellVolume>> cells;
    const auto hasCells = [](const auto& piece) { return piece->hasCells(); };
    const bool flat = !agreement.any(std::ranges::any_of(own, hasCells));
    agreement.readTogether([&] {
        for (const auto& piece : own)
            if (flat || piece->hasCells()) cells.push_back(piece->takeCells());
    });
    step.cells = dealtVolume(std::move(cells), !agreement.part().split(), step.name, agreement);
    return step;
}

}  // namespace aeolic
