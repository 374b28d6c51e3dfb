#include "stages/stages.h"

#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "base/median.h"
#include "base/memory.h"
#include "base/timing.h"
#include "cluster/comm/communicator.h"
#include "data/load/loaded_scene.h"
#include "data/mesh/mesh_tools.h"
#include "description/choices.h"
#include "description/validate.h"
#include "engine/backend_together.h"
#include "rates/trace_lanes.h"
#include "render/backend.h"
#include "render/picture_memory.h"
#include "stages/frame_stages.h"

namespace aeolic {
namespace {

using Size = StagesBenchPlan::Size;

constexpr int kSampledTraces = 20000;

std::string sizeText(const Size& size)
{
    return std::to_string(size.width) + "x" + std::to_string(size.height);
}

/// Roughly how long a combination takes; only the progress goes by it.
double costOf(const Size& size, LicMethod method, int steps)
{
    const double fixed = 60;  // The other stages, in steps of the direct method.
    return double(size.width) * double(size.height) *
           (fixed + (method == LicMethod::direct ? double(steps) : 8 * std::log2(double(steps) + 1)));
}

/// Measures the scene in one size.
class SizeBench {
public:
    SizeBench(const StagesBenchPlan& plan, const Scene& scene, double radius, Backend& backend, const Size& size)
        : plan_(plan),
          scene_(scene),
          backend_(backend),
          size_(size),
          request_{makeCamera(plan.fillWide ? filling(plan.scene.camera, size.width, size.height) : plan.scene.camera,
                              scene.boundsWorld, radius, size.width, size.height),
                   plan.scene.lic, plan.scene.shading}
    {
        tile_.resize(whole());
    }

    StagesBenchRow measure(LicMethod method, int steps, const StagesBench& machine)
    {
        request_.lic.method = method;
        request_.lic.steps = steps;
        StagesBenchRow row{size_, method, steps};
        if (coldFor(method)) drawFrame();
        time(row);
        const LicOptions walked = inShortSteps(request_.lic);
        row.pixelStepsPerS = perSecond(2.0 * walked.steps * double(row.coveredPixels), row.convolveMs);
        countSteps(walked, row);
        if (machine.gatherRates || machine.fetchRates) countLanes(walked, row);
        if (machine.gatherRates) {
            row.shareOfGatherRate = row.lanesPerS / machine.gatherRates->gather.allThreads;
            row.shareOfBlockRate = row.lanesPerS / machine.gatherRates->blocks.allThreads;
        }
        if (machine.fetchRates) row.shareOfFetchRate = row.lanesPerS / machine.fetchRates->lanesPerS;
        return row;
    }

private:
    struct Times {
        std::vector<double> project, convolve, shade, readBack, device, total;
    };

    Extent whole() const { return {0, 0, size_.width, size_.height}; }

    /// As a frame walks it.
    LicOptions inShortSteps(const LicOptions& lic) const
    {
        return aeolic::inShortSteps(lic, makeView(request_.camera, scene_, lic));
    }

    static double perSecond(double count, double ms) { return ms > 0 ? count / (ms * 1e-3) : 0; }

    /// Whether a first frame would be slowed by getting memory. A kernel of other steps needs other levels of jumps,
    /// but traces of any length need the same memory.
    bool coldFor(LicMethod method)
    {
        const bool cold = !warm_ || method == LicMethod::hierarchical;
        warm_ = true;
        return cold;
    }

    void drawFrame(Times* times = nullptr)
    {
        StopWatch watch;
        const StageTimes calls = startStages(request_, scene_, backend_, tile_);
        StopWatch rest;
        backend_.finish();
        const double shadeMs = calls.shadeMs + rest.lapMs(), totalMs = watch.lapMs();
        if (times) {
            // Calls return before a device is done, so that its own clock tells where it has one. The whole is wall
            // time.
            const DeviceTimes stages =
                backend_.deviceTimes().value_or(DeviceTimes{calls.projectMs, calls.convolveMs, shadeMs, 0});
            times->project.push_back(stages.projectMs);
            times->convolve.push_back(stages.convolveMs);
            times->shade.push_back(stages.shadeMs);
            times->readBack.push_back(stages.readBackMs);
            times->device.push_back(stages.projectMs + stages.convolveMs + stages.shadeMs);
            times->total.push_back(totalMs);
        }
    }

    void time(StagesBenchRow& row)
    {
        Times times;
        for (int i = 0; i < plan_.repeats; ++i) {
            drawFrame(&times);
            if (walked_.empty()) sampleTraces();
        }
        row.coveredPixels = coveredPixels_;
        row.projectMs = median(times.project);
        row.convolveMs = median(times.convolve);
        row.shadeMs = median(times.shade);
        row.totalMs = median(times.total);
        if (backend_.deviceTimes()) row.device = {median(times.device), median(times.readBack), followingFrameMs()};
    }

