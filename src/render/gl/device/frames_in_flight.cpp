#include "render/gl/device/frames_in_flight.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "base/parallel.h"

namespace aeolic::gl {

void FrameInFlight::finish()
{
    const std::byte* from = pixels.wait();
    const std::size_t rowBytes = std::size_t(rows.width()) * 4;
    parallelRanges(std::size_t(std::max(rows.height(), 0)), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            std::memcpy(out->row(rows.y0 + int(i)) + 4 * (rows.x0 - out->extent.x0), from + i * rowBytes, rowBytes);
    });
    out->paint(rows.y0, rows.y1);
    counts.wait();
}

FrameInFlight& FramesInFlight::begin()
{
    if (shaded_ - finished_ == kMost) throw std::logic_error("gl: more frames are begun than can be in flight");
    begun_ = shaded_;
    drawn().timers.startFrame();
    return drawn();
}

void FramesInFlight::shaded()
{
    if (shaded_ - finished_ == kMost) throw std::logic_error("gl: more frames are shaded than can be in flight");
    ++shaded_;
}

FrameInFlight& FramesInFlight::finish()
{
    if (shaded_ == finished_) throw std::logic_error("gl: no frame is in flight");
    FrameInFlight& oldest = frames_[finished_ % kMost];
    oldest.finish();
    ++finished_;
    return oldest;
}

}  // namespace aeolic::gl
