#include "data/load/split.h"

#include "aeolic/error.h"
#include "data/load/memory_model.h"
#include "data/load/scene_sizes.h"
#include "description/scene_surfaces.h"

namespace aeolic {

namespace {

/// Several surfaces are drawn by every rank, but isosurfaces of a field in bricks come in pieces.
void requireWhole(const SceneDescription& description, bool splitField)
{
    for (const SurfaceItem& item : surfacesOf(description))
        if (splitField && parseSurfaceSpec(item.spec).kind == SurfaceSpec::Kind::isosurface)
            throw InputError("surface '" + item.spec + "'", "found among several, with the field in bricks",
                             "it alone, or --bricks off");
}

}  // namespace

Split splitOf(const SceneDescription& description, Agreement& agreement, int ranksOnHost, const Data& memory)
{
    Split split;
    split.ranksOnHost = ranksOnHost;
    split.surface = agreement.part().split() && memory.surface;
    if (!agreement.part().split() || description.run.bricks == BrickChoice::off) return split;
    const bool always = description.run.bricks == BrickChoice::on, hasField = !description.field.spec.empty();
    std::uint64_t pieceBytes = 0;
    bool splitField = always && !memory.hasField(), splitSurface = always;
    // What one rank of a host finds, holds for the others: they share its files and its memory.
    agreement.readTogether([&] {
        if (!agreement.isFirstOnHost()) return;
        if (!memory.hasField() && !always) splitField = !hasMemoryToRead(fieldBytesOf(description), ranksOnHost);
        if (!memory.surface) pieceBytes = pieceFileBytesOf(description);
        if (!always) splitSurface = !hasMemoryToRead(pieceBytes, ranksOnHost);
    });
    if (!memory.surface) agreement.together([&] { requireListOfPieces(description); });
    split.field = agreement.any(splitField);
    if (description.surfaces.size() > 1) {
        agreement.together([&] { requireWhole(description, split.field); });
        return split;
    }
    if (!memory.surface) split.surface = agreement.any(splitSurface) && agreement.any(pieceBytes > 0);
    // A GPU draws no pieces, but bricks of a field on a surface that every rank holds.
    if (split.field && hasField && !memory.surface && description.run.backend == BackendChoice::gl)
        split.surface = false;
    if (split.surface && !hasField) split.field = false;
    return split;
}

}  // namespace aeolic
