#include "engine/backend_together.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <span>

#include "aeolic/error.h"
#include "cluster/comm/agreement.h"
#include "cluster/comm/hosts.h"
#include "data/load/scene_sizes.h"
#include "description/surface_spec.h"
#include "render/cpu/cpu_backend.h"
#include "render/gl/gl_backend.h"

namespace aeolic {
namespace {

/// Collective. Runs `useGpu` on every rank. Where that fails on one of them, all throw; under auto the plan becomes cpu
/// and all return false instead.
bool agreeOn(Communicator& communicator, BackendPlan& plan, const std::function<void()>& useGpu)
{
    if (!plan.realOnly) {
        runTogether(communicator, useGpu);
        return true;
    }
    bool noGpu = false;
    try {
        runTogether(communicator, [&] {
            try {
                useGpu();
            } catch (const gl::NoGpu&) {
                noGpu = true;
                throw;
            }
        });
        return true;
    } catch (const InputError& error) {  // On all ranks.
        plan.unusedGpu = error.what();
    }
    const auto without = communicator.allReduce(std::int64_t(noGpu), Reduction::sum);
    plan.missed = without < communicator.size();  // Nobody expects a GPU where no rank has one.
    plan.choice = BackendChoice::cpu;
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
    BackendPlan plan{description.run.backend, description.run.backend == BackendChoice::automatic, ""};
    if (plan.choice == BackendChoice::cpu) return plan;
    const bool pieces = drawsPieces(description, split);  // All ranks know the same, and so find the same.
    if (pieces && plan.choice == BackendChoice::automatic)
        return {BackendChoice::cpu, false, "a surface in pieces is drawn by processors alone"};
    std::string identity;
    if (!agreeOn(communicator, plan, [&] { identity = gl::deviceIdentity(gpu, plan.realOnly); })) return plan;
    const int ranks = ranksOnDevice(communicator, identity);
    const FieldPart part = split.field ? FieldPart{communicator.rank(), communicator.size()} : FieldPart{};
    agreeOn(communicator, plan,
            [&] { gl::requireRoom(sizesBeforehand(description, part, pieces), gpu, plan.realOnly, ranks); });
    return plan;
}

std::unique_ptr<Backend> makeBackend(Communicator& communicator, BackendPlan& plan, const Scene& scene,
                                     const GpuChoice& gpu)
{
    std::unique_ptr<Backend> backend;
    const bool onGpu = plan.choice != BackendChoice::cpu &&
                       agreeOn(communicator, plan, [&] { backend = gl::makeGlBackend(scene, gpu, plan.realOnly); });
    if (!onGpu) runTogether(communicator, [&] { backend = cpu::makeCpuBackend(scene); });
    plan.choice = onGpu ? BackendChoice::gl : BackendChoice::cpu;
    return backend;
}

bool moveBackend(Communicator& communicator, BackendPlan& plan, const SceneChange& change, Backend& backend)
{
    const auto move = [&] { backend.sceneMoved(change); };
    if (plan.choice == BackendChoice::gl) return agreeOn(communicator, plan, move);
    runTogether(communicator, move);
    return true;
}

}  // namespace aeolic
