#pragma once

#include <array>

#include "aeolic/renderer.h"
#include "base/timing.h"
#include "cluster/comm/communicator.h"
#include "engine/frame_group.h"
#include "render/backend.h"

namespace aeolic {

/// Where the statistics keep a stage's numbers.
struct StageFields {
    StageStats RankStats::*rank;
    double FrameStats::*wallMs;
};

namespace stages {
inline constexpr StageFields balance{&RankStats::balance, &FrameStats::balanceMs},
    project{&RankStats::project, &FrameStats::projectMs}, composite{&RankStats::composite, &FrameStats::compositeMs},
    convolve{&RankStats::convolve, &FrameStats::convolveMs}, shade{&RankStats::shade, &FrameStats::shadeMs},
    gather{&RankStats::gather, &FrameStats::gatherMs};
inline constexpr std::array all{balance, project, composite, convolve, shade, gather};
}  // namespace stages

/// Measures wall time, busy time and traffic of one rank's stages while its frame is being started or finished. What
/// lies between two stages counts for the second.
class FrameClock {
public:
    /// Counts of `ranks` from before are left out.
    FrameClock(Communicator& ranks, FrameStats& frame, RankStats& mine)
        : ranks_(ranks), frame_(frame), mine_(mine), sent_(ranks.sent()), received_(ranks.received())
    {
        for (BusyClock* clock : {&ranks_.busy(), &ranks_.working()}) {
            clock->start();
            clock->lapMs();
        }
    }
    ~FrameClock()
    {
        ranks_.busy().stop();
        ranks_.working().stop();
    }
    FrameClock(const FrameClock&) = delete;
    FrameClock& operator=(const FrameClock&) = delete;

    /// Runs a stage, or a part of one.
    template <class Body>
    void time(const StageFields& stage, const Body& body)
    {
        body();
        add(stage);
    }

private:
    void add(const StageFields& stage);

    Communicator& ranks_;
    FrameStats& frame_;
    RankStats& mine_;
    Traffic sent_, received_;  // When the last stage ended.
    StopWatch watch_;
};

/// Local. After the last stage: fills in the sums, and what `backend` drew in `rows` as it counts it. Where a device
/// does the work its own times replace those of the calls that tell it what to do.
void completeStats(Backend& backend, const FrameRows& rows, FrameStats& frame, RankStats& mine);

}  // namespace aeolic
