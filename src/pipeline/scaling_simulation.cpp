#include "pipeline/scaling_simulation.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <numeric>

#include "base/median.h"
#include "base/timing.h"
#include "cluster/frame_costs.h"
#include "cluster/stripes.h"
#include "data/mesh_tools.h"
#include "render/backend.h"
#include "render/view.h"

namespace aeolic {
namespace {

constexpr int kFrames = 8, kSettlingFrames = 3;  // The latter are drawn and not counted.
constexpr int kMostTrueRows = 4096;              // Coverage of larger pictures is counted at a part of their size.

struct Animation {
    std::vector<RowCoverage> frames;
    double coverageMs = 0, maxStepPx = 0;
    TraceReach reach;
};

double totalOf(const RowCoverage& rows)
{
    return double(std::accumulate(rows.coveredPerRow.begin(), rows.coveredPerRow.end(), std::int64_t{0})) *
           double(rows.factor) * double(rows.factor);
}

Animation drawCoverage(const SimulationPlan& plan, const Scene& scene)
{
    const auto backend = makeBackend("cpu", scene);
    const double radius = radiusAbout(scene.surface, scene.boundsWorld.center());
    const int factor = (plan.height + kMostTrueRows - 1) / kMostTrueRows;
    Animation animation;
    animation.reach = backend->reach(plan.scene.lic);
    std::vector<double> coverageMs;
    for (int i = 0; i < kFrames; ++i) {
        const double turnedDeg = plan.scene.output.orbitDeg / plan.scene.output.frames * i;
        const Camera camera = makeCamera(orbited(plan.scene.camera, turnedDeg, scene.boundsWorld), scene.boundsWorld,
                                         radius, plan.width, plan.height);
        const View view = makeView(camera, scene, plan.scene.lic);
        animation.maxStepPx = view.maxStepPx;
        animation.frames.push_back({plan.height, factor, backend->coverage(view, factor)});
        const double startMs = threadCpuMs();
        backend->coverage(view, kCoverageFactor);
        coverageMs.push_back(threadCpuMs() - startMs);
    }
    animation.coverageMs = median(coverageMs);
    return animation;
}

SimulatedPoint medianPoint(const SimulatedCluster& cluster, const std::vector<RowCoverage>& frames)
{
    std::vector<SimulatedFrame> simulated = simulate(cluster, frames);
    simulated.erase(simulated.begin(), simulated.begin() + kSettlingFrames);
    std::sort(simulated.begin(), simulated.end(),
              [](const SimulatedFrame& a, const SimulatedFrame& b) { return a.totalMs() < b.totalMs(); });
    SimulatedPoint point{cluster.ranks, cluster.balancer, 0, simulated[(simulated.size() - 1) / 2]};
    point.totalMs = point.frame.totalMs();
    return point;
}

}  // namespace

ScalingSimulation simulateScaling(const SimulationPlan& plan, const Scene& scene)
{
    Animation animation;
    tbb::task_arena arena(1);
    arena.execute([&] { animation = drawCoverage(plan, scene); });

    const FrameCosts frame = frameCosts(plan.scene.lic, plan.network);
    ScalingSimulation result;
    result.width = plan.width;
    result.height = plan.height;
    result.guardRows = animation.reach.steps > 0
                           ? guardRowsBound(animation.reach.steps, animation.maxStepPx, animation.reach.jumps)
                           : 0;
    result.coverageMs = animation.coverageMs;
    for (const RowCoverage& rows : animation.frames)
        result.coveredShare += totalOf(rows) / (double(plan.width) * plan.height) / double(animation.frames.size());
    result.guardSource = cheaperGuard(frame, plan.scene.lic, plan.width, result.guardRows, 2, plan.network);

    SimulatedCluster cluster;
    cluster.network = plan.network;
    cluster.costs = plan.costs;
    cluster.costs.coverageMs = animation.coverageMs;
    cluster.imageWidth = plan.width;
    cluster.guardRows = result.guardRows;
    cluster.guardSource = result.guardSource;
    cluster.guardPixelBytes = guardPixelBytes(plan.scene.lic);
    for (const int ranks : plan.ranks) {
        if (ranks > plan.height) continue;
        cluster.ranks = ranks;
        for (const std::string& balancer : plan.balancers) {
            cluster.balancer = balancer;
            result.points.push_back(medianPoint(cluster, animation.frames));
            if (ranks == 1) break;  // All alike.
        }
    }
    return result;
}

}  // namespace aeolic
