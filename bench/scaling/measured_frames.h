#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include "aeolic/renderer.h"
#include "engine/frame.h"
#include "ranks/replay_communicator.h"

namespace aeolic {

/// All ranks' parts of a frame, by rank.
using RanksOfFrame = std::vector<RankStats>;

/// One of a rank's part that was measured several times over: of each stage the least of its busy times, everything
/// else as in the last. At least one. The work is the same each time, and what a machine does meanwhile only ever adds:
/// of eight ranks one is held up in nearly every frame, and the slowest is what counts.
RankStats leastOf(const std::vector<RankStats>& repeats);

/// Frames drawn by ranks that share a few cores, and what each rank would take on a node of its own.
///
/// Ranks that take turns on a core find in its caches what the others left, on a node what they left themselves. So a
/// frame is drawn by all ranks together first, and then once more by each rank alone while all others wait: the frame
/// before it and this one, from recordings of what it received. What it takes for this one counts.
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
    FrameGroup group_;
    std::mutex& alone_;
    std::optional<Drawn> last_;
    Drawn now_;
    Frame frame_;
};

}  // namespace aeolic
