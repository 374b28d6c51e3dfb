#include "stream/gateway/hub/pace.h"

#include <algorithm>

namespace aeolic::stream {
namespace {

constexpr double kScales[] = {1, 0.75, 0.5, 0.375, 0.25};
constexpr int kSmallest = int(std::size(kScales)) - 1;
constexpr int kBestQuality = 80, kWorstQuality = 40, kQualityStep = 10;
constexpr int kCalmFrames = 6,
              kMostCalmFrames = 192;  // Growing after a single quick frame would make sizes go up and down.
constexpr double kRoom = 0.9;  // A larger size is taken if its frame time would stay within this share of the target.
constexpr double kFastBytesPerMs = 2e4;  // 160 Mbit/s: on a faster line, packing takes longer than sending more bytes.

/// One frame that something else held up is no reason to change the picture.
void settle(double& mean, double now, double weight)
{
    mean += weight * (now - mean);
}

}  // namespace

void Pace::add(const FrameTiming& timing)
{
    // The time that a small picture takes to arrive says little about the line.
    if (timing.bytes > 2e4 && timing.showMs > 0) {
        const double now = timing.bytes / std::max(timing.showMs, 0.2);
        bytesPerMs_ > 0 ? settle(bytesPerMs_, now, 0.3) : void(bytesPerMs_ = now);
    }
    if (!timing.moving) return;
    settle(drawMs_, timing.drawMs, 0.25);
    settle(showMs_, timing.showMs, 0.25);
    ++sinceGrowth_;
    // Drawing one frame and showing the one before go on side by side; the slower of the two is the frame time.
    if (std::max(drawMs_, showMs_) > targetMs ? shrink() : grow()) forget();
}

bool Pace::shrink()
{
    calm_ = 0;
    // The last growth was in vain, so the next try waits longer.
    if (sinceGrowth_ < kMostCalmFrames) calmNeeded_ = std::min(2 * calmNeeded_, kMostCalmFrames);
    if (showMs_ > drawMs_ && quality_ > kWorstQuality)
        quality_ -= kQualityStep;
    else if (step_ < kSmallest)
        ++step_;
    else
        return false;
    return true;
}

bool Pace::grow()
{
    if (step_ == 0 && quality_ == kBestQuality) {
        if (sinceGrowth_ > kMostCalmFrames) calmNeeded_ = kCalmFrames;
        return false;
    }
    // The time for drawing goes with the pixels. Much of the time for showing is the same for any picture.
    const double grown = step_ > 0 ? kScales[step_ - 1] / kScales[step_] : 1;
    const double expectedMs = std::max(drawMs_ * grown * grown, showMs_ * grown);
    calm_ = expectedMs > kRoom * targetMs ? 0 : calm_ + 1;
    if (calm_ < calmNeeded_) return false;
    calm_ = sinceGrowth_ = 0;
    step_ > 0 ? void(--step_) : void(quality_ += kQualityStep);
    return true;
}

double Pace::scale() const
{
    return kScales[step_];
}

Codec Pace::lossless(bool lz4) const
{
    return lz4 && bytesPerMs_ >= kFastBytesPerMs ? Codec::lz4 : Codec::png;
}

}  // namespace aeolic::stream
