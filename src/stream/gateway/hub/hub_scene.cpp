#include <fmt/format.h>

#include <algorithm>

#include "aeolic/error.h"
#include "description/scene_json.h"
#include "description/scene_surfaces.h"
#include "stream/gateway/hub/hub.h"

namespace aeolic::stream {
namespace {

constexpr int kMostEndedJobs = 2;              // A view that ended the job this often is not tried again.
constexpr std::size_t kMostDeadlyScenes = 64;  // More are not remembered.

std::string secondsText(SteadyClock::duration time)
{
    return fmt::format("{} s", std::chrono::ceil<std::chrono::seconds>(time).count());
}

}  // namespace

void Hub::tick()
{
    tellOfLoad();
    restIfDue();
    drawNext();
    sendPicks();
}

std::optional<std::string> Hub::overdue() const
{
    if (loading_ && now_() - loadHeard_ > options_.loadLimit)
        return "the renderer was loading for " + secondsText(options_.loadLimit) + " without getting on";
    if (!loading_ && !drawing_.empty() && now_() - std::max(drawing_.front().start, lastSent_) > options_.drawLimit)
        return "the renderer took more than " + secondsText(options_.drawLimit) + " for one picture";
    return std::nullopt;
}

void Hub::load(Load next)
{
    Json message{{"load", lastLoad_ + 1}, {"scene", Json::parse(sceneToJson(next.scene))}};
    if (!next.steer.is_null()) message["steer"] = next.steer;
    ++lastLoad_;
    loading_ = std::move(next);
    loadSent_ = loadHeard_ = now_();
    what_ = "loading";
    fraction_ = 0;
    toJob_(jsonMessage(MessageType::load, message.dump()));
    if (!sceneMessage_ || state_ != State::ready) setState(State::loading, "");
}

/// A change is mostly loaded in a moment, and nobody is told that something is loading. One that takes longer is told.
void Hub::tellOfLoad()
{
    if (loading_ && state_ == State::ready && now_() - loadSent_ >= kNoticeable) setState(State::loading, "");
}

void Hub::onScene(ByteView payload)
{
    Json scene = parseJson(payload);
    if (options_.ofProgram && !scene.contains("load")) return onProgramsScene(std::move(scene));
    if (!scene.contains("load") || scene["load"] != lastLoad_ || !loading_) return;
    scene.erase("load");
    framesInFlight_ = std::clamp<std::size_t>(scene.value("framesInFlight", 1u), 1, 2);
    scene.erase("framesInFlight");
    scene_ = options_.ofProgram ? sceneFromJson(scene.at("scene").dump(), "the program") : std::move(loading_->scene);
    chargeChange(loading_->askedBy, now_() - loadSent_);
    changedBy_ = loading_->askedBy;
    const std::uint32_t number = loading_->number;
    const bool takesAway = loading_->takesAway;
    if (takesAway) ++places_;
    loading_.reset();
    loadedAt_ = now_();
    nameSurfaces(scene, options_.scene);
    setScene(scene);
    if (const auto asker = viewers_.find(changedBy_); asker != viewers_.end()) answer(asker->second, number);
    // Changes that count surfaces as they were before may mean another surface now, or none.
    if (takesAway) refuseWaiting(kOtherPlaces, [this](const ChangeRequest& change) { return isOfOtherPlaces(change); });
    if (state_ != State::ready) setState(State::ready, "");
    drawAllAgain();
}

/// Everybody hears of the scene. Who still has pictures to read hears of the newest one with its next picture: scenes
/// may be large, and change faster than a slow line takes them.
void Hub::setScene(const Json& scene)
{
    viewOfScene_ = scene.value("view", Json());
    sceneMessage_ = jsonMessage(MessageType::scene, scene.dump());
    for (auto& [id, viewer] : viewers_) {
        viewer.sceneIsDue = true;
        if (viewer.port->framesQueued() == 0) tellScene(viewer);
    }
}

void Hub::tellScene(Viewer& to)
{
    if (std::exchange(to.sceneIsDue, false)) to.port->send(sceneMessage_);
    if (const auto number = std::exchange(to.answerDue, std::nullopt))
        to.port->send(numberMessage(MessageType::changed, *number));
}

/// Adds to a Scene what the job does not know: what viewers have changed of the surfaces of `original`.
void Hub::nameSurfaces(Json& scene, const SceneDescription& original) const
{
    scene["surface"] = surfaceName(scene_, original);
    scene["places"] = places_;
    scene["given"] = surfacesOf(original).size();
}

/// A program has changed its scene, or a control, unasked. What viewers have changed stays theirs.
void Hub::onProgramsScene(Json scene)
{
    const SceneDescription before = std::exchange(scene_, sceneFromJson(scene.at("scene").dump(), "the program"));
    const SceneDescription original = std::exchange(options_.scene, scene_);
    options_.scene.surface = original.surface;
    options_.scene.surfaces = original.surfaces;
    scene.erase("framesInFlight");
    nameSurfaces(scene, original);
    setScene(scene);
    if (sceneToJson(before) != sceneToJson(scene_)) onRenewed();
}

/// A program's data have changed: everyone sees its last view again. Frames that are being drawn go on, because data
/// that change faster than they are drawn must not stop the pictures.
void Hub::onRenewed()
{
    for (auto& [id, viewer] : viewers_)
        if (!viewer.wanted && viewer.following == 0) viewer.wanted = viewer.last;
    drawNext();
}

void Hub::onProgress(ByteView payload)
{
    const Json progress = parseJson(payload);
    if (progress.value("load", 0u) != lastLoad_ || !loading_) return;
    loadHeard_ = now_();
    what_ = progress.value("what", "");
    fraction_ = progress.value("fraction", 0.0);
    if (state_ == State::loading) toAll(stateMessage());
    tellOfLoad();
}

/// The job could not do what it was asked for, and goes on.
void Hub::onNotice(ByteView payload)
{
    const Json notice = parseJson(payload);
    const std::string message = notice.value("message", "");
    if (notice.contains("load")) {
        if (notice["load"] != lastLoad_ || !loading_) return;
        chargeChange(loading_->askedBy, now_() - loadSent_);
        const Load refused = std::move(*loading_);
        loading_.reset();
        if (const auto asker = viewers_.find(refused.askedBy); asker != viewers_.end())
            refuse(asker->second, refused.number, message);
        if (!sceneMessage_) {  // Not even the first could be loaded.
            sceneError_ = message;
            jobGivenUp(message);
            return;
        }
        if (!loadedAt_) {
            loadError_ = message;
            return;
        }
        if (state_ != State::ready) setState(State::ready, "");
        restIfDue();
        drawNext();  // What everybody sees is still right.
        return;
    }
    if (notice.contains("pick")) return failPick(notice["pick"].get<std::uint32_t>(), message);
    Drawing* drawing = drawingOf(notice.value("frame", 0u));
    if (!drawing) return;
    if (const auto owner = viewers_.find(drawing->viewer); owner != viewers_.end())
        notify(owner->second, "error", message);
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
        case MessageType::renewed:
            if (!options_.ofProgram) break;
            return onRenewed();
        case MessageType::progress:
            return onProgress(view.payload);
        case MessageType::notice:
            return onNotice(view.payload);
        case MessageType::picked:
            return onPicked(view.payload);
        case MessageType::tile:
            return onTile(message, view.payload);
        case MessageType::frameEnd:
            return onFrameEnd(message, view.payload);
        default:
            break;
    }
    throw ProtocolError("a message out of turn");
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
    load({scene_, 0, 0, {}, false});
}

