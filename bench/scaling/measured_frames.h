#pragma once

#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "aeolic/renderer.h"
#include "engine/frame.h"
#include "ranks/replay_communicator.h"

namespace aeolic {

/// All ranks' parts of a frame, by rank.
using RanksOfFrame = std::vector<RankStats>;

/// A rank's part of a frame that was measured several times: in each stage the least of its busy times, everything else
/// from the last time. At least one. The work is the same each time, and whatever else the machine does only adds to
/// it: without this, one of eight ranks is held up in nearly every frame, and the slowest rank is what counts.
RankStats leastOf(const std::vector<RankStats>& repeats);

/// A group that can draw again what it drew before: as if the frames since then had not been.
class GroupWithPast : public FrameGroup {
public:
    using FrameGroup::FrameGroup;
    using FrameGroup::remember;

    const FrameHistory& history() const { return history_; }  ///< Local.
    /// Local, but balancing needs the same of all ranks.
    void goBackTo(FrameHistory history) { history_ = std::move(history); }
};

/// Frames drawn by ranks that share a few cores, and what each rank would take on a node of its own.
///
/// A rank that takes turns with others on a core finds in its caches what they left; on a node it finds what it left
/// itself. So all ranks draw a frame together first, and then each rank draws it again while all others wait: the frame
/// before it and then this one, from recordings of what it received. Only the time for this one counts.
class MeasuredFrames {
public:
    /// `others`: whom to draw with. `alone`: the same for all ranks.
    MeasuredFrames(const Scene& scene, Backend& backend, Communicator& others, const RunOptions& options,
                   std::mutex& alone);

    /// Collective. Draws the next frame and measures it `repeats` times; balancing goes by what was measured of those
    /// before.
    RanksOfFrame draw(const FrameRequest& request, int repeats);

private:
    /// What it takes to draw a frame again, alone.
    struct Drawn {
        FrameRequest request;
        FrameHistory before;
        Recording received;
    };
    RankStats drawAlone(Drawn& drawn);

    const Scene& scene_;
    Backend& backend_;
    Communicator& others_;
    ReplayCommunicator communicator_;
    GroupWithPast group_;
    std::mutex& alone_;
    std::optional<Drawn> last_;
    Drawn now_;
    Frame frame_;
};

}  // namespace aeolic
