#include "engine/backend_together.h"

#include <functional>
#include <span>

#include "aeolic/error.h"
#include "cluster/comm/hosts.h"
#include "cluster/comm/together.h"
#include "data/load/scene_sizes.h"
#include "description/scene_surfaces.h"

namespace aeolic {
namespace {

/// Collective. Uses the plan's kind on every rank. Where that fails on one of them, all throw if there is no other
/// kind; else the plan goes on to the next, and all return false.
bool agreeOn(Communicator& communicator, BackendPlan& plan, const std::function<void()>& use)
{
    if (plan.kinds.size() == 1) {
        runTogether(communicator, use);
        return true;
    }
    bool noDevice = false;
    try {
        runTogether(communicator, [&] {
            try {
                use();
            } catch (const NoDevice&) {
                noDevice = true;
                throw;
            }
        });
        return true;
    } catch (const InputError& error) {  // On all ranks.
        plan.unusedGpu = error.what();
    }
    const auto without = communicator.allReduce(std::int64_t(noDevice), Reduction::sum);
    plan.missed = without < communicator.size();  // Nobody expects a GPU where no rank has one.
    plan.kinds.erase(plan.kinds.begin());
    return false;
}

/// Collective. How many ranks draw on the device that this one draws on, itself included.
int ranksOnDevice(Communicator& communicator, const std::string& identity)
{
    const std::string mine = identity.empty() ? "" : placeOfThisProcess().host + '\n' + identity;
    int ranks = 0;
    for (const Bytes& bytes : communicator.allGather(std::as_bytes(std::span(mine))))
        ranks += std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()) == mine;
    return mine.empty() ? 1 : ranks;
}

/// The sizes at every step shown, by the headers of the files. An error in a file is reported later, when it is read.
std::vector<SceneSizes> sizesBeforehand(const SceneDescription& description, const FieldPart& part, bool inPieces)
{
    std::vector<SceneSizes> steps;
    try {
        forEachStepShown(description, part, [&](const SceneSizes& sizes) {
            steps.push_back(sizes);
            steps.back().inPieces = inPieces;
        });
    } catch (const InputError&) {
    }
    if (steps.empty()) steps.emplace_back().inPieces = inPieces;
    return steps;
}

bool drawsPieces(const SceneDescription& description, const Split& split)
{
    if (split.surface) return true;
    return split.field && parseSurfaceSpec(surfacesOf(description).front().spec).kind == SurfaceSpec::Kind::isosurface;
}

}  // namespace

BackendPlan planBackend(Communicator& communicator, const SceneDescription& description, const Split& split,
                        const GpuChoice& gpu)
{
    const bool isAuto = description.run.backend == BackendChoice::automatic;
    BackendPlan plan{kindsOf(description.run.backend), {gpu, isAuto}, ""};
    if (isAuto && !plan.kind().needsDevice()) plan.unusedGpu = "this build draws on processors alone";
    const bool pieces = drawsPieces(description, split);  // All ranks know the same, and so find the same.
    while (isAuto && pieces && !plan.kind().drawsPieces) {
        plan.kinds.erase(plan.kinds.begin());
        plan.unusedGpu = "a surface in pieces is drawn by processors alone";
    }
    const FieldPart part = split.field ? FieldPart{communicator.rank(), communicator.size()} : FieldPart{};
    while (plan.kind().needsDevice()) {
        std::string identity;
        if (!agreeOn(communicator, plan, [&] { identity = plan.kind().identity(plan.request); })) continue;
        const int ranks = ranksOnDevice(communicator, identity);
        const auto fits = [&] {
            plan.kind().requireRoom(sizesBeforehand(description, part, pieces), plan.request, ranks);
        };
        if (agreeOn(communicator, plan, fits)) break;
    }
    return plan;
}

std::unique_ptr<Backend> makeBackend(Communicator& communicator, BackendPlan& plan, const Scene& scene)
{
    std::unique_ptr<Backend> backend;
    while (!agreeOn(communicator, plan, [&] { backend = plan.kind().make(scene, plan.request); })) {
    }
    return backend;
}

bool moveBackend(Communicator& communicator, BackendPlan& plan, const SceneChange& change, Backend& backend)
{
    return agreeOn(communicator, plan, [&] { backend.sceneMoved(change); });
}

}  // namespace aeolic
