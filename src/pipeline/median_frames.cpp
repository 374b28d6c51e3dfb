#include "pipeline/median_frames.h"

#include "base/median.h"
#include "cluster/critical_path.h"

namespace aeolic {

std::vector<RanksOfFrame> medianFrames(const std::vector<std::vector<RanksOfFrame>>& frames)
{
    std::vector<RanksOfFrame> medians = frames.back();
    for (std::size_t i = 0; i < medians.size(); ++i)
        for (std::size_t r = 0; r < medians[i].size(); ++r) {
            RankStats& rank = medians[i][r];
            rank.busyMs = 0;
            for (const FrameStage& stage : kFrameStages) {
                std::vector<double> busyMs;
                for (const std::vector<RanksOfFrame>& repeat : frames)
                    busyMs.push_back((repeat[i][r].*stage.stats).busyMs);
                (rank.*stage.stats).busyMs = median(busyMs);
                rank.busyMs += median(busyMs);
            }
        }
    return medians;
}

}  // namespace aeolic
