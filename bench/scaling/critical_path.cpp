#include "scaling/critical_path.h"

#include <algorithm>

namespace aeolic {

double CriticalPath::computeMs() const
{
    double sum = 0;
    for (const CriticalStage& stage : stages) sum += stage.computeMs;
    return sum;
}

double CriticalPath::networkMs() const
{
    double sum = 0;
    for (const CriticalStage& stage : stages) sum += stage.networkMs;
    return sum;
}

CriticalPath criticalPath(std::span<const RankStats> ranks, const NetworkModel& network)
{
    CriticalPath path;
    for (std::size_t s = 0; s < kFrameStages.size(); ++s) {
        CriticalStage& critical = path.stages[s];
        critical.slowestRank = ranks.front().rank;
        for (const RankStats& rank : ranks) {
            const StageStats& stage = rank.*kFrameStages[s].stats;
            if (stage.busyMs > critical.computeMs) {
                critical.computeMs = stage.busyMs;
                critical.slowestRank = rank.rank;
            }
            critical.networkMs = std::max({critical.networkMs, network.transferMs(stage.sentBytes, stage.sentMessages),
                                           network.transferMs(stage.receivedBytes, stage.receivedMessages)});
        }
    }
    return path;
}

double loadBalance(std::span<const RankStats> ranks)
{
    double sum = 0, most = 0;
    for (const RankStats& rank : ranks) {
        sum += rank.busyMs;
        most = std::max(most, rank.busyMs);
    }
    return most > 0 ? sum / (most * double(ranks.size())) : 1.0;
}

}  // namespace aeolic
