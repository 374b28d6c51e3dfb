#pragma once

#include <span>
#include <string>
#include <vector>

#include "cluster/balance/frame_costs.h"
#include "cluster/balance/network_model.h"
#include "cluster/balance/row_coverage.h"
#include "cluster/balance/stripes.h"

namespace aeolic {

/// What drawing costs one rank of speed 1, from measurements. Nanoseconds per pixel, milliseconds per frame.
struct MeasuredCosts {
    double projectFixedMs = 0;        ///< Every rank, whatever its stripe: transforming and culling the whole surface.
    double projectPixelNs = 0;        ///< Covered pixel, also of the guard where it is projected again.
    double projectAreaNs = 0;         ///< Any pixel of those rows, background too: clearing.
    double convolvePixelNs = 0;       ///< Covered pixel of the stripe.
    double convolveGuardPixelNs = 0;  ///< Covered pixel of the guard: where levels of the hierarchy are computed again.
    double convolveAreaNs = 0;        ///< Any pixel of the stripe and its guard: rearranging the flow.
    double shadePixelNs = 0;          ///< Any pixel of the stripe, background too.
    double packPixelNs = 0;           ///< Covered pixel of the stripe, but on rank 0: packed for it.
    double coverageMs = 0;            ///< Every rank, where the balancer needs this frame's coverage.
};

struct SimulatedCluster {
    int ranks = 1;
    std::vector<double> speeds;  ///< [ranks], 1 being the machine that was measured; empty: all 1.
    std::string balancer = "hybrid";
    NetworkModel network;
    MeasuredCosts costs;
    int imageWidth = 0;
    int guardRows = 0;  ///< On each side of a stripe.
    GuardSource guardSource = GuardSource::receive;
    int guardPixelBytes = 9;         ///< Of a covered guard pixel: depth and flow, 4 bytes each, and links.
    int imagePixelBytes = 3;         ///< Of a finished pixel on its way to rank 0.
    int coverageFactor = 5;          ///< Coverage is counted at 1 / this of what is known of it.
    std::int64_t coverageBytes = 0;  ///< What each rank tells the others of it; 0: each counts all of it.
};

/// One frame as modelled. The total is the critical path: of every stage the slowest rank, stages one after another,
/// and the network between them.
struct SimulatedFrame {
    Stripes stripes;
    std::vector<double> busyMs;                                            ///< [ranks]: compute time.
    double coverageMs = 0, projectMs = 0, convolveMs = 0, shadeMs = 0;     ///< Slowest rank of each stage,
    double gatherMs = 0;                                                   ///< and of packing for rank 0.
    double balanceNetworkMs = 0, guardNetworkMs = 0, gatherNetworkMs = 0;  ///< Slowest rank of each transfer.
    std::int64_t guardPixels = 0;                                          ///< Covered, of all ranks.
    std::int64_t sentBytes = 0, messages = 0;                              ///< Guards and picture, of all ranks.

    double computeMs() const { return coverageMs + projectMs + convolveMs + shadeMs + gatherMs; }
    double networkMs() const { return balanceNetworkMs + guardNetworkMs + gatherNetworkMs; }
    double totalMs() const { return computeMs() + networkMs(); }
    double balance() const;  ///< Mean busy / max busy, (0, 1]; 1: nobody waits.
};

/// An animation on a cluster that is not there: the program's own balancers, fed with the times that `cluster.costs`
/// give for the true coverage of each frame (factor 1, all of one height). The balancer sees no more than it would in
/// the program. Cost per frame: ranks * log(rows) * 24 for hybrid, and every pair of ranks whose stripe and guard meet.
std::vector<SimulatedFrame> simulate(const SimulatedCluster& cluster, std::span<const RowCoverage> frames);

}  // namespace aeolic
