#pragma once

#include <deque>

#include "engine/frame.h"
#include "render/overlay/figure.h"

namespace aeolic {

/// A frame from its start to its end, with the settings that may have changed by then.
struct StartedFrame {
    Frame frame;
    FrameRequest request;
    int height = 0;  ///< The whole picture's.
    double time = 0, stepMs = 0;
    std::optional<std::array<double, 2>> timeRange;  ///< In an animation: the moments of its ends.
    std::optional<Corner> legendCorner;              ///< In an animation: where the legend stays.
    Figure figure;                                   ///< Around the data that are shown when it starts.
    bool finished = false;                           ///< It is over, but finish() has not given it yet.
};

/// Frames that follow each other: as many as the backend has in flight, in memory they use by turns.
class StartedFrames {
public:
    /// Local. The place for the frame to start next, with the memory of one long finished. Throws std::logic_error
    /// where there is none.
    StartedFrame& next(const Backend& backend);

    /// Local. To be called when the frame that next() gave is started.
    void started() { ++started_; }

    /// Local. Some frame is started that finish() has not given.
    bool any() const { return started_ > given_; }

    /// Collective. Waits for the oldest frame started. It is over then, also where that fails, and stays until as many
    /// more have been started as there are places. Throws std::logic_error where none is started.
    StartedFrame& finish(Backend& backend, FrameGroup& group);

    /// Collective. Waits for all frames started, before their backend goes. finish() still gives them one by one.
    void finishAll(Backend& backend, FrameGroup& group);

private:
    StartedFrame& at(std::size_t turn) { return frames_[turn % frames_.size()]; }
    int unfinished();

    std::deque<StartedFrame> frames_;  // As many places as the first backend has frames in flight.
    std::size_t started_ = 0, given_ = 0;
};

}  // namespace aeolic
