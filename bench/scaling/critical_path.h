#pragma once

#include <array>
#include <span>

#include "aeolic/renderer.h"
#include "cluster/balance/network_model.h"

namespace aeolic {

/// A stage of renderFrame() in a rank's statistics.
struct FrameStage {
    const char* name;
    StageStats RankStats::*stats;
};

/// In the order in which they follow each other.
inline constexpr std::array<FrameStage, 6> kFrameStages{{{"balance", &RankStats::balance},
                                                         {"project", &RankStats::project},
                                                         {"composite", &RankStats::composite},
                                                         {"convolve", &RankStats::convolve},
                                                         {"shade", &RankStats::shade},
                                                         {"gather", &RankStats::gather}}};

/// A stage of all ranks together. Milliseconds.
struct CriticalStage {
    double computeMs = 0;  ///< CPU time of the slowest rank, measured.
    int slowestRank = 0;
    double networkMs = 0;  ///< The messages of the rank with most to send or to receive, modelled.
};

/// What a frame would take on as many nodes as ranks, each with the core that was measured, as if all ranks met after
/// every stage: the slowest rank of each stage and its messages in the network model, stage after stage. Pessimistic
/// where stages need no meeting, optimistic where a network is slower than its model.
struct CriticalPath {
    std::array<CriticalStage, kFrameStages.size()> stages;  ///< In the order of kFrameStages.

    double computeMs() const;
    double networkMs() const;
    double totalMs() const { return computeMs() + networkMs(); }
};

/// The critical path of one frame. `ranks`: every rank's part; at least one. A stage sends and receives at once, so
/// that the longer of the two counts; gathering takes as long as rank 0 receives the picture.
CriticalPath criticalPath(std::span<const RankStats> ranks, const NetworkModel& network);

/// Mean busy / max busy, (0, 1]. 1: nobody waits for others.
double loadBalance(std::span<const RankStats> ranks);

}  // namespace aeolic
