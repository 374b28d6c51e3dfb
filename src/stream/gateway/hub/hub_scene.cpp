#include <fmt/format.h>

#include <algorithm>

#include "aeolic/error.h"
#include "description/scene_json.h"
#include "description/surface_spec.h"
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

void Hub::onChange(Viewer& from, const ChangeRequest& change)
{
    SceneDescription changed;
    std::string text;
    const SceneDescription& before = pending_ ? pending_->scene : loading_ ? loading_->scene : scene_;
    try {
        changed = withChange(before, options_.scene, change);
        text = sceneToJson(changed);
        if (deadly_.contains(text))
            throw InputError("change", "the renderer ended while loading this before", "another change");
        if (now_() < from.mayChangeFrom)
            throw InputError("change", "a change of yours ended the renderer",
                             "none from you for another " + secondsText(from.mayChangeFrom - now_()));
        if (!jobRuns_) throw InputError("the scene can be changed once the renderer is back");
        if (!change.steer.is_null() && !options_.ofProgram)
            throw InputError("change: steer", "found where nothing can be steered", "a program that has controls");
    } catch (const InputError& error) {
        notify(from, "error", error.what(), true);
        return;
    }
    // Nothing changes, so nobody else waits for it. While something is loaded that is not known yet: it may be refused.
    // A Scene may be large, so its sender gets no more of them than it may make changes.
    if (!pending_ && !loading_ && change.steer.is_null() && text == sceneToJson(before)) {
        if (!from.changes.has(now_()))
            return notify(from, "warning", "these are too many changes that change nothing", true);
        from.changes.take();
        return from.port->send(sceneMessage_);
    }
    Load next = pending_ ? std::move(*pending_) : Load{};
    next.scene = std::move(changed);
    next.askedBy = from.id;
    next.askers.insert(from.id);
    if (!change.steer.is_null()) next.steer.update(change.steer);
    pending_ = std::move(next);
    loadPending();
}

/// Sends the job what is pending, if its turn has come: one Load is on its way at a time, and all changes that come
/// meanwhile are merged into the next one.
void Hub::loadPending()
{
    if (!pending_ || loading_ || !jobRuns_) return;
    if (state_ == State::ready && !drewSinceLoad_ && !drawing_.empty()) return;  // Its frame comes first.
    if (!pendingIsDue()) return;                                                 // tick() comes back to it.
    Load next = std::move(*pending_);
    pending_.reset();
    for (const std::uint32_t id : next.askers)
        if (const auto asker = viewers_.find(id); asker != viewers_.end()) asker->second.changes.take();
    load(std::move(next));
}

/// Whether what is pending need not wait any longer. Another moment never waits, so that time can be played.
bool Hub::pendingIsDue()
{
    if (!pending_) return false;
    const bool inTime =
        pending_->scene.time.moment != scene_.time.moment && differInWhatIsShown(pending_->scene, scene_);
    if (inTime) return true;
    return now_() - loadSent_ >= kBetweenLoads &&
           std::any_of(pending_->askers.begin(), pending_->askers.end(), [&](std::uint32_t id) {
               const auto asker = viewers_.find(id);
               return asker == viewers_.end() || asker->second.changes.has(now_());
           });
}

void Hub::tick()
{
    drawNext();
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
    const bool quietly = sceneMessage_ && state_ == State::ready && differInWhatIsShown(next.scene, scene_);
    Json message{{"load", lastLoad_ + 1}, {"scene", Json::parse(sceneToJson(next.scene))}};
    if (!next.steer.is_null()) message["steer"] = next.steer;
    ++lastLoad_;
    loading_ = std::move(next);
    loadHeard_ = now_();
    if (loading_->askedBy != 0) loadSent_ = loadHeard_;
    drewSinceLoad_ = loading_->askedBy == 0;
    toJob_(jsonMessage(MessageType::load, message.dump()));
    if (quietly) return;  // What else is shown is mostly at hand, so nobody is told that something is loading.
    what_ = "loading";
    fraction_ = 0;
    setState(State::loading, "");
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
    loading_.reset();
    loadedAt_ = now_();
    nameSurfaces(scene, options_.scene);
    sceneMessage_ = jsonMessage(MessageType::scene, scene.dump());
    toAll(sceneMessage_);
    if (state_ != State::ready) setState(State::ready, "");
    drawAllAgain();
}

/// Adds to a Scene what the job does not know: what viewers have changed of the surfaces of `original`.
void Hub::nameSurfaces(Json& scene, const SceneDescription& original) const
{
    scene["surface"] = surfaceName(scene_, original);
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
    sceneMessage_ = jsonMessage(MessageType::scene, scene.dump());
    toAll(sceneMessage_);
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
    if (progress.value("load", 0u) != lastLoad_ || state_ != State::loading) return;
    loadHeard_ = now_();
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
        const std::uint32_t askedBy = loading_->askedBy;
        loading_.reset();
        drewSinceLoad_ = true;  // The scene is the one before.
        if (const auto asker = viewers_.find(askedBy); asker != viewers_.end())
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
        drawNext();  // What everybody sees is still right.
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
        case MessageType::renewed:
            if (!options_.ofProgram) break;
            return onRenewed();
        case MessageType::progress:
            return onProgress(view.payload);
        case MessageType::notice:
            return onNotice(view.payload);
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
    load({scene_, 0, {}, {}});
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
                   "minute",
                   false);
        }
    }
    if (loading_ && loading_->askedBy != 0) {  // What ended the job is not tried again: back to the scene before.
        if (deadly_.size() < kMostDeadlyScenes) deadly_.insert(sceneToJson(loading_->scene));
        if (const auto asker = viewers_.find(loading_->askedBy); asker != viewers_.end()) {
            asker->second.mayChangeFrom = now_() + kPenalty;
            notify(asker->second, "error", "the renderer ended while loading this; the scene stays as it was", true);
        }
    }
    if (pending_)
        if (const auto asker = viewers_.find(pending_->askedBy); asker != viewers_.end())
            notify(asker->second, "error", "the renderer ended before this was loaded; the scene stays as it was",
                   true);
    loading_.reset();
    pending_.reset();
    drewSinceLoad_ = true;
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
