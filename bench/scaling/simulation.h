#pragma once

#include <string>
#include <vector>

#include "cluster/balance/network_model.h"
#include "data/scene.h"
#include "scaling/simulated_cluster.h"

namespace aeolic {

/// The measured animation on clusters that are larger than can be measured here, at the costs that were measured.
struct SimulationPlan {
    SceneDescription scene;  ///< Its size is not used; whole fields on every rank.
    int width = 16384, height = 16384;
    std::vector<int> ranks{1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024};
    std::vector<std::string> balancers{"static", "timing", "pixels", "hybrid"};
    NetworkModel network;
    MeasuredCosts costs;  ///< `coverageMs` is not used: it is measured in the size that is simulated.
};

struct SimulatedPoint {
    int ranks = 1;
    std::string balance;
    SimulatedFrame frame;  ///< The one whose time is the median.
};

struct ScalingSimulation {
    int width = 0, height = 0;
    double coveredShare = 0;  ///< How much of the picture the surface covers, mean of the frames.
    int guardRows = 0;
    GuardSource guardSource = GuardSource::receive;
    std::vector<SimulatedPoint> points;  ///< By ranks, then balancer.
};

/// Counts the scene's coverage on one thread, then simulates. Rank counts above the picture's rows are left out.
ScalingSimulation simulateScaling(const SimulationPlan& plan, const Scene& scene);

}  // namespace aeolic
