#include "pipeline/bench_scaling.h"

#include <tbb/info.h>

#include <algorithm>
#include <filesystem>

#include "aeolic/error.h"
#include "base/memory.h"
#include "cluster/cost_fit.h"
#include "data/builtin_flows.h"
#include "data/builtin_surfaces.h"
#include "data/scene.h"
#include "pipeline/bench_camera.h"
#include "pipeline/scaling_rows.h"
#include "pipeline/scaling_run.h"
#include "render/backend.h"
#include "scene/scene_fields.h"
#include "scene/validate.h"

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
        setups.push_back({ScalingPart::nodes, {whole, 1, {"static"}, plan.repeats}});
        for (const int ranks : plan.ranks)
            if (ranks > 1) setups.push_back({ScalingPart::nodes, {whole, ranks, plan.balancers, plan.repeats}});
    }
    SceneDescription bricked = whole;
    bricked.run.bricks = "on";
    const int most = *std::max_element(plan.ranks.begin(), plan.ranks.end());
    if (most < 2) return setups;
    if (wants(plan, ScalingPart::bricks)) {
        if (!bricked.field.spec.empty())
            setups.push_back({ScalingPart::bricks, {bricked, most, plan.balancers, plan.repeats}});
        setups.push_back(
            {ScalingPart::bricks, {withField(bricked, plan.largeField), most, plan.balancers, plan.repeats}});
    }
    if (wants(plan, ScalingPart::mesh)) {
        SceneDescription mesh = withField(bricked, plan.largeField);
        mesh.surface = {};
        mesh.surface.spec = plan.mesh;
        setups.push_back({ScalingPart::mesh, {mesh, most, plan.balancers, plan.repeats}});
    }
    return setups;
}

/// One line of a table, by balancer `b` of the setup.
ScalingRow rowOf(const PartSetup& from, std::size_t b, const ScalingSamples& samples, const NetworkModel& network)
{
    const SceneDescription& scene = from.setup.scene;
    ScalingRow row = measuredRow(samples, b, network);
    row.part = from.part;
    row.surface = scene.surface.spec;
    row.field = scene.field.spec;
    row.bricked = scene.run.bricks == "on";
    row.ranks = from.setup.ranks;
    row.balance = from.setup.balancers[b];
    return row;
}

/// Before anything is measured: what would end a measurement of minutes.
void checkParts(const ScalingBenchPlan& plan, const std::vector<PartSetup>& setups)
{
    for (const PartSetup& from : setups) {
        if (from.part == ScalingPart::nodes) continue;
        const std::uint64_t bytes = fieldBytesOf(from.setup.scene);
        if (bytes > 0) requireMemory("--large-field", from.setup.scene.field.spec, bytes);
    }
    if (!wants(plan, ScalingPart::mesh)) return;
    if (isBuiltinSurface(plan.mesh))
        makeBuiltinSurface(plan.mesh);
    else if (!std::filesystem::exists(plan.mesh))
        throw InputError("--mesh", "found " + inQuotes(plan.mesh), "a surface file or a built-in surface");
}

/// Every rank has its stripe and what its guard needs; a few pictures' worth even with long traces.
void requireImageMemory(const ScalingBenchPlan& plan)
{
    const OutputOptions& output = plan.scene.output;
    const int most = *std::max_element(plan.ranks.begin(), plan.ranks.end());
    requireMemory(
        "--size", std::to_string(output.width) + "x" + std::to_string(output.height),
        std::uint64_t(output.width) * std::uint64_t(output.height) * kBytesPerPixel * std::uint64_t(std::min(most, 4)));
}

std::string titleOf(const PartSetup& from)
{
    const SceneDescription& scene = from.setup.scene;
    return scene.surface.spec + " in " + (scene.field.spec.empty() ? "its own vectors" : scene.field.spec) +
           (scene.run.bricks == "on" ? " in bricks, ranks: " : ", ranks: ") + std::to_string(from.setup.ranks);
}

/// Measures setup after setup; tells how far all of it is.
class Measurement {
public:
    Measurement(const ScalingBenchPlan& plan, const BenchProgress& progress)
        : plan_(plan), progress_(progress), setups_(setupsOf(plan)), cores_(tbb::info::default_concurrency())
    {
        checkParts(plan, setups_);
        for (const PartSetup& from : setups_) framesInAll_ += framesOf(from);
    }

    ScalingBench run()
    {
        ScalingBench bench;
        bench.cores = cores_;
        if (measuresNodes()) {
            tell("loading", 0);
            scene_ = loadScene(setups_.front().setup.scene);
            bench.warnings = scene_.warnings;
        }
        std::vector<ScalingSamples> samples;
        for (const PartSetup& from : setups_) samples.push_back(measure(from));
        if (measuresNodes()) {
            bench.steadiness = steadiness(samples, plan_.network);
            // One rank's row is of all its pictures, whenever they were drawn.
            std::vector<RanksOfFrame>& alone = samples.front().of.front().rotation;
            for (const ScalingSamples& of : samples) alone.insert(alone.end(), of.alone.begin(), of.alone.end());
        }
        for (std::size_t i = 0; i < setups_.size(); ++i)
            for (std::size_t b = 0; b < setups_[i].setup.balancers.size(); ++b)
                bench.rows.push_back(rowOf(setups_[i], b, samples[i], plan_.network));
        if (measuresNodes()) fit(samples, bench);
        nameMachine(bench);
        return bench;
    }

private:
    bool measuresNodes() const { return !setups_.empty() && setups_.front().part == ScalingPart::nodes; }

    int framesOf(const PartSetup& from) const
    {
        return int(from.setup.balancers.size()) * (from.setup.scene.output.frames + kJumps);
    }

    void tell(const std::string& what, double fraction) const
    {
        if (progress_) progress_(what, fraction);
    }

    ScalingSamples measure(const PartSetup& from)
    {
        const std::string title = titleOf(from);
        tell(title, double(framesDone_) / framesInAll_);
        return drawOnRanks(from.setup, from.part == ScalingPart::nodes ? &scene_ : nullptr, cores_,
                           [&] { tell(title, double(++framesDone_) / framesInAll_); });
    }

    void fit(const std::vector<ScalingSamples>& samples, ScalingBench& bench) const
    {
        std::vector<RanksOfFrame> frames;
        for (std::size_t i = 0; i < setups_.size(); ++i)
            for (const BalancerSamples& of : samples[i].of)
                if (setups_[i].part == ScalingPart::nodes)
                    frames.insert(frames.end(), of.rotation.begin(), of.rotation.end());
        const OutputOptions& output = plan_.scene.output;
        bench.costs = fitCosts(frames, output.width);
        if (!plan_.simulate) return;
        SimulationPlan plan;
        plan.scene = setups_.front().setup.scene;
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
    Scene scene_;
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
    requireImageMemory(plan);
    return Measurement(plan, progress).run();
}

}  // namespace aeolic
