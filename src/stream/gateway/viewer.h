#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "stream/gateway/pace.h"
#include "stream/message.h"
#include "stream/requests.h"

namespace aeolic::stream {

using SteadyClock = std::chrono::steady_clock;

/// Where messages for one viewer go. No call blocks or calls back.
class ViewerPort {
public:
    virtual ~ViewerPort() = default;
    virtual void send(WireMessage message) = 0;
    virtual void close(std::uint16_t code, const std::string& reason) = 0;
    /// Of what was sent: frames that are not in the socket to their last byte.
    virtual int framesQueued() const = 0;
};

/// Where a rank listens for viewers.
struct DirectPlace {
    std::string host;  ///< As the gateway sees it; empty: the gateway's own, by whatever name the viewer knows that.
    std::uint16_t port = 0;
};

/// A picture as it was sent.
struct StoredFrame {
    FrameHeader header;
    std::vector<WireMessage> tiles;
    WireMessage end;
    Codec codec = Codec::png;
    std::size_t bytes = 0;
    bool moving = false;
    bool direct = false;  ///< Some tiles went from a rank to the viewer: `tiles` lacks them.
    double drawMs = 0;
    SteadyClock::time_point sent;  ///< When the last byte was passed on.
};

/// A picture that the job is drawing.
struct Drawing {
    std::uint32_t viewer = 0;
    std::shared_ptr<StoredFrame> picture;
    std::set<std::uint32_t> recipients;
    std::vector<bool> rowsHere;
    std::uint32_t rowsMissing = 0;
    bool begun = false;
    SteadyClock::time_point start;
};

/// What the gateway knows of one viewer.
struct Viewer {
    std::uint32_t id = 0;
    ViewerPort* port = nullptr;
    Hello hello;
    Pace pace;
    std::uint32_t following = 0;        ///< 0: its own camera.
    std::optional<ViewRequest> wanted;  ///< Not drawn yet.
    std::optional<ViewRequest>
        last;  ///< Drawn last, or being drawn: to be drawn again when the scene or the job changes.
    std::deque<std::uint32_t> unshown;           ///< Frames sent or being drawn that it has not shown.
    std::shared_ptr<const StoredFrame> picture;  ///< Its last complete one.
    int endedJobs = 0;                           ///< Times in a row that the job died of its view.

    /// What it says of itself is not enough: it might not even have read what it says it has shown.
    bool mayGetAnother() const { return unshown.size() < 2 && port->framesQueued() < 2; }
    bool can(Codec codec) const
    {
        return std::find(hello.codecs.begin(), hello.codecs.end(), codec) != hello.codecs.end();
    }
};

}  // namespace aeolic::stream
