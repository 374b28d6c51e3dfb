#include <utility>
#include <vector>

#include "aeolic/error.h"
#include "data/builtin/surfaces.h"
#include "data/load/load_steps.h"
#include "data/load/surface_message.h"
#include "data/named_file.h"
#include "data/vtk/memory/memory_surface.h"
#include "data/vtk/surface/surface_file.h"

/// How StepReader reads surfaces.
namespace aeolic {
namespace {

/// The vectors lead the other way.
void turnRound(LoadedSurface& surface)
{
    for (std::vector<glm::vec3>* vectors : {&surface.mesh.pointVectors, &surface.mesh.cellVectors})
        for (glm::vec3& vector : *vectors) vector = -vector;
    if (needsNormal(surface.ofVectors))
        surface.scalarLabel = labelOf(reversedName(surface.vectorsName), surface.ofVectors);
    if (!surface.vectorsName.empty()) surface.vectorsName = reversedName(surface.vectorsName);
}

}  // namespace

/// Only a surface's own vectors are turned round.
void StepReader::requireReversible() const
{
    for (const SurfaceAsk& ask : asks)
        if (ask.fieldVectors && parseSurfaceVectors(description.field.vectors).reversed)
            throw InputError("--vectors", "found '" + description.field.vectors + "' of a field",
                             "reversed(NAME) of vectors that the surface has itself, without --field");
}

SurfaceVectors StepReader::ownVectors(const SurfaceItem& item) const
{
    return parseSurfaceVectors(item.vectors.value_or(description.field.vectors));
}

LoadedSurface StepReader::surface(std::size_t index, double key, const ProgressReport& progress) const
{
    LoadedSurface surface = surfaceAsStored(index, key, progress);
    if (asks[index].ownVectors && ownVectors(sources.surfaces[index].item).reversed) turnRound(surface);
    return surface;
}

LoadedSurface StepReader::surfaceAsStored(std::size_t index, double key, const ProgressReport& progress) const
{
    const auto& [item, spec, track] = sources.surfaces[index];
    const SurfaceAsk& ask = asks[index];
    SurfaceArrays arrays{ask.ownVectors,
                         ownVectors(item).name,
                         ask.colorsFromSurface ? ask.colorBy.name : "",
                         std::nullopt,
                         pieces,
                         shares,
                         {}};
    if (memory.surface) return surfaceFromMemory(*memory.surface, spec.text, arrays);
    if (spec.kind == SurfaceSpec::Kind::file) {
        const StepFile& file = track.file(key);
        arrays.timeInFile = file.timeInFile;
        arrays.parts = file.parts;
        return surfaceFile(file, arrays, progress);
    }
    LoadedSurface surface;
    surface.mesh = makeBuiltinSurface(spec.text, key);
    surface.where = surface.mesh.name;
    surface.arrays = "none";
    return surface;
}

/// Each rank reads its share of a surface that lies in pieces, the first rank one that does not.
LoadedSurface StepReader::surfaceFile(const StepFile& file, SurfaceArrays arrays, const ProgressReport& progress) const
{
    if (!file.others.empty()) return surfaceFiles(file, arrays, progress);
    if (!surfaceReaders.split()) return readSurfaceFile(file.path, arrays, progress);
    SurfacePieces onDisk = piecesOfSurface(file.path, file.parts);
    LoadedSurface surface;
    if (onDisk.lies != Pieces::none) arrays.part = surfaceReaders;
    if (onDisk.lies == Pieces::joined) arrays.joined = std::move(onDisk.bytes);
    if (onDisk.lies != Pieces::none || surfaceReaders.rank == 0) surface = readSurfaceFile(file.path, arrays, progress);
    surface.complete = false;
    surface.lies = onDisk.lies;
    return surface;
}

/// Each rank reads its share of a surface that lies in several files. Where ranks keep pieces, it keeps those it read.
LoadedSurface StepReader::surfaceFiles(const StepFile& file, SurfaceArrays arrays, const ProgressReport& progress) const
{
    const std::vector<std::string> files = file.files();
    std::vector<std::uint64_t> bytes;
    bytes.reserve(files.size());
    for (const std::string& each : files) bytes.push_back(checkReadableFile(each));
    const PieceRun run = runOf(surfaceReaders.split() ? surfaceReaders : pieces, bytes);
    std::vector<LoadedSurface> own;
    for (int i = run.begin; i < run.end; ++i) {
        arrays.part = {i, int(files.size())};
        own.push_back(readSurfaceFile(files[std::size_t(i)], arrays, progress));
    }
    LoadedSurface surface;
    if (own.empty()) {
        surface.piece = true;
        surface.placed = false;
    } else if (surfaceReaders.split() || pieces.split()) {
        surface = appendPieces(std::move(own));
    } else {
        surface = joinPieces(std::move(own));
    }
    surface.complete = !surfaceReaders.split();
    surface.lies = Pieces::apart;
    return surface;
}

void StepReader::complete(LoadedSurface& surface, Agreement& agreement) const
{
    if (!surface.complete) surface = shareSurface(std::move(surface), agreement);
}

}  // namespace aeolic
