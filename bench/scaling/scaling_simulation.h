#pragma once

#include <string>
#include <vector>

#include "cluster/balance/network_model.h"
#include "data/scene.h"
#include "scaling/simulator.h"

namespace aeolic {

/// The same animation on a cluster that is not there, larger than can be measured: cluster/simulator.h with costs that
/// were measured here.
struct SimulationPlan {
    SceneDescription scene;  ///< Its size is not used; whole fields on every rank.
    int width = 16384, height = 16384;
    std::vector<int> ranks{1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024};
    std::vector<std::string> balancers{"static", "timing", "pixels", "hybrid"};
    NetworkModel network;
    MeasuredCosts costs;  ///< But for coverage, which is measured in the size that is simulated.
};

struct SimulatedPoint {
    int ranks = 1;
    std::string balance;
    double totalMs = 0;    ///< Median of the frames.
    SimulatedFrame frame;  ///< The one in the middle.
};

struct ScalingSimulation {
    int width = 0, height = 0;
    double coveredShare = 0;  ///< Of the picture, mean of the frames.
    int guardRows = 0;
    GuardSource guardSource = GuardSource::receive;
    double coverageMs = 0;               ///< What counting this frame's pixels takes each rank.
    std::vector<SimulatedPoint> points;  ///< By ranks, then balancer.
};

/// Counts the scene's coverage on this thread's own, then simulates. Rank counts above the picture's rows are left out.
ScalingSimulation simulateScaling(const SimulationPlan& plan, const Scene& scene);

}  // namespace aeolic