bool Hub::jobEnded(const std::string& message)
{
    const bool idle = loadedAt_ && drawing_.empty() && now_() - *loadedAt_ >= kSettled;
    if (!drawing_.empty()) {  // If there are several, the first is to blame: frames are drawn in order.
        chargeWhatWasBegun(drawing_.front());
        const auto owner = viewers_.find(drawing_.front().viewer);
        if (owner != viewers_.end() && ++owner->second.endedJobs >= kMostEndedJobs) {
            owner->second.last.reset();
            owner->second.mayLookFrom = now_() + kPenalty;
            notify(owner->second, "error",
                   "the renderer ended twice while drawing this view; it is not tried again, and others only after a "
                   "minute");
        }
    }
    if (loading_ && loading_->askedBy != 0) {  // What ended the job is not tried again: back to the scene before.
        if (deadly_.size() < kMostDeadlyScenes) deadly_.insert(sceneToJson(loading_->scene));
        if (const auto asker = viewers_.find(loading_->askedBy); asker != viewers_.end()) {
            Viewer& viewer = asker->second;
            viewer.mayChangeFrom = now_() + kPenalty;
            const std::uint32_t newest = viewer.change ? viewer.change->number : loading_->number;
            viewer.change.reset();
            refuse(viewer, newest, "the renderer ended while loading this; the scene stays as it was");
        }
    }
    loading_.reset();  // What others want waits until the job is back.
    dropDrawing();
    forgetPicks();
    jobRuns_ = false;
    direct_.clear();
    ++restarts_;
    setState(State::restarting, message);
    loadError_.reset();
    loadedAt_.reset();
    return std::exchange(drewSinceStart_, false) || idle;
}

void Hub::jobGivenUp(const std::string& message)
{
    dropDrawing();
    forgetPicks();
    loading_.reset();
    jobRuns_ = false;
    setState(State::failed, message);
    refuseWaiting("the renderer is gone; the scene stays as it was", [](const ChangeRequest&) { return true; });
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
        if (viewer.wanted || viewer.following != 0) continue;
        viewer.wanted = viewer.last;
        viewer.againFor = changedBy_;
        // Its next view shows the scene in a moment. From where it looked before, nobody would see it.
        const bool isSeen = viewer.last && viewer.picture && viewer.picture->header.viewer == id &&
                            viewer.picture->header.view == viewer.last->view;
        const bool asksSoon = changedBy_ != 0 && isSeen && viewer.last->moving && looksAround(viewer);
        viewer.againFrom = asksSoon ? now_() + kNextView : SteadyClock::time_point{};
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
    return jsonMessage(MessageType::state, jsonText(state));
}

}  // namespace aeolic::stream
