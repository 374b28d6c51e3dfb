#include "pipeline/load_together.h"

#include <fmt/format.h>

#include <limits>

#include "base/memory.h"
#include "cluster/agreement.h"
#include "data/fingerprint.h"

namespace aeolic {
namespace {

// Reading needs some more than what is kept: conversions, the file's own cache.
constexpr double kReadingOverhead = 1.3;

bool splitsField(Communicator& communicator, const SceneDescription& description, int ranksOnHost)
{
    if (communicator.size() == 1 || description.run.bricks == "off") return false;
    if (description.run.bricks == "on") return true;
    bool tooLarge = false;
    runTogether(communicator, [&] {
        const double needed = kReadingOverhead * double(fieldBytesOf(description)) * ranksOnHost;
        tooLarge = needed > double(availableMemoryBytes());
    });
    return communicator.allReduce(std::int64_t(tooLarge), Reduction::max) > 0;
}

/// Ranges of all bricks together. Minima and maxima: the same bits as of the whole.
void unify(Communicator& communicator, Scene& scene)
{
    const double infinity = std::numeric_limits<double>::infinity();
    scene.maxVector = communicator.allReduce(scene.maxVector, Reduction::max);
    auto& [lo, hi] = scene.scalarRange;
    const double least = communicator.allReduce(scene.scalarRangeKnown ? lo : infinity, Reduction::min);
    const double greatest = communicator.allReduce(scene.scalarRangeKnown ? hi : -infinity, Reduction::max);
    scene.scalarRangeKnown = least <= greatest;
    if (scene.scalarRangeKnown) scene.scalarRange = {least, greatest};
}

}  // namespace

SceneChange moveTogether(Communicator& communicator, SceneSteps& steps, double moment, Scene& scene, Progress progress,
                         void* context)
{
    bool loaded = false;
    SceneChange change;
    runTogether(communicator, [&] { loaded = steps.prepare(moment, {progress, context}); });
    runTogether(communicator, [&] { change = steps.show(scene); });
    // Which steps are loaded follows from the moments asked for so far: the same on all ranks.
    if (loaded && communicator.size() > 1)
        requireSame(communicator, fmt::format("the scene's data at time {}", moment), fingerprint(scene));
    return change;
}

Scene loadTogether(Communicator& communicator, const SceneDescription& description, int ranksOnHost, Progress progress,
                   void* context, std::unique_ptr<SceneSteps>* kept)
{
    const bool split = splitsField(communicator, description, ranksOnHost);
    const FieldPart part = split ? FieldPart{communicator.rank(), communicator.size()} : FieldPart{};
    std::unique_ptr<SceneSteps> steps;
    Scene scene;
    runTogether(communicator, [&] {
        steps = std::make_unique<SceneSteps>(description, part);
        scene = steps->first({progress, context});
    });
    if (split) unify(communicator, scene);
    if (steps->moves() && atRest(scene)) {
        moveTogether(communicator, *steps, steps->times().back(), scene, progress, context);
        measure(scene);
        if (split) unify(communicator, scene);
    }
    finishScene(scene);
    requireSame(communicator, "the scene's data", fingerprint(scene));
    if (steps->moves())
        moveTogether(communicator, *steps, startOf(description, steps->times()), scene, progress, context);
    if (kept) *kept = std::move(steps);
    return scene;
}

}  // namespace aeolic
