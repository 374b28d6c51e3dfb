#include <algorithm>

#include "aeolic/error.h"
#include "description/scene_json.h"
#include "stream/gateway/hub.h"

namespace aeolic::stream {
namespace {

constexpr int kMostEndedJobs = 2;  // A view that ended the job this often is not tried again.

}  // namespace

void Hub::onChange(Viewer& from, const ChangeRequest& change)
{
    SceneDescription changed;
    try {
        changed = withChange(loading_.value_or(scene_), options_.scene, change);
    } catch (const InputError& error) {
        notify(from, "error", error.what(), true);
        return;
    }
    if (!jobRuns_)
        notify(from, "error", "the scene can be changed once the renderer is back", true);
    else
        load(changed, from.id);
}

/// Several changes in a row are loaded one after the other by the job; only the last one's outcome counts.
void Hub::load(const SceneDescription& scene, std::uint32_t askedBy)
{
    const bool quietly = sceneMessage_ && state_ == State::ready && differOnlyInTime(scene, scene_);
    loading_ = scene;
    loadAskedBy_ = askedBy;
    const Json message{{"load", ++lastLoad_}, {"scene", Json::parse(sceneToJson(scene))}};
    toJob_(jsonMessage(MessageType::load, message.dump()));
    if (quietly) return;  // Another moment is mostly at hand, so nobody is told that something is loading.
    what_ = "loading";
    fraction_ = 0;
    setState(State::loading, "");
}

void Hub::onScene(ByteView payload)
{
    Json scene = parseJson(payload);
    if (!scene.contains("load") || scene["load"] != lastLoad_ || !loading_) return;
    scene.erase("load");
    framesInFlight_ = std::clamp<std::size_t>(scene.value("framesInFlight", 1u), 1, 2);
    scene.erase("framesInFlight");
    scene_ = std::move(*loading_);
    loading_.reset();
    loadedAt_ = now_();
    const bool original = scene_.surface.spec == options_.scene.surface.spec;
    scene["surface"] = original ? "original" : scene_.surface.spec;
    sceneMessage_ = jsonMessage(MessageType::scene, scene.dump());
    toAll(sceneMessage_);
    if (state_ != State::ready) setState(State::ready, "");
    drawAllAgain();
}

void Hub::onProgress(ByteView payload)
{
    const Json progress = parseJson(payload);
    if (progress.value("load", 0u) != lastLoad_ || state_ != State::loading) return;
    what_ = progress.value("what", "");
    fraction_ = progress.value("fraction", 0.0);
    toAll(stateMessage());
}

/// The job could not do what it was asked for, and goes on.
void Hub::onNotice(ByteView payload)
{
    const Json notice = parseJson(payload);
    const std::string message = notice.value("message", "");
    if (notice.contains("load")) {
        if (notice["load"] != lastLoad_ || !loading_) return;
        loading_.reset();
        if (const auto asker = viewers_.find(loadAskedBy_); asker != viewers_.end())
            notify(asker->second, "error", message, true);
        if (!sceneMessage_) {  // Not even the first could be loaded.
            sceneError_ = message;
            jobGivenUp(message);
            return;
        }
        if (!loadedAt_) {
            loadError_ = message;
            return;
        }
        setState(State::ready, "");
        drawAllAgain();
        return;
    }
    Drawing* drawing = drawingOf(notice.value("frame", 0u));
    if (!drawing) return;
    if (const auto owner = viewers_.find(drawing->viewer); owner != viewers_.end())
        notify(owner->second, "error", message, false);
    drop(*drawing);
    drawNext();
}

void Hub::jobSaid(const WireMessage& message)
{
    const MessageView view = parseMessage(*message, Sender::rank);
    try {
        take(message, view);
    } catch (const Json::exception&) {
        throw ProtocolError("JSON of another kind");
    }
}

void Hub::take(const WireMessage& message, const MessageView& view)
{
    switch (view.type) {
        case MessageType::scene:
            return onScene(view.payload);
        case MessageType::progress:
            return onProgress(view.payload);
        case MessageType::notice:
            return onNotice(view.payload);
        case MessageType::tile:
            return onTile(message, view.payload);
        case MessageType::frameEnd:
            return onFrameEnd(message, view.payload);
        default:
            throw ProtocolError("a message out of turn");
    }
}

void Hub::jobStarting()
{
    if (state_ != State::restarting) {
        what_ = "starting the renderer";
        fraction_ = 0;
        setState(State::loading, "");
    }
}

void Hub::jobStarted(int ranks, const std::vector<DirectPlace>& direct)
{
    direct_ = direct;
    jobRuns_ = true;
    drewSinceStart_ = false;
    loadedAt_.reset();
    loadError_.reset();
    ranks_ = ranks;
    for (auto& [id, viewer] : viewers_) offerDirect(viewer);
    load(scene_, 0);
}

bool Hub::jobEnded(const std::string& message)
{
    const bool idle = loadedAt_ && drawing_.empty() && now_() - *loadedAt_ >= kSettled;
    if (!drawing_.empty()) {  // If there are several, the first is to blame: frames are drawn in order.
        const auto owner = viewers_.find(drawing_.front().viewer);
        if (owner != viewers_.end() && ++owner->second.endedJobs >= kMostEndedJobs) {
            owner->second.last.reset();
            notify(owner->second, "error", "the renderer ended twice while drawing this view; it is not tried again",
                   false);
        }
    }
    if (loading_ && sceneMessage_)
        if (const auto asker = viewers_.find(loadAskedBy_); asker != viewers_.end())
            notify(asker->second, "error", "the renderer ended while loading this; the scene stays as it was", true);
    loading_.reset();  // The scene that ended the job is not tried again: the one before is loaded.
    dropDrawing();
    jobRuns_ = false;
    direct_.clear();
    ++restarts_;
    setState(State::restarting, message);
    loadError_.reset();
    loadedAt_.reset();
    return std::exchange(drewSinceStart_, false) || idle;
}

void Hub::jobWaits(const std::string& message)
{
    setState(State::restarting, message);
}

void Hub::jobGivenUp(const std::string& message)
{
    dropDrawing();
    jobRuns_ = false;
    setState(State::failed, message);
}

void Hub::jobCannotStart(const std::string& message)
{
    if (!sceneMessage_) sceneError_ = message;
    jobGivenUp(message);
}

void Hub::drawAllAgain()
{
    dropDrawing();  // These frames show the scene before.
    for (auto& [id, viewer] : viewers_) {
        if (!viewer.wanted && viewer.following == 0) viewer.wanted = viewer.last;
        viewer.unshown.clear();
    }
    drawNext();
}

void Hub::setState(State state, const std::string& message)
{
    state_ = state;
    message_ = message;
    toAll(stateMessage());
}

const char* Hub::stateName() const
{
    constexpr const char* names[] = {"loading", "ready", "restarting", "failed"};
    return names[int(state_)];
}

WireMessage Hub::stateMessage() const
{
    Json list = Json::array();
    for (const auto& [id, viewer] : viewers_) list.push_back({{"viewer", id}, {"name", viewer.hello.name}});
    const bool loading = state_ == State::loading;
    const Json state{{"state", stateName()},
                     {"what", loading ? what_ : ""},
                     {"fraction", loading ? fraction_ : 1.0},
                     {"message", message_},
                     {"ranks", ranks_},
                     {"restarts", restarts_},
                     {"viewers", list}};
    return jsonMessage(MessageType::state, state.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace aeolic::stream
