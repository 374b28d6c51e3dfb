#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/median.h"
#include "stream/gateway/hub/hub.h"

namespace aeolic::stream {
namespace {

// A viewer whose pictures take this many times what others' take pays for each of them this many times its time.
constexpr double kCostly = 4;
constexpr double kSlackMs = 100;
constexpr double kNewest = 0.5;  // The weight of the newest picture in a viewer's mean.
// Fewer samples say little about how long many take: on a busy machine any picture may take a tenth of a second.
constexpr std::uint64_t kTellingSamples = std::uint64_t{1} << 24;

}  // namespace

/// When much memory is taken, a viewer that still has a frame to read gets no other.
bool Hub::mayGetAnother(const Viewer& of) const
{
    return of.mayGetAnother() && (frameBytes() <= options_.frameBytes / 2 || of.port->framesQueued() == 0);
}

/// Takes the next action: draws the newest view of a viewer, or begins the change that one wants. The turn is that of
/// the one that has had the least time, and where that is the same, of the next one after the viewer served last. So a
/// viewer that moves without end, changes the scene without end, or asks for much work, does not starve the others.
/// (Start-time fair queueing, Goyal et al. 1996.) False where nothing can be done now.
bool Hub::takeTurn()
{
    if (showChange()) return true;
    for (const Turn& next : turns()) {
        Viewer& viewer = *next.viewer;
        if (!next.isChange && isAheadOfOthers(viewer)) continue;
        if (next.isChange && !drawing_.empty()) return false;  // What is being drawn is finished first.
        if (next.isChange)
            beginChange(viewer);
        else if (!draw(viewer))
            continue;
        lastDrawn_ = viewer.id;
        timeGiven_ = next.had;
        return true;
    }
    return false;
}

/// All actions that are possible now, the first one to do at the front.
std::vector<Hub::Turn> Hub::turns()
{
    std::vector<Turn> all;
    // Whoever was idle gets no time afterwards for that.
    const auto add = [&](Viewer& viewer, bool isChange, double& had) {
        had = std::max(had, timeGiven_);
        all.push_back({&viewer, isChange, had});
    };
    for (auto& [id, viewer] : viewers_) {
        if (mayChange(viewer)) add(viewer, true, viewer.changeHad);
        const bool isDue = viewer.wanted && now_() >= std::max(viewer.mayLookFrom, viewer.againFrom);
        if (isDue && mayGetAnother(viewer) && !comesWithChange(viewer)) add(viewer, false, viewer.timeHad);
    }
    std::stable_sort(all.begin(), all.end(), [&](const Turn& a, const Turn& b) {
        const auto place = [&](const Turn& t) { return std::pair(t.had, t.viewer->id - lastDrawn_ - 1); };
        return place(a) < place(b);
    });
    return all;
}

/// Draws the first picture of a change that was loaded, for the viewer that asked for it, or for the one it follows. It
/// belongs to the change: changes without end do not stop the pictures.
bool Hub::showChange()
{
    const auto asker = viewers_.find(std::exchange(changedBy_, 0));
    if (asker == viewers_.end()) return false;
    const auto followed = viewers_.find(asker->second.following);
    Viewer& seen = followed != viewers_.end() ? followed->second : asker->second;
    if (!seen.wanted || now_() < seen.mayLookFrom || !mayGetAnother(seen) || !draw(seen)) return false;
    drawing_.back().paidBy = asker->first;
    return true;
}

/// Whether others that had less time will ask again in a moment: between two of their views, when nobody else waits,
/// a costly picture would hold them up for as long as it takes. Viewers that are blocked or have stopped do not count.
bool Hub::isAheadOfOthers(const Viewer& viewer) const
{
    return std::any_of(viewers_.begin(), viewers_.end(), [&](const auto& entry) {
        const Viewer& other = entry.second;
        return other.id != viewer.id && now_() - other.drawnAt < kSoon &&
               std::max(other.timeHad, timeGiven_) + kSlackMs + 2 * other.pictureMs < viewer.timeHad;
    });
}

/// Whether a viewer has a view to be drawn, or got a picture so lately that it will ask for another one. A viewer
/// that is held back, or has no room for a picture, keeps nobody waiting.
bool Hub::looks(const Viewer& viewer, SteadyClock::duration lately) const
{
    return !viewer.heldBack && mayGetAnother(viewer) && now_() >= viewer.mayLookFrom &&
           (viewer.wanted || now_() - viewer.drawnAt < lately);
}

int Hub::othersWhoLook(const Viewer& viewer, SteadyClock::duration lately) const
{
    return int(std::count_if(viewers_.begin(), viewers_.end(), [&](const auto& entry) {
        return entry.first != viewer.id && looks(entry.second, lately);
    }));
}

/// Turns alone do not bound what a viewer takes: where the others think for a moment after each picture, a viewer that
/// always asks would be drawn in every such moment. So a viewer that had more than its share rests while others look.
///
/// A picture of seconds is held back until its viewer has been here, without such a picture, for as long as it would
/// rest for it. Else a viewer that connects again and again would have one each time.
SteadyClock::time_point Hub::waitsUntil(const Viewer& viewer, const SceneDescription& scene) const
{
    const int others = othersWhoLook(viewer, kSoon);
    if (others == 0) return {};
    SteadyClock::time_point until = viewer.restsUntil;
    if (samplesOf(scene) >= viewer.costlySamples / 2) until = std::max(until, viewer.costlyFrom);
    const auto expected = expectedTime(scene);
    return expected > kLong ? std::max(until, viewer.joinedAt + restAfter(expected, others)) : until;
}

SteadyClock::duration Hub::restAfter(SteadyClock::duration picture, int others) const
{
    return std::min<SteadyClock::duration>(int(kCostly) * others * picture, kLongestRest);
}

/// Says it once for each time of waiting, and only where somebody would notice.
void Hub::tellOfWait(Viewer& viewer, SteadyClock::time_point until)
{
    if (until - now_() < kLong || now_() < viewer.toldOfWaitUntil) return;
    viewer.toldOfWaitUntil = until;
    const auto left = std::chrono::ceil<std::chrono::seconds>(until - now_());
    notify(
        viewer, "warning",
        fmt::format("this picture waits, because others look: it is drawn when they do not, or in {} s", left.count()));
}

/// What a picture took counts for its viewer, unless it belongs to a change.
void Hub::charge(Viewer& of, double ms, std::uint64_t samples, bool isOfChange)
{
    std::vector<double> othersMs, othersSamples;
    for (const auto& [id, viewer] : viewers_)
        if (id != of.id && viewer.pictureMs > 0) {
            othersMs.push_back(viewer.pictureMs);
            othersSamples.push_back(double(viewer.samples));
        }
    of.pictureMs = of.pictureMs > 0 ? of.pictureMs + kNewest * (ms - of.pictureMs) : ms;
    of.samples = samples;
    const bool slow = !othersMs.empty() && ms > kCostly * median(othersMs);
    // A picture that something else held up is slow, but another one like it need not be.
    if (slow && double(samples) > kCostly * median(othersSamples)) {
        const std::chrono::duration<double, std::milli> drawn(ms);
        const int others = othersWhoLook(of, kSoon + std::chrono::ceil<SteadyClock::duration>(drawn));
        of.costlyFrom = now_() + restAfter(std::chrono::ceil<SteadyClock::duration>(drawn), others);
        of.costlySamples = samples;
        if (!isOfChange)
            of.timeHad += std::min(ms, kSlackMs);  // The rest pays for the picture, so light views need not.
    } else if (!isOfChange) {
        of.timeHad += (slow ? kCostly : 1) * ms;
    }
    of.drawnAt = now_();
}

/// A costly picture that the job did not live to finish took its time, too. Without this it would be the first one
/// again. Only a rest follows from it: the job may have stood still for a reason of its own, which is no viewer's debt.
void Hub::chargeWhatWasBegun(const Drawing& drawing)
{
    const auto owner = viewers_.find(drawing.viewer);
    if (owner == viewers_.end()) return;
    const auto took = now_() - std::max(drawing.start, lastSent_);
    Viewer& of = owner->second;
    const double timeHad = of.timeHad, pictureMs = of.pictureMs;
    charge(of, std::chrono::duration<double, std::milli>(took).count(), samplesOf(drawing.scene));
    of.timeHad = timeHad;
    of.pictureMs = pictureMs;
}

/// Learns from a picture how long tracing takes. The background counts as if it were traced, and a picture that was
/// held up counts less than one that was quick: the next one may take longer than expected, but hardly less.
void Hub::learnSpeed(const SceneDescription& scene, double tracedMs)
{
    if (scene.lic.flow == FlowMotion::loop) return;  // Most pictures of a cycle are mixed from the first.
    if (samplesOf(scene) < kTellingSamples || !(tracedMs > 0)) return;
    double& speed = samplesPerMs_[std::size_t(scene.lic.method)];
    const double now = double(samplesOf(scene)) / tracedMs;
    speed = now > speed ? now : speed + kNewest * (now - speed);
}

std::chrono::milliseconds Hub::expectedTime(const SceneDescription& scene) const
{
    const double speed = samplesPerMs_[std::size_t(scene.lic.method)];
    return std::chrono::milliseconds(speed > 0 ? std::int64_t(double(samplesOf(scene)) / speed) : 0);
}

}  // namespace aeolic::stream
