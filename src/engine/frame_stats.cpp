#include "engine/frame_stats.h"

#include <algorithm>
#include <utility>

namespace aeolic {
namespace {

Traffic since(Traffic& before, const Traffic& now)
{
    const Traffic last = std::exchange(before, now);
    return {now.bytes - last.bytes, now.messages - last.messages};
}

/// The sum of the stages' wall times stays, unless the device worked while this thread did something else.
void takeDeviceTimes(const DeviceTimes& device, FrameStats& frame, RankStats& mine)
{
    const double callsMs = frame.projectMs + frame.convolveMs + frame.shadeMs;
    frame.projectMs = device.projectMs;
    frame.convolveMs = device.convolveMs;
    frame.shadeMs = std::max(callsMs - device.projectMs - device.convolveMs, device.shadeMs + device.readBackMs);
    mine.project.busyMs = mine.project.workMs = device.projectMs;
    mine.convolve.busyMs = mine.convolve.workMs = device.convolveMs;
    mine.shade.busyMs = mine.shade.workMs = device.shadeMs + device.readBackMs;
}

}  // namespace

void FrameClock::add(const StageFields& fields)
{
    frame_.*fields.wallMs += watch_.lapMs();
    StageStats& stage = mine_.*fields.rank;
    stage.busyMs += ranks_.busy().lapMs();
    stage.workMs += ranks_.working().lapMs();
    const Traffic sent = since(sent_, ranks_.sent()), received = since(received_, ranks_.received());
    stage.sentBytes += sent.bytes;
    stage.sentMessages += sent.messages;
    stage.receivedBytes += received.bytes;
    stage.receivedMessages += received.messages;
}

void completeStats(Backend& backend, const FrameRows& rows, FrameStats& frame, RankStats& mine)
{
    if (const auto device = backend.deviceTimes()) takeDeviceTimes(*device, frame, mine);
    for (const StageFields& fields : stages::all) {
        const StageStats& stage = mine.*fields.rank;
        frame.totalMs += frame.*fields.wallMs;
        mine.busyMs += stage.busyMs;
        mine.sentBytes += stage.sentBytes;
        mine.sentMessages += stage.sentMessages;
    }
    const Extent& stripe = rows.stripe;
    mine.firstRow = stripe.y0;
    mine.rows = stripe.height();
    mine.guardAbove = stripe.y0 - rows.read.y0;
    mine.guardBelow = rows.read.y1 - stripe.y1;
    mine.pixels = backend.coveredPixels(stripe.y0, stripe.y1);
    mine.guardPixels =
        backend.coveredPixels(rows.drawn.y0, stripe.y0) + backend.coveredPixels(stripe.y1, rows.drawn.y1);
}

}  // namespace aeolic
