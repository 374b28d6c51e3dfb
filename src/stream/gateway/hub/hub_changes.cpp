#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "aeolic/error.h"
#include "description/scene_json.h"
#include "description/scene_surfaces.h"
#include "stream/gateway/hub/hub.h"

/// Changes of the scene that all viewers share. A change that waits stays with its viewer, one of each viewer, so
/// that it does not depend on another viewer's change, which may be refused.
namespace aeolic::stream {

constexpr std::size_t kMostSteered = 64;  // As many controls as a program can have.

void Hub::onChange(Viewer& from, ChangeRequest change)
{
    const std::uint32_t number = change.number;
    from.movesScene = change.moving;
    from.changeCame = now_();
    ChangeRequest wishes = from.change.value_or(ChangeRequest{});
    merge(wishes, std::move(change));
    try {
        if (state_ == State::failed) throw InputError("the scene can be changed once the renderer is back");
        if (!wishes.steer.is_null() && !options_.ofProgram)
            throw InputError("change: steer", "found where nothing can be steered", "a program that has controls");
        if (wishes.steer.size() > kMostSteered)
            throw InputError("change: steer", fmt::format("found {} controls", wishes.steer.size()),
                             fmt::format("at most {}", kMostSteered));
        // Whether the places still count is known when a surface is gone, or is not.
        const bool isKnown = !loading_ || !loading_->takesAway || !wishes.places;
        const std::optional<SceneDescription> next =
            isKnown ? std::optional(changed(from, wishes)) : std::optional<SceneDescription>();
        // What is there needs no turn. While something is loaded it is not known yet what will be there.
        if (!loading_ && wishes.steer.is_null() && sceneToJson(*next) == sceneToJson(scene_)) {
            from.change.reset();
            answer(from, number);
        } else {
            if (!from.change) from.changeSince = now_();
            from.change = std::move(wishes);
        }
    } catch (const InputError& error) {
        refuseNewest(from, number, error.what());
    }
    restIfDue();
    drawNext();
}

/// The scene with a viewer's change laid over the scene that is loaded, or is being loaded. Throws InputError where
/// the change is not allowed.
SceneDescription Hub::changed(const Viewer& from, const ChangeRequest& change) const
{
    if (isOfOtherPlaces(change)) throw InputError(kOtherPlaces);
    SceneDescription next = withChange(loading_ ? loading_->scene : scene_, options_.scene, change);
    if (deadly_.contains(sceneToJson(next)))
        throw InputError("change", "the renderer ended while loading this before", "another change");
    if (now_() < from.mayChangeFrom)
        throw InputError("change", "a change of yours ended the renderer",
                         fmt::format("none from you for another {} s",
                                     std::chrono::ceil<std::chrono::seconds>(from.mayChangeFrom - now_()).count()));
    return next;
}

/// Whether a change counts surfaces by what they were before some were taken away.
bool Hub::isOfOtherPlaces(const ChangeRequest& change) const
{
    return change.places && *change.places != places_ && (!change.cuts.empty() || change.shown);
}

/// Whether a viewer's change need not wait for the viewer itself: it has room for the picture that will show it. So
/// changes come no faster than they are seen, however slow the line is. Who never says what it sees waits for a while.
/// And where others look around it has rested after its last change.
bool Hub::mayChange(const Viewer& viewer) const
{
    if (!viewer.change) return false;
    if (now_() < std::max(viewer.restsUntil, viewer.changesFrom) && othersWhoLookAround(viewer) > 0) return false;
    return mayGetAnother(viewer) || now_() - viewer.changeSince >= kPatience;
}

/// What a change took is lost to all others: the load, the first picture of it, and the pictures of those who only
/// watch. So the next one waits for twice as long, once for each of those who look around and once more: changes take
/// a fifth of the time where one looks around, a seventh where two do. They lose more than that where the browsers run
/// on the same processor. A viewer that is alone does not wait, however many changes it makes.
void Hub::chargeChange(std::uint32_t by, SteadyClock::duration took)
{
    const auto asker = viewers_.find(by);
    if (asker == viewers_.end()) return;
    Viewer& viewer = asker->second;
    viewer.changeHad += std::chrono::duration<double, std::milli>(took).count();
    viewer.changesFrom = std::max(viewer.changesFrom, now_()) + restAfterChange(viewer, took);
}

/// Another picture of the viewer that changes the scene: of a camera that moves with it, or of a person who plays time
/// and turns the camera. Such pictures put off the next change, but by no more than half the time that passes between
/// them, so that it comes.
void Hub::chargeOwnPicture(Viewer& viewer, SteadyClock::duration took)
{
    if (!movesScene(viewer)) return;
    const auto rest = std::min<SteadyClock::duration>(restAfterChange(viewer, took), kNoticeable / 2);
    viewer.changesFrom = std::max(viewer.changesFrom, now_()) + rest;
}

SteadyClock::duration Hub::restAfterChange(const Viewer& viewer, SteadyClock::duration took) const
{
    const int others = othersWhoLookAround(viewer);
    return others > 0 ? std::min<SteadyClock::duration>(2 * (others + 1) * took, kLongestRest)
                      : SteadyClock::duration{};
}

/// Whether a view of the viewer that changes the scene is seen soon enough in the next picture of a change, so that
/// the others lose no other picture by it.
bool Hub::comesWithChange(const Viewer& viewer) const
{
    return viewer.change && now_() - viewer.wantedSince < kNoticeable && othersWhoLookAround(viewer) > 0;
}

/// Whether a viewer turns its camera or changes its options just now. Who only watches loses nothing by changes.
bool Hub::looksAround(const Viewer& viewer) const
{
    const std::chrono::duration<double, std::milli> ago = now_() - viewer.lookedAt, soon = kSoon;
    return viewer.port->isOpen() && ago.count() < soon.count() + 2 * viewer.pictureMs;
}

int Hub::othersWhoLookAround(const Viewer& viewer) const
{
    return int(std::count_if(viewers_.begin(), viewers_.end(),
                             [&](const auto& entry) { return entry.first != viewer.id && looksAround(entry.second); }));
}

/// Has the job load a change whose turn has come.
void Hub::beginChange(Viewer& of)
{
    const ChangeRequest change = std::move(*of.change);
    of.change.reset();
    try {
        SceneDescription next = changed(of, change);
        const bool takesAway = surfacesOf(next).size() < surfacesOf(scene_).size() ||
                               std::any_of(change.cuts.begin(), change.cuts.end(),
                                           [](const auto& cut) { return !cut.second.has_value(); });
        if (!change.steer.is_null() || sceneToJson(next) != sceneToJson(scene_))
            return load({std::move(next), of.id, change.number, change.steer, takesAway});
        answer(of, change.number);
    } catch (const InputError& error) {
        refuse(of, change.number, error.what());
    }
}

/// The viewer's changes up to this one wait no more.
void Hub::answer(Viewer& viewer, std::uint32_t change)
{
    viewer.changeCame = now_();
    viewer.answerDue = change;
    tellScene(viewer);
}

/// Refuses the newest change of a viewer. The answer says that those before are done or refused, too. So it comes with
/// theirs where one waits or is being loaded.
void Hub::refuseNewest(Viewer& viewer, std::uint32_t change, const std::string& message)
{
    notify(viewer, "error", message, true);
    if (viewer.change)
        viewer.change->number = change;
    else if (loading_ && loading_->askedBy == viewer.id)
        loading_->number = change;
    else
        answer(viewer, change);
}

void Hub::refuse(Viewer& viewer, std::uint32_t change, const std::string& message)
{
    notify(viewer, "error", message, true);
    answer(viewer, change);
}

/// Refuses those of the changes that wait for which `which` is true.
void Hub::refuseWaiting(const std::string& message, const std::function<bool(const ChangeRequest&)>& which)
{
    for (auto& [id, viewer] : viewers_)
        if (viewer.change && which(*viewer.change)) {
            const std::uint32_t number = viewer.change->number;
            viewer.change.reset();
            refuse(viewer, number, message);
        }
}

/// Whether somebody changes the scene all the time, as while a slider is dragged or time is played: pictures for
/// everybody are then those of motion.
bool Hub::sceneMoves() const
{
    return std::any_of(viewers_.begin(), viewers_.end(), [&](const auto& entry) { return movesScene(entry.second); });
}

bool Hub::movesScene(const Viewer& viewer) const
{
    const bool waits = viewer.change || (loading_ && loading_->askedBy == viewer.id);
    return viewer.movesScene && (waits || now_() - viewer.changeCame < kMovesFor);
}

/// Once the scene rests, every viewer whose view is at rest gets a picture at rest.
void Hub::restIfDue()
{
    if (sceneMoves()) return;
    for (auto& [id, viewer] : viewers_) {
        if (!std::exchange(viewer.restIsDue, false) || viewer.wanted || viewer.following != 0) continue;
        viewer.wanted = viewer.last;
    }
}

}  // namespace aeolic::stream
