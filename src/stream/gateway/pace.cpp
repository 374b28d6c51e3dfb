#include "stream/gateway/pace.h"

#include <algorithm>

namespace aeolic::stream {
namespace {

constexpr double kScales[] = {1, 0.75, 0.5, 0.375, 0.25};
constexpr int kSmallest = int(std::size(kScales)) - 1;
constexpr int kBestQuality = 80, kWorstQuality = 40, kQualityStep = 10;
constexpr int kCalmFrames = 6;           // Growing at once after one quick frame would pump.
constexpr double kRoom = 0.9;            // A larger step is taken where it would keep this share of the target.
constexpr double kFastBytesPerMs = 2e4;  // 160 Mbit/s: from there on packing small takes longer than sending.

}  // namespace

void Pace::add(const FrameTiming& timing)
{
    // What a small picture takes to arrive says little about the line.
    if (timing.bytes > 2e4 && timing.showMs > 0) {
        const double now = timing.bytes / std::max(timing.showMs, 0.2);
        bytesPerMs_ = bytesPerMs_ > 0 ? 0.7 * bytesPerMs_ + 0.3 * now : now;
    }
    if (!timing.moving) return;
    // Drawing one frame and showing the one before go on side by side; the slower of the two is the frame time.
    const double frameMs = std::max(timing.drawMs, timing.showMs);
    const bool lineIsSlow = timing.showMs > timing.drawMs;
    if (frameMs > targetMs) {
        calm_ = 0;
        if (lineIsSlow && quality_ > kWorstQuality)
            quality_ -= kQualityStep;
        else if (step_ < kSmallest)
            ++step_;
        return;
    }
    const double grown = step_ > 0 ? kScales[step_ - 1] / kScales[step_] : 1;
    const double expectedMs = frameMs * grown * grown;
    if ((step_ == 0 && quality_ == kBestQuality) || expectedMs > kRoom * targetMs) {
        calm_ = 0;
    } else if (++calm_ >= kCalmFrames) {
        calm_ = 0;
        step_ > 0 ? void(--step_) : void(quality_ += kQualityStep);
    }
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
