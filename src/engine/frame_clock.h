#pragma once

#include "aeolic/renderer.h"
#include "base/busy_clock.h"
#include "base/timing.h"
#include "cluster/comm/communicator.h"

namespace aeolic {

/// Wall time, busy time and traffic of one rank's frame, stage by stage, while it is being started or finished.
class FrameClock {
public:
    /// Starts `busy`; what it and `communicator` counted since the last frame is nobody's.
    FrameClock(BusyClock& busy, const Communicator& communicator)
        : busy_(busy), communicator_(communicator), sent_(communicator.sent()), received_(communicator.received())
    {
        busy_.start();
        busy_.lapMs();
    }
    ~FrameClock() { stop(); }
    FrameClock(const FrameClock&) = delete;
    FrameClock& operator=(const FrameClock&) = delete;

    /// Ends a stage, or a part of one.
    void lap(double& wallMs, StageStats& stage)
    {
        wallMs += watch_.lapMs();
        stage.busyMs += busy_.lapMs();
        const Traffic sent = communicator_.sent(), received = communicator_.received();
        stage.sentBytes += sent.bytes - sent_.bytes;
        stage.sentMessages += sent.messages - sent_.messages;
        stage.receivedBytes += received.bytes - received_.bytes;
        stage.receivedMessages += received.messages - received_.messages;
        allSent_.bytes += sent.bytes - sent_.bytes;
        allSent_.messages += sent.messages - sent_.messages;
        sent_ = sent;
        received_ = received;
    }

    /// Adds what was sent in all stages so far.
    void addSent(RankStats& mine) const
    {
        mine.sentBytes += allSent_.bytes;
        mine.sentMessages += allSent_.messages;
    }

    /// After the last stage; to be called before anything Collective that is none.
    void stop() { busy_.stop(); }

private:
    BusyClock& busy_;
    const Communicator& communicator_;
    Traffic sent_, received_;  // At the last lap.
    Traffic allSent_;
    StopWatch watch_;
};

}  // namespace aeolic
