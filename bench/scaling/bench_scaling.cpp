#include "scaling/bench_scaling.h"

#include <tbb/info.h>

#include <algorithm>
#include <filesystem>

#include "aeolic/error.h"
#include "base/memory.h"
#include "common/bench_camera.h"
#include "data/builtin/flows.h"
#include "data/builtin/surfaces.h"
#include "data/scene.h"
#include "description/scene_fields.h"
#include "description/validate.h"
#include "render/backend.h"
#include "scaling/cost_fit.h"
#include "scaling/scaling_rows.h"
#include "scaling/scaling_run.h"

namespace aeolic {
namespace {

constexpr std::uint64_t kBytesPerPixel = 96;  // As the renderer reckons: G-buffer, LIC levels and picture together.

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
    const std::string precision = scene.field.precision;
    scene.field = {};
    scene.field.spec = field;
    scene.field.precision = precision;
    scene.shading.colorBy.clear();  // Named an array of the other one.
    return scene;
}

std::vector<PartSetup> setupsOf(const ScalingBenchPlan& plan)
{
    SceneDescription whole = plan.scene;
    whole.run.backend = "cpu";  // What is measured is CPU time.
    whole.run.bricks = "off";
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
    bricked.run.bricks = "on";
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
            row.bricked = scene.run.bricks == "on";
            row.ranks = from.setup.ranks;
            row.balance = from.setup.balancers[b];
            if (i > 0) row.slowdown = slowdown(samples[i].of[b], samples[i - 1].of[b], network);
        }
    return rows;
}

/// Before anything is measured: what would end a measurement of minutes.
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

/// Every rank has its stripe and what its guard needs, of each scene that is drawn in turn with others; a few pictures'
/// worth even with long traces.
void requireImageMemory(const ScalingBenchPlan& plan, const std::vector<PartSetup>& setups)
{
    const OutputOptions& output = plan.scene.output;
    std::uint64_t pictures = 0;
    for (const PartSetup& from : setups)
        pictures = std::max(pictures, std::uint64_t(std::min(from.setup.ranks, 4)) * from.setup.scenes.size());
    requireMemory("--size", std::to_string(output.width) + "x" + std::to_string(output.height),
                  std::uint64_t(output.width) * std::uint64_t(output.height) * kBytesPerPixel * pictures);
}

std::string titleOf(const SceneDescription& scene, int ranks)
{
    return scene.surface.spec + " in " + (scene.field.spec.empty() ? "its own vectors" : scene.field.spec) +
           (scene.run.bricks == "on" ? " in bricks, ranks: " : ", ranks: ") + std::to_string(ranks);
}

bool isWhole(const SceneDescription& scene)
{
    return scene.run.bricks == "off";
}

/// Measures setup after setup, and tells how far all of it is.
class Measurement {
public:
    Measurement(const ScalingBenchPlan& plan, const BenchProgress& progress)
        : plan_(plan), progress_(progress), setups_(setupsOf(plan)), cores_(tbb::info::default_concurrency())
    {
        requireImageMemory(plan, setups_);
        checkParts(plan, setups_);
        for (const PartSetup& from : setups_) framesInAll_ += framesOf(from);
    }

    ScalingBench run()
    {
        ScalingBench bench;
        bench.cores = cores_;
        if (!setups_.empty() && isWhole(setups_.front().setup.scenes.front())) {
            tell("loading", 0);
            scene_ = loadScene(setups_.front().setup.scenes.front());
            bench.warnings = scene_.warnings;
        }
        std::vector<std::vector<ScalingSamples>> samples;
        for (const PartSetup& from : setups_) samples.push_back(measure(from));
        if (measuresNodes()) {
            std::vector<ScalingSamples> nodes;
            for (std::size_t i = 0; i < setups_.size(); ++i)
                if (setups_[i].part == ScalingPart::nodes) nodes.push_back(samples[i].front());
            bench.steadiness = steadiness(nodes, plan_.network);
            // One rank's row is of all its pictures, whenever they were drawn.
            std::vector<RanksOfFrame>& alone = samples.front().front().of.front().rotation;
            for (const ScalingSamples& of : nodes) alone.insert(alone.end(), of.alone.begin(), of.alone.end());
            fit(nodes, bench);
        }
        for (std::size_t i = 0; i < setups_.size(); ++i)
            for (ScalingRow& row : rowsOf(setups_[i], samples[i], plan_.network)) bench.rows.push_back(std::move(row));
        nameMachine(bench);
        return bench;
    }

private:
    bool measuresNodes() const { return !setups_.empty() && setups_.front().part == ScalingPart::nodes; }

    int framesOf(const PartSetup& from) const
    {
        return int(from.setup.balancers.size() * from.setup.scenes.size()) * (plan_.scene.output.frames + kJumps);
    }

    void tell(const std::string& what, double fraction) const
    {
        if (progress_) progress_(what, fraction);
    }

    std::vector<ScalingSamples> measure(const PartSetup& from)
    {
        const auto titleOfScene = [&](std::size_t i) { return titleOf(from.setup.scenes[i], from.setup.ranks); };
        tell(titleOfScene(0), double(framesDone_) / framesInAll_);
        return drawOnRanks(from.setup, scene_, cores_,
                           [&](std::size_t i) { tell(titleOfScene(i), double(++framesDone_) / framesInAll_); });
    }

    void fit(const std::vector<ScalingSamples>& nodes, ScalingBench& bench) const
    {
        std::vector<RanksOfFrame> frames;
        for (const ScalingSamples& samples : nodes) {
            frames.insert(frames.end(), samples.alone.begin(), samples.alone.end());
            for (const BalancerSamples& of : samples.of)
                frames.insert(frames.end(), of.rotation.begin(), of.rotation.end());
        }
        const OutputOptions& output = plan_.scene.output;
        bench.costs = fitCosts(frames, output.width);
        if (!plan_.simulate) return;
        SimulationPlan plan;
        plan.scene = setups_.front().setup.scenes.front();
        plan.width = output.width;
        plan.height = output.height;
        plan.balancers = plan_.balancers;
        plan.network = plan_.network;
        plan.costs = bench.costs;
        tell("simulating", 1);
        bench.simulations.push_back(simulateScaling(plan, scene_));
        plan.scene.camera = plan_.scene.camera;  // Of a square picture.
        plan.width = plan.height = kSimulatedSize;
        bench.simulations.push_back(simulateScaling(plan, scene_));
    }

    /// By a backend for nothing but that.
    static void nameMachine(ScalingBench& bench)
    {
        const Scene nothing;
        const auto backend = makeBackend("cpu", nothing);
        bench.backend = backend->name();
        bench.device = backend->device();
        bench.simd = backend->simd();
    }

    const ScalingBenchPlan& plan_;
    const BenchProgress& progress_;
    std::vector<PartSetup> setups_;
    int cores_, framesInAll_ = 0, framesDone_ = 0;
    Scene scene_;  // Whole; where any setup draws it so.
};

}  // namespace

const ScalingRow* ScalingBench::reference() const
{
    for (const ScalingRow& row : rows)
        if (row.part == ScalingPart::nodes && row.ranks == 1) return &row;
    return nullptr;
}

std::string defaultLargeField(const std::string& field)
{
    return (isBuiltinFlow(field) ? field.substr(0, field.find(':')) : "abc") + ":512,512,512";
}

ScalingBench benchScaling(const ScalingBenchPlan& plan, const BenchProgress& progress)
{
    validate(plan.scene, optionName);
    return Measurement(plan, progress).run();
}

}  // namespace aeolic
