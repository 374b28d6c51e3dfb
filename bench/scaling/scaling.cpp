#include "scaling/scaling.h"

#include <tbb/info.h>

#include <algorithm>
#include <filesystem>

#include "aeolic/error.h"
#include "base/memory.h"
#include "data/builtin/flows.h"
#include "data/builtin/surfaces.h"
#include "data/load/loaded_scene.h"
#include "data/load/scene_sizes.h"
#include "description/choices.h"
#include "description/validate.h"
#include "render/backend.h"
#include "render/picture_memory.h"
#include "scaling/costs.h"
#include "scaling/rows.h"
#include "scaling/samples.h"

namespace aeolic {
namespace {

struct PartSetup {
    ScalingPart part;
    ScalingSetup setup;
};

bool wants(const ScalingBenchPlan& plan, ScalingPart part)
{
    return std::find(plan.parts.begin(), plan.parts.end(), part) != plan.parts.end();
}

SceneDescription withField(SceneDescription scene, const std::string& field)
{
    if (field == scene.field.spec) return scene;
    const FieldPrecision precision = scene.field.precision;
    scene.field = {};
    scene.field.spec = field;
    scene.field.precision = precision;
    scene.shading.colorBy.clear();  // It named an array of the other field.
    return scene;
}

std::vector<PartSetup> setupsOf(const ScalingBenchPlan& plan)
{
    SceneDescription whole = plan.scene;
    whole.run.backend = BackendChoice::cpu;  // What is measured is CPU time.
    whole.run.bricks = BrickChoice::off;
    if (plan.fillWide) whole.camera = filling(whole.camera, whole.output.width, whole.output.height);
    std::vector<PartSetup> setups;
    if (wants(plan, ScalingPart::nodes)) {
        setups.push_back({ScalingPart::nodes, {{whole}, 1, {"static"}, plan.repeats, false}});
        for (const int ranks : plan.ranks)
            if (ranks > 1) setups.push_back({ScalingPart::nodes, {{whole}, ranks, plan.balancers, plan.repeats, true}});
    }
    const int most = *std::max_element(plan.ranks.begin(), plan.ranks.end());
    if (most < 2) return setups;
    SceneDescription bricked = whole;
    bricked.run.bricks = BrickChoice::on;
    const SceneDescription large = withField(bricked, plan.largeField);
    if (wants(plan, ScalingPart::bricks)) {
        std::vector<SceneDescription> scenes{large};
        if (!bricked.field.spec.empty()) scenes = {whole, bricked, large};
        setups.push_back({ScalingPart::bricks, {scenes, most, plan.balancers, plan.repeats, false}});
    }
    if (wants(plan, ScalingPart::mesh)) {
        SceneDescription mesh = large;
        mesh.surface = {};
        mesh.surface.spec = plan.mesh;
        setups.push_back({ScalingPart::mesh, {{mesh}, most, plan.balancers, plan.repeats, false}});
    }
    return setups;
}

/// The lines of tables that were measured together.
std::vector<ScalingRow> rowsOf(const PartSetup& from, const std::vector<ScalingSamples>& samples,
                               const NetworkModel& network)
{
    std::vector<ScalingRow> rows;
    for (std::size_t i = 0; i < samples.size(); ++i)
        for (std::size_t b = 0; b < from.setup.balancers.size(); ++b) {
            const SceneDescription& scene = from.setup.scenes[i];
            ScalingRow& row = rows.emplace_back(measuredRow(samples[i], b, network));
            row.part = from.part;
            row.surface = scene.surface.spec;
            row.field = scene.field.spec;
            row.bricked = scene.run.bricks == BrickChoice::on;
            row.ranks = from.setup.ranks;
            row.balance = from.setup.balancers[b];
            if (i > 0) row.slowdown = slowdown(samples[i].of[b], samples[i - 1].of[b], network);
        }
    return rows;
}

/// Finds what would end a measurement of minutes before it begins.
void checkParts(const ScalingBenchPlan& plan, const std::vector<PartSetup>& setups)
{
    for (const PartSetup& from : setups) {
        if (from.part == ScalingPart::nodes) continue;
        std::uint64_t bytes = 0;
        for (const SceneDescription& scene : from.setup.scenes) bytes += fieldBytesOf(scene);
        if (bytes > 0) requireMemory("--large-field", from.setup.scenes.back().field.spec, bytes);
    }
    if (!wants(plan, ScalingPart::mesh)) return;
    if (isBuiltinSurface(plan.mesh))
        makeBuiltinSurface(plan.mesh);
    else if (!std::filesystem::exists(plan.mesh))
        throw InputError("--mesh", "found " + inQuotes(plan.mesh), "a surface file or a built-in surface");
}

/// Every rank has memory for its stripe and its guard, for each of the scenes that it draws in turn. Together that is a
/// few pictures a scene, even with long traces.
void requireImageMemory(const ScalingBenchPlan& plan, const std::vector<PartSetup>& setups)
{
    const OutputOptions& output = plan.scene.output;
    std::uint64_t pictures = 0;
    for (const PartSetup& from : setups)
        pictures = std::max(pictures, std::uint64_t(std::min(from.setup.ranks, 4)) * from.setup.scenes.size());
    requireMemory("--size", std::to_string(output.width) + "x" + std::to_string(output.height),
                  pictureBytes(output.width, output.height) * pictures);
}

std::string titleOf(const SceneDescription& scene, int ranks)
{
    return scene.surface.spec + " in " + (scene.field.spec.empty() ? "its own vectors" : scene.field.spec) +
           (scene.run.bricks == BrickChoice::on ? " in bricks, ranks: " : ", ranks: ") + std::to_string(ranks);
}

bool isWhole(const SceneDescription& scene)
{
    return scene.run.bricks == BrickChoice::off;
}

/// Measures setup after setup, and tells how far the whole is.
class Measurement {
public:
    Measurement(const ScalingBenchPlan& plan, const Watch<ScalingBench>& watch)
        : plan_(plan), watch_(watch), setups_(setupsOf(plan)), cores_(tbb::info::default_concurrency())
    {
        requireImageMemory(plan, setups_);
        checkParts(plan, setups_);
        for (const PartSetup& from : setups_) framesInAll_ += framesOf(from);
    }

