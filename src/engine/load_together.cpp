#include "engine/load_together.h"

#include <fmt/format.h>

#include <optional>

#include "base/memory.h"
#include "cluster/comm/agreement.h"
#include "cluster/composite/deal_triangles.h"
#include "data/fingerprint.h"
#include "engine/unify.h"

namespace aeolic {
namespace {

// Reading needs some more than what is kept: conversions, the file's own cache.
constexpr double kReadingOverhead = 1.3;

bool splitsField(Communicator& communicator, const SceneDescription& description, int ranksOnHost)
{
    if (communicator.size() == 1 || description.run.bricks == BrickChoice::off) return false;
    if (description.run.bricks == BrickChoice::on) return true;
    bool tooLarge = false;
    runTogether(communicator, [&] {
        const double needed = kReadingOverhead * double(fieldBytesOf(description)) * ranksOnHost;
        tooLarge = needed > double(availableMemoryBytes());
    });
    return communicator.allReduce(std::int64_t(tooLarge), Reduction::max) > 0;
}

/// Whether the surface is read in pieces. A GPU draws none, but bricks of a field on a surface that every rank holds.
bool splitsSurface(Communicator& communicator, const SceneDescription& description, bool splitField, int ranksOnHost)
{
    if (communicator.size() == 1 || description.run.bricks == BrickChoice::off) return false;
    std::uint64_t bytes = 0;
    runTogether(communicator, [&] { bytes = pieceFileBytesOf(description); });
    if (bytes == 0 || (splitField && !description.field.spec.empty() && description.run.backend == BackendChoice::gl))
        return false;
    if (description.run.bricks == BrickChoice::on) return true;
    const double needed = kReadingOverhead * double(bytes) * ranksOnHost;
    return communicator.allReduce(std::int64_t(needed > double(availableMemoryBytes())), Reduction::max) > 0;
}

/// A field but for its samples.
GridField gridOf(const GridField& field)
{
    GridField grid = field;
    grid.samples = nullptr;
    return grid;
}

bool sameBricks(const GridField& a, const GridField& b)
{
    return a.dims == b.dims && a.originWorld == b.originWorld && a.spacingWorld == b.spacingWorld;
}

}  // namespace

SceneChange moveTogether(Communicator& communicator, SceneSteps& steps, double moment, Scene& scene, Progress progress,
                         void* context)
{
    bool loaded = false;
    SceneChange change;
    std::optional<GridField> dealtBy;
    if (steps.dealsToBricks()) dealtBy = gridOf(*scene.field);
    runTogether(communicator, [&] { loaded = steps.prepare(moment, {progress, context}); });
    if (scene.inPieces) makePieces(communicator, steps, scene);
    runTogether(communicator, [&] { change = steps.show(scene); });
    if (scene.inPieces && change.surface)
        scene.allTriangles = std::uint64_t(communicator.allReduce(std::int64_t(scene.allTriangles), Reduction::sum));
    if (dealtBy && (change.surface || !sameBricks(*dealtBy, *scene.field))) {
        scene.surface =
            dealToBricks(communicator, std::move(scene.surface), *scene.field, change.surface ? nullptr : &*dealtBy);
        change.surface = change.triangles = true;
    }
    // Which steps are loaded follows from the moments asked for so far, but where a rank failed to read one of them.
    if (communicator.allReduce(std::int64_t(loaded), Reduction::max) > 0 && communicator.size() > 1)
        requireSame(communicator, fmt::format("the scene's data at time {}", moment), fingerprint(scene));
    return change;
}

Split splitOf(Communicator& communicator, const SceneDescription& description, int ranksOnHost)
{
    Split split;
    split.field = splitsField(communicator, description, ranksOnHost);
    split.surface = splitsSurface(communicator, description, split.field, ranksOnHost);
    if (description.field.spec.empty() && split.surface) split.field = false;
    return split;
}

Scene loadTogether(Communicator& communicator, const SceneDescription& description, int ranksOnHost, Progress progress,
                   void* context, std::unique_ptr<SceneSteps>* kept)
{
    return loadSplit(communicator, description, splitOf(communicator, description, ranksOnHost), progress, context,
                     kept);
}

Scene loadSplit(Communicator& communicator, const SceneDescription& description, const Split& split, Progress progress,
                void* context, std::unique_ptr<SceneSteps>* kept)
{
    const FieldPart whole, mine{communicator.rank(), communicator.size()};
    std::unique_ptr<SceneSteps> steps;
    Scene scene;
    PieceFacts facts;
    runTogether(communicator, [&] {
        steps = std::make_unique<SceneSteps>(description, split.field ? mine : whole, split.surface ? mine : whole);
        facts = steps->readPieces({progress, context});
    });
    if (split.surface) facts = unified(communicator, facts);
    runTogether(communicator, [&] { scene = steps->first({progress, context}, facts); });
    if (scene.inPieces) unifyPieces(communicator, *steps, scene);
    if (split.field && split.surface) {
        scene.surface = dealToBricks(communicator, std::move(scene.surface), *scene.field);
        measure(scene);
    }
    if (split.field || split.surface) {
        unifyRanges(communicator, scene);
        scene.tallies = added(communicator, scene.tallies);
        scene.warnings = distinctOfAll(communicator, scene.warnings);
    }
    if (steps->moves() && atRest(scene)) {
        moveTogether(communicator, *steps, steps->times().back(), scene, progress, context);
        measure(scene);
        if (split.field || split.surface) unifyRanges(communicator, scene);
    }
    finishScene(scene);
    requireSame(communicator, "the scene's data", fingerprint(scene));
    if (steps->moves())
        moveTogether(communicator, *steps, startOf(description, steps->times()), scene, progress, context);
    if (kept) *kept = std::move(steps);
    return scene;
}

}  // namespace aeolic
