#pragma once

#include <array>

#include "render/gl/device/read_back.h"
#include "render/gl/device/stage_timers.h"
#include "render/gl/project/row_counts.h"
#include "render/tile.h"

namespace aeolic::gl {

/// What is still to come of a frame when the calls that draw it have returned.
struct FrameInFlight {
    RowCounts counts;
    StageTimers timers;
    ReadBack pixels;
    Extent rows;  ///< Which rows the pixels are, global.
    Tile* out = nullptr;

    /// Waits for everything, and puts the pixels in their place.
    void finish();
};

/// Two frames: the pixels of one are on their way while the other is drawn. The images between the stages are shared:
/// the device does one thing after the other.
class FramesInFlight {
public:
    static constexpr unsigned kMost = 2;

    /// The frame that begins: its place is the one finished longest ago.
    FrameInFlight& begin();
    FrameInFlight& drawn() { return frames_[shaded_ % kMost]; }
    /// Its last call has been made. Throws std::logic_error where none of those before was finished.
    void shaded();
    /// Finishes the oldest.
    FrameInFlight& finish();
    /// The one finished last; where none is in flight, the one begun last.
    FrameInFlight& known() { return frames_[(shaded_ == finished_ ? begun_ : finished_ - 1) % kMost]; }

private:
    std::array<FrameInFlight, kMost> frames_;
    unsigned begun_ = 0, shaded_ = 0, finished_ = 0;  // Begun: the number of the last; the others: how many.
};

}  // namespace aeolic::gl
