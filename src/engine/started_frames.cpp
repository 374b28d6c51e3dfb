#include "engine/started_frames.h"

#include <stdexcept>
#include <utility>

namespace aeolic {
namespace {

void bringIn(StartedFrame& frame, Backend& backend, FrameGroup& group)
{
    if (!std::exchange(frame.finished, true)) finishFrame(backend, group, frame.frame);
}

}  // namespace

int StartedFrames::unfinished()
{
    int count = 0;
    for (std::size_t i = given_; i < started_; ++i) count += !at(i).finished;
    return count;
}

StartedFrame& StartedFrames::next(const Backend& backend)
{
    if (frames_.empty()) frames_.resize(std::size_t(backend.framesInFlight()));
    if (started_ - given_ == frames_.size() || unfinished() == backend.framesInFlight())
        throw std::logic_error("more frames are started than can be in flight");
    StartedFrame& frame = at(started_);
    frame.finished = false;
    return frame;
}

StartedFrame& StartedFrames::finish(Backend& backend, FrameGroup& group)
{
    if (started_ == given_) throw std::logic_error("no frame is started");
    StartedFrame& oldest = at(given_++);
    bringIn(oldest, backend, group);
    return oldest;
}

void StartedFrames::finishAll(Backend& backend, FrameGroup& group)
{
    for (std::size_t i = given_; i < started_; ++i) bringIn(at(i), backend, group);
}

}  // namespace aeolic