    ScalingBench run()
    {
        ScalingBench bench;
        bench.cores = cores_;
        nameMachine(bench);
        if (!setups_.empty() && isWhole(setups_.front().setup.scenes.front())) {
            watch_.tell("loading", 0);
            scene_ = loadScene(setups_.front().setup.scenes.front());
            bench.warnings = scene_.warnings;
        }
        watch_.show(bench);
        std::vector<ScalingSamples> nodes;
        for (std::size_t i = 0; i < setups_.size(); ++i) {
            const PartSetup& from = setups_[i];
            const std::vector<ScalingSamples> samples = measure(from);
            for (ScalingRow& row : rowsOf(from, samples, plan_.network)) bench.rows.push_back(std::move(row));
            if (from.part == ScalingPart::nodes) nodes.push_back(samples.front());
            const bool nodesFollow = i + 1 < setups_.size() && setups_[i + 1].part == ScalingPart::nodes;
            if (from.part == ScalingPart::nodes && !nodesFollow) {
                bench.steadiness = steadiness(nodes, plan_.network);
                bench.costs = fitCosts(framesOf(nodes), plan_.scene.output.width);
            }
            watch_.show(bench);
        }
        if (plan_.simulate && bench.costs) simulate(bench);
        return bench;
    }

private:
    int framesOf(const PartSetup& from) const
    {
        return int(from.setup.balancers.size() * from.setup.scenes.size()) * (plan_.scene.output.frames + kJumps);
    }

    std::vector<ScalingSamples> measure(const PartSetup& from)
    {
        const auto titleOfScene = [&](std::size_t i) { return titleOf(from.setup.scenes[i], from.setup.ranks); };
        watch_.tell(titleOfScene(0), double(framesDone_) / framesInAll_);
        return drawOnRanks(from.setup, scene_, cores_,
                           [&](std::size_t i) { watch_.tell(titleOfScene(i), double(++framesDone_) / framesInAll_); });
    }

    static std::vector<RanksOfFrame> framesOf(const std::vector<ScalingSamples>& nodes)
    {
        std::vector<RanksOfFrame> frames;
        for (const ScalingSamples& samples : nodes) {
            frames.insert(frames.end(), samples.alone.begin(), samples.alone.end());
            for (const BalancerSamples& of : samples.of)
                frames.insert(frames.end(), of.rotation.begin(), of.rotation.end());
        }
        return frames;
    }

    void simulate(ScalingBench& bench) const
    {
        SimulationPlan plan;
        plan.scene = setups_.front().setup.scenes.front();
        plan.balancers = plan_.balancers;
        plan.network = plan_.network;
        plan.costs = *bench.costs;
        const auto inSize = [&](int width, int height) {
            watch_.tell("simulating", 1);
            plan.width = width;
            plan.height = height;
            bench.simulations.push_back(simulateScaling(plan, scene_));
            watch_.show(bench);
        };
        inSize(plan_.scene.output.width, plan_.scene.output.height);
        plan.scene.camera = plan_.scene.camera;  // That picture is square, so that nothing is filled.
        inSize(kSimulatedSize, kSimulatedSize);
    }

    /// Makes a backend for nothing but its names.
    static void nameMachine(ScalingBench& bench)
    {
        const Scene nothing;
        const auto backend = makeBackend(BackendChoice::cpu, nothing);
        bench.backend = backend->name();
        bench.device = backend->device();
        bench.simd = backend->simd();
    }

    const ScalingBenchPlan& plan_;
    const Watch<ScalingBench>& watch_;
    std::vector<PartSetup> setups_;
    int cores_, framesInAll_ = 0, framesDone_ = 0;
    Scene scene_;  // Loaded whole where the first setup draws it so.
};

}  // namespace

const ScalingRow* ScalingBench::oneRank() const
{
    for (const ScalingRow& row : rows)
        if (row.part == ScalingPart::nodes && row.ranks == 1) return &row;
    return nullptr;
}

std::string defaultLargeField(const std::string& field)
{
    return (isBuiltinFlow(field) ? field.substr(0, field.find(':')) : "abc") + ":512,512,512";
}

ScalingBench benchScaling(const ScalingBenchPlan& plan, const Watch<ScalingBench>& watch)
{
    validate(plan.scene, commandLineName);
    return Measurement(plan, watch).run();
}

}  // namespace aeolic
