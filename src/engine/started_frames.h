#pragma once

#include <deque>

#include "engine/frame.h"

namespace aeolic {

/// A frame from its start to its end, and what may have changed by then.
struct StartedFrame {
    Frame frame;
    ShadingOptions shading;
    int height = 0;  ///< Of the whole picture.
    double time = 0, stepMs = 0;
    bool finished = false;  ///< And not yet asked for.
};

/// Frames that follow each other: as many as the backend has in flight, in memory they use by turns.
class StartedFrames {
public:
    /// Local. For the frame to start next, whose memory is that of one long finished. Throws std::logic_error where
    /// there is no room for it.
    StartedFrame& next(const Backend& backend);

    /// Local. What next() gave is started.
    void started() { ++started_; }

    /// Collective. Waits for the oldest frame started, which is over then, also where that fails. It stays as it is
    /// until as many more have been started. Throws std::logic_error where none is started.
    StartedFrame& finish(Backend& backend, FrameGroup& group);

    /// Collective. Waits for all that are started, before their backend goes; finish() gives them as ever.
    void finishAll(Backend& backend, FrameGroup& group);

private:
    StartedFrame& at(std::size_t turn) { return frames_[turn % frames_.size()]; }
    int unfinished();

    std::deque<StartedFrame> frames_;  // As many as the first backend has in flight.
    std::size_t started_ = 0, given_ = 0;
};

}  // namespace aeolic
