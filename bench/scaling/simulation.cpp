#include "scaling/simulation.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>

#include "base/median.h"
#include "base/timing.h"
#include "cluster/balance/frame_costs.h"
#include "cluster/balance/stripes.h"
#include "data/mesh/mesh_tools.h"
#include "render/backend.h"
#include "render/lic/jump_plan.h"
#include "render/view.h"

namespace aeolic {
namespace {

constexpr int kFrames = 8;
constexpr int kUncountedFrames = 3;  // The first ones: balancers settle.
constexpr int kMostTrueRows = 4096;  // Coverage of larger pictures is counted at a part of their size.

double totalOf(const RowCoverage& rows)
{
    return double(std::accumulate(rows.coveredPerRow.begin(), rows.coveredPerRow.end(), std::int64_t{0})) *
           double(rows.factor) * double(rows.factor);
}

/// What the frames of the rotation cover, and how long it takes to count that.
class CoverageDrawing {
public:
    CoverageDrawing(const SimulationPlan& plan, const Scene& scene)
        : factor_((plan.height + kMostTrueRows - 1) / kMostTrueRows), backend_(makeBackend(BackendChoice::cpu, scene))
    {
        const double radius = radiusAbout(scene.surface, scene.boundsWorld.center());
        for (int i = 0; i < kFrames; ++i) {
            const double turnedDeg = orbitDegOf(plan.scene) / plan.scene.output.frames * i;
            const Camera camera = makeCamera(orbited(plan.scene.camera, turnedDeg, scene.boundsWorld),
                                             scene.boundsWorld, radius, plan.width, plan.height);
            views_.push_back(makeView(camera, scene, plan.scene.lic));
            frames_.push_back({plan.height, factor_, backend_->coverage(views_.back(), factor_)});
        }
    }

    const std::vector<RowCoverage>& frames() const { return frames_; }
    int factor() const { return factor_; }
    double maxStepPx() const { return views_.front().maxStepPx; }
    LicOptions walked(const LicOptions& lic) const { return inShortSteps(lic, views_.front()); }

    double coveredShare() const
    {
        double covered = 0;
        for (const RowCoverage& rows : frames_) covered += totalOf(rows) / double(frames_.size());
        return covered / (double(views_.front().camera.width) * double(views_.front().camera.height));
    }

    /// CPU time of counting one frame at 1 / factor of the resolution.
    double countingMs(int factor)
    {
        const auto known = countingMs_.find(factor);
        if (known != countingMs_.end()) return known->second;
        std::vector<double> ms;
        for (const View& view : views_) {
            const double startMs = threadCpuMs();
            backend_->coverage(view, factor);
            ms.push_back(threadCpuMs() - startMs);
        }
        return countingMs_[factor] = median(ms);
    }

private:
    int factor_;
    std::unique_ptr<Backend> backend_;
    std::vector<View> views_;
    std::vector<RowCoverage> frames_;
    std::map<int, double> countingMs_;
};

SimulatedPoint medianPoint(const SimulatedCluster& cluster, const std::vector<RowCoverage>& frames)
{
    std::vector<SimulatedFrame> simulated = simulate(cluster, frames);
    simulated.erase(simulated.begin(), simulated.begin() + kUncountedFrames);
    std::sort(simulated.begin(), simulated.end(),
              [](const SimulatedFrame& a, const SimulatedFrame& b) { return a.totalMs() < b.totalMs(); });
    return {cluster.ranks, cluster.balancer, simulated[(simulated.size() - 1) / 2]};
}

ScalingSimulation simulateHere(const SimulationPlan& plan, const Scene& scene)
{
    CoverageDrawing drawing(plan, scene);
    const LicOptions lic = drawing.walked(plan.scene.lic);
    const TraceReach reach = traceReach(lic);
    ScalingSimulation result;
    result.width = plan.width;
    result.height = plan.height;
    result.coveredShare = drawing.coveredShare();
    result.guardRows = reach.steps > 0 ? guardRowsBound(reach.steps, drawing.maxStepPx(), reach.levels) : 0;
    const int neighbours = 2;
    result.guardSource =
        cheaperGuard(frameCosts(lic, plan.network), lic, plan.width, result.guardRows, neighbours, plan.network);
    SimulatedCluster cluster;
    cluster.network = plan.network;
    cluster.costs = plan.costs;
    cluster.imageWidth = plan.width;
    cluster.guardRows = result.guardRows;
    cluster.guardSource = result.guardSource;
    cluster.guardPixelBytes = guardPixelBytes(lic);
    for (const int ranks : plan.ranks) {
        if (ranks > plan.height) continue;
        const int factor = coverageFactor(plan.height, ranks);
        cluster.ranks = ranks;
        cluster.coverageFactor = std::max(1, factor / drawing.factor());
        cluster.costs.coverageMs = drawing.countingMs(factor);
        cluster.coverageBytes =
            CoverageBits::bytes((plan.width + factor - 1) / factor, (plan.height + factor - 1) / factor);
        const auto triangles = std::int64_t(scene.surface.triangles.size());
        if (cheaperShared(triangles, cluster.coverageBytes, ranks, plan.network))
            cluster.costs.coverageMs /= ranks;
        else
            cluster.coverageBytes = 0;
        for (const std::string& balancer : plan.balancers) {
            cluster.balancer = balancer;
            result.points.push_back(medianPoint(cluster, drawing.frames()));
            if (ranks == 1) break;  // All balancers give one rank everything.
        }
    }
    return result;
}

}  // namespace

ScalingSimulation simulateScaling(const SimulationPlan& plan, const Scene& scene)
{
    ScalingSimulation result;
    tbb::task_arena arena(1);
    arena.execute([&] { result = simulateHere(plan, scene); });
    return result;
}

}  // namespace aeolic