    /// Wall time of a frame among others that follow each other: the next is drawn while the pixels of the one before
    /// are on their way.
    double followingFrameMs()
    {
        std::vector<Tile> tiles(std::size_t(backend_.framesInFlight()), tile_);
        const int ahead = int(tiles.size()) - 1, frames = ahead + plan_.repeats;
        std::vector<double> times;
        StopWatch watch;
        for (int i = 0; i < frames + ahead; ++i) {
            if (i < frames) startStages(request_, scene_, backend_, tiles[std::size_t(i) % tiles.size()]);
            if (i < ahead) continue;
            backend_.finish();
            const double ms = watch.lapMs();
            if (i > ahead && i < frames) times.push_back(ms);  // This frame began and ended beside others.
        }
        return median(times);
    }

    /// One sample serves all steps, because a trace that walks fewer than it may has ended, and both methods, because
    /// the method changes nothing of it.
    void sampleTraces()
    {
        coveredPixels_ = backend_.coveredPixels(0, size_.height);
        LicOptions longest = request_.lic;
        longest.steps = *std::max_element(plan_.steps.begin(), plan_.steps.end());
        const int mostSteps = inShortSteps(longest).steps;
        walked_ = cpu::sampleWalkedSteps(backend_.probe().gbuffer(), mostSteps, kSampledTraces);
    }

    void countSteps(const LicOptions& lic, StagesBenchRow& row) const
    {
        double steps = 0;
        for (const int walked : walked_) steps += std::min(walked, lic.steps);
        if (!walked_.empty()) row.walkedShare = steps / (double(walked_.size()) * lic.steps);
    }

    void countLanes(const LicOptions& lic, StagesBenchRow& row) const
    {
        const cpu::TraceLanes lanes(lic);
        const double traces = 2.0 * double(row.coveredPixels);
        double sampled = 0;
        for (const int walked : walked_) sampled += double(lanes.of(std::min(walked, lic.steps)));
        row.mostLanesPerS = perSecond(traces * double(lanes.most()), row.convolveMs);
        if (!walked_.empty()) row.lanesPerS = perSecond(traces * sampled / double(walked_.size()), row.convolveMs);
    }

    const StagesBenchPlan& plan_;
    const Scene& scene_;
    Backend& backend_;
    Size size_;
    FrameRequest request_;
    Tile tile_;
    bool warm_ = false;
    std::int64_t coveredPixels_ = 0;
    std::vector<int> walked_;
};

void benchAll(const StagesBenchPlan& plan, const Scene& scene, Backend& backend, const Watch<StagesBench>& watch,
              StagesBench& result)
{
    double whole = 0, done = 0;
    for (const Size& size : plan.sizes)
        for (const LicMethod method : plan.methods)
            for (const int steps : plan.steps) whole += costOf(size, method, steps);
    const double radius = radiusAbout(scene.surface, scene.boundsWorld.center());
    for (const Size& size : plan.sizes) {
        SizeBench bench(plan, scene, radius, backend, size);
        for (const LicMethod method : plan.methods)
            for (const int steps : plan.steps) {
                watch.tell(sizeText(size) + " " + std::string(nameOf(method)) + ", " + std::to_string(steps) + " steps",
                           done / whole);
                result.rows.push_back(bench.measure(method, steps, result));
                watch.show(result);
                done += costOf(size, method, steps);
            }
    }
}

}  // namespace

StagesBench benchStages(const StagesBenchPlan& plan, const Watch<StagesBench>& watch)
{
    validate(plan.scene, commandLineName);
    for (const Size& size : plan.sizes) requireMemory("--sizes", sizeText(size), pictureBytes(size.width, size.height));
    const int threads = plan.scene.run.threads > 0 ? plan.scene.run.threads : tbb::info::default_concurrency();
    tbb::task_arena arena(threads);
    StagesBench result;
    arena.execute([&] {
        watch.tell("loading", 0);
        const GpuChoice gpu{plan.scene.run.device, 0};
        const auto alone = makeSerialCommunicator();
        BackendPlan chosen = planBackend(*alone, plan.scene, {}, gpu);
        const Scene scene = loadScene(plan.scene);
        const auto backend = makeBackend(*alone, chosen, scene);
        result.backend = backend->name();
        result.device = backend->device();
        result.simd = backend->simd();
        result.threads = arena.max_concurrency();
        result.warnings = scene.warnings;
        if (chosen.missed) result.warnings.push_back("the GPU is not used: " + chosen.unusedGpu);
        if (result.backend == "cpu") result.gatherRates = cpu::measureGatherRates(result.threads, plan.rateRepeats);
        if (result.backend == "gl") result.fetchRates = gl::measureFetchRates(gpu);
        watch.show(result);
        benchAll(plan, scene, *backend, watch, result);
    });
    return result;
}

}  // namespace aeolic
