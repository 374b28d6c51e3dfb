#include "stream/gateway/hub/hub.h"
#include "stream/token.h"
#include "version.h"

namespace aeolic::stream {

Hub::Hub(Options options, std::function<void(WireMessage)> toJob, Now now)
    : options_(std::move(options)), toJob_(std::move(toJob)), now_(std::move(now)), scene_(options_.scene)
{
}

std::uint32_t Hub::join(ViewerPort& port, const Hello& hello)
{
    const std::uint32_t id = ++lastViewer_;
    Viewer& viewer = viewers_[id];
    viewer.id = id;
    viewer.port = &port;
    viewer.hello = hello;
    viewer.joinedAt = now_();
    Json codecs = Json::array();
    for (const Codec codec : hello.codecs) codecs.push_back(std::string(codecName(codec)));
    const Json welcome{{"protocol", kProtocolVersion},
                       {"version", versionText},
                       {"viewer", id},
                       {"codecs", codecs},
                       {"limits", {{"largestSide", options_.largestSide}, {"viewsPerSecond", 120}}},
                       {"state", parseJson(parseMessage(*stateMessage(), Sender::gateway).payload)}};
    try {
        port.send(jsonMessage(MessageType::welcome, welcome.dump()));
        toAll(stateMessage());
        if (sceneMessage_) port.send(sceneMessage_);
        offerDirect(viewer);
        viewer.changesFrom = changesFromOfLeft_;
    } catch (...) {
        viewers_.erase(id);  // Nobody will call leave().
        throw;
    }
    return id;
}

/// Offers the ranks' addresses to a viewer that can connect to them; each address once.
void Hub::offerDirect(Viewer& to)
{
    if (!to.hello.direct || direct_.empty()) return;
    const std::string token = makeToken();
    toJob_(jsonMessage(MessageType::invite, Json{{"viewer", to.id}, {"token", token}}.dump()));
    Json direct = Json::array();
    for (std::size_t rank = 0; rank < direct_.size(); ++rank)
        direct.push_back(
            {{"rank", rank}, {"host", direct_[rank].host}, {"port", direct_[rank].port}, {"token", token}});
    to.port->send(jsonMessage(MessageType::offer, Json{{"direct", direct}}.dump()));
}

void Hub::leave(std::uint32_t id)
{
    for (Drawing& drawing : drawing_) drawing.recipients.erase(id);
    if (const auto left = viewers_.find(id); left != viewers_.end()) {  // Not so after dismissAll().
        changesFromOfLeft_ = std::max(changesFromOfLeft_, left->second.changesFrom);
        viewers_.erase(left);
    }
    for (auto& [other, viewer] : viewers_)
        if (viewer.following == id) viewer.following = 0;
    toAll(stateMessage());
}

void Hub::receive(std::uint32_t id, const MessageView& message)
{
    Viewer& from = viewer(id);
    const auto number = [&] {
        WireReader reader(message.payload);
        const std::uint32_t value = reader.u32();
        reader.expectEnd();
        return value;
    };
    switch (message.type) {
        case MessageType::view:
            return onView(from, viewFrom(parseJson(message.payload), options_.largestSide));
        case MessageType::shown:
            return onShown(from, number());
        case MessageType::change:
            return onChange(from, changeFrom(parseJson(message.payload)));
        case MessageType::follow:
            return onFollow(from, number());
        case MessageType::start:
            return onStart(from);
        case MessageType::pick:
            return onPick(from, pickFrom(parseJson(message.payload), options_.largestSide));
        default:
            throw ProtocolError("a message out of turn");
    }
}

void Hub::onView(Viewer& from, ViewRequest request)
{
    // It is laid over the scene only when its turn to be drawn comes: most views never are, a newer one replaces them.
    from.following = 0;
    from.lookedAt = now_();
    if (!from.views.take(now_())) {
        from.timeHad += kTooManyMs;
        from.restsUntil = std::max(from.restsUntil, now_()) + kTooManyRest;
    }
    if (!from.wanted || from.againFor != 0) from.wantedSince = now_();
    from.againFrom = {};
    from.againFor = 0;
    from.wanted = std::move(request);
    drawNext();
}

void Hub::onShown(Viewer& from, std::uint32_t frame)
{
    // No viewer that shows its pictures says this. Nothing paces one whose word is not true, so the others come first.
    if (frame > lastFrame_) from.restsUntil = std::max(from.restsUntil, now_() + kUntrueRest);
    bool known = false;
    while (!from.unshown.empty() && from.unshown.front() <= frame) {
        known = known || from.unshown.front() == frame;
        from.unshown.pop_front();
    }
    if (known && from.picture && from.picture->header.frame == frame) {
        const StoredFrame& shown = *from.picture;
        const double showMs = std::chrono::duration<double, std::milli>(now_() - shown.sent).count();
        from.pace.add({shown.drawMs, showMs, double(shown.bytes), shown.moving});
    }
    goOn(from);
}

/// A frame is no longer on its way to a viewer.
void Hub::goOn(Viewer& to)
{
    if (to.port->framesQueued() == 0) tellScene(to);
    catchUp(to);
    drawNext();
}

void Hub::onFollow(Viewer& from, std::uint32_t other)
{
    if (other != 0 && (other == from.id || !viewers_.count(other))) {
        notify(from, "error", "there is no such viewer to follow");
        return;
    }
    from.following = other;
    if (other != 0) from.wanted.reset();  // Its own view is not what it looks at now.
    catchUp(from);
}

/// A job that was given up is tried once more. Everyone may ask, but not all the time: a start may cost minutes.
void Hub::onStart(Viewer& from)
{
    if (state_ != State::failed) return notify(from, "info", "the renderer is being looked after already");
    if (startAskedFor_) return;
    if (now_() < mayStartFrom_) return notify(from, "info", "the renderer was started a moment ago");
    startAskedFor_ = true;
    mayStartFrom_ = now_() + kBetweenStarts;
}

/// A follower that had no room for a frame gets the newest one when it has room.
void Hub::catchUp(Viewer& follower)
{
    const auto followed = viewers_.find(follower.following);
    if (followed == viewers_.end() || !followed->second.picture || !mayGetAnother(follower)) return;
    const auto picture = followed->second.picture;
    if (follower.picture == picture) return;
    if (picture->moving && !follower.can(picture->codec)) return;  // It gets the picture at rest.
    // The picture went past the gateway, or it was drawn before the follower came. It is drawn once more, in a codec
    // that both can decode.
    if (picture->incomplete || !follower.can(picture->codec)) {
        if (!followed->second.wanted) followed->second.wanted = followed->second.last;
        return drawNext();
    }
    tellScene(follower);
    follower.port->send(frameMessage(picture->header));
    for (const WireMessage& tile : picture->tiles) follower.port->send(tile);
    follower.port->send(picture->end);
    follower.unshown.push_back(picture->header.frame);
    follower.picture = picture;
}

void Hub::toAll(const WireMessage& message)
{
    for (auto& [id, viewer] : viewers_) viewer.port->send(message);
}

void Hub::notify(Viewer& to, const char* level, const std::string& message, bool ofChange)
{
    const Json notice{{"level", level}, {"message", message}, {"change", ofChange}};
    to.port->send(jsonMessage(MessageType::notice, jsonText(notice)));
}

HubStatus Hub::status() const
{
    const bool draws = state_ == State::ready && !drawing_.empty();
    return {draws ? "rendering" : stateName(), ranks_, int(viewers_.size()), restarts_, framesDrawn_};
}

}  // namespace aeolic::stream
