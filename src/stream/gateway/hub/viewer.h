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

#include "stream/gateway/hub/allowance.h"
#include "stream/gateway/hub/pace.h"
#include "stream/message.h"
#include "stream/requests.h"

namespace aeolic::stream {

using SteadyClock = std::chrono::steady_clock;

/// Takes the messages for one viewer. No call blocks or calls back.
class ViewerPort {
public:
    virtual ~ViewerPort() = default;
    virtual void send(WireMessage message) = 0;
    virtual void close(std::uint16_t code, const std::string& reason) = 0;
    /// How many frames were sent and are not in the socket to their last byte.
    virtual int framesQueued() const = 0;
    /// The oldest of them.
    virtual std::optional<std::uint32_t> oldestQueued() const = 0;
    /// False from close() on.
    virtual bool isOpen() const = 0;
};

/// Where a rank listens for viewers.
struct DirectPlace {
    std::string host;  ///< The rank's host as the gateway sees it. Empty: the gateway's own host, under the name the
                       ///< viewer knows.
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
    bool incomplete = false;  ///< Tiles are missing here: they went straight from a rank, or took too much memory.
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
    std::uint32_t paidBy = 0;  ///< The viewer whose change this picture shows first; 0: its own viewer pays.
    SceneDescription scene;
    SteadyClock::time_point start;
};

/// What the gateway knows of one viewer.
struct Viewer {
    std::uint32_t id = 0;
    ViewerPort* port = nullptr;
    Hello hello;
    Pace pace;
    std::uint32_t following = 0;            ///< The viewer that it follows; 0: it looks through its own camera.
    std::optional<ViewRequest> wanted;      ///< The view that waits to be drawn.
    SteadyClock::time_point wantedSince{};  ///< When the first view came that none was drawn for.
    std::optional<ViewRequest>
        last;  ///< The view drawn last, or being drawn. It is drawn again when the scene or the job changes.
    std::deque<std::uint32_t> unshown;     ///< Frames that are sent or being drawn, and that the viewer has not shown.
    std::shared_ptr<StoredFrame> picture;  ///< The viewer's last complete picture.
    int endedJobs = 0;                     ///< How many times in a row its view ended the job.
    SteadyClock::time_point mayChangeFrom{};  ///< Its changes are refused until then.
    SteadyClock::time_point mayLookFrom{};    ///< Its views wait until then.
    Allowance views{240, 120};                ///< 120 is what Welcome says.
    double timeHad = 0;                       ///< Milliseconds of drawing, on the scale of Hub::timeGiven_.
    std::optional<ChangeRequest> change;      ///< What it wants of the scene and waits: the newest wishes, merged.
    SteadyClock::time_point changeSince{};    ///< Since when it waits.
    SteadyClock::time_point changeCame{};     ///< When its last Change came, or was answered.
    bool movesScene = false;                  ///< It said that more changes will follow soon.
    double changeHad = 0;  ///< As timeHad: milliseconds of its changes, and of the pictures that showed them first.
    SteadyClock::time_point changesFrom{};   ///< Its changes wait until then while others look around.
    SteadyClock::time_point lookedAt{};      ///< When its last View came.
    SteadyClock::time_point againFrom{};     ///< Its last view is drawn again from then on, unless it sends another.
    std::uint32_t againFor = 0;              ///< Whose change makes its last view be drawn again.
    std::optional<PickRequest> pick;         ///< What it asks of a pixel and waits: the newest.
    std::optional<std::uint32_t> picking;    ///< The view of the pick that the job has.
    bool sceneIsDue = false;                 ///< It has not been sent the newest Scene.
    std::optional<std::uint32_t> answerDue;  ///< The change of its own that this Scene answers.
    bool restIsDue = false;                  ///< Its view is at rest, and was drawn as if it moved, as the scene did.
    SteadyClock::time_point joinedAt{};
    SteadyClock::time_point toldOfWaitUntil{};
    SteadyClock::time_point drawnAt{};     ///< When its last picture was finished.
    double pictureMs = 0;                  ///< What its pictures took, on average.
    std::uint64_t samples = 0;             ///< Of its last picture (samplesOf()).
    SteadyClock::time_point restsUntil{};  ///< Its views wait until then while others look.
    SteadyClock::time_point costlyFrom{};  ///< Views of about as many samples as `costlySamples` wait until then.
    std::uint64_t costlySamples = 0;
    bool heldBack = false;  ///< Its view waits for that reason.

    /// The viewer's own word is not enough: it might not even have read what it says it has shown.
    bool mayGetAnother() const { return port->isOpen() && unshown.size() < 2 && port->framesQueued() < 2; }
    bool can(Codec codec) const
    {
        return std::find(hello.codecs.begin(), hello.codecs.end(), codec) != hello.codecs.end();
    }
};

}  // namespace aeolic::stream
