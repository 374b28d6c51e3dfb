#pragma once

#include <span>
#include <string>
#include <vector>

#include "cluster/balance/frame_costs.h"
#include "cluster/balance/network_model.h"
#include "cluster/balance/row_coverage.h"
#include "cluster/balance/stripes.h"
#include "scaling/costs.h"

namespace aeolic {

/// A cluster that is not there.
struct SimulatedCluster {
    int ranks = 1;
    std::vector<double> speeds;  ///< [ranks], 1 being the machine that was measured; empty: all 1.
    std::string balancer = "hybrid";
    NetworkModel network;
    MeasuredCosts costs;
    int imageWidth = 0;
    int guardRows = 0;  ///< On each side of a stripe.
    GuardSource guardSource = GuardSource::receive;
    int guardPixelBytes = 9;         ///< A covered guard pixel on its way: depth and flow, 4 bytes each, and links.
    int imagePixelBytes = 3;         ///< A finished pixel on its way to rank 0.
    int coverageFactor = 5;          ///< Coverage is counted at 1 / this of the resolution it is known at.
    std::int64_t coverageBytes = 0;  ///< What each rank tells the others of the coverage; 0: each counts all of it.
};

/// `rows` as if counted at 1 / factor of their resolution: block means, rounded. Runs are left out.
RowCoverage coarsened(const RowCoverage& rows, int factor);

/// One frame as modelled. Its time is the critical path: the slowest rank of every stage, stages one after another, and
/// the network between them.
struct SimulatedFrame {
    Stripes stripes;
    std::vector<double> busyMs;                                            ///< [ranks]: compute time.
    double coverageMs = 0, projectMs = 0, convolveMs = 0, shadeMs = 0;     ///< The slowest rank of each stage.
    double gatherMs = 0;                                                   ///< The slowest rank that packs for rank 0.
    double balanceNetworkMs = 0, guardNetworkMs = 0, gatherNetworkMs = 0;  ///< The slowest rank of each transfer.
    std::int64_t guardPixels = 0;                                          ///< Covered ones, all ranks together.
    std::int64_t sentBytes = 0, messages = 0;                              ///< Guards and picture, all ranks together.

    double computeMs() const { return coverageMs + projectMs + convolveMs + shadeMs + gatherMs; }
    double networkMs() const { return balanceNetworkMs + guardNetworkMs + gatherNetworkMs; }
    double totalMs() const { return computeMs() + networkMs(); }
    double balance() const;  ///< Mean busy / max busy, (0, 1]; 1: nobody waits.
};

/// An animation on such a cluster. The program's own balancers are fed with the times that `cluster.costs` give for the
/// true coverage of each frame (factor 1, all of one height), and see no more than they would in the program.
/// Cost per frame: ranks * log(rows) * 24 for hybrid, and every pair of ranks whose stripe and guard meet.
std::vector<SimulatedFrame> simulate(const SimulatedCluster& cluster, std::span<const RowCoverage> frames);

}  // namespace aeolic
