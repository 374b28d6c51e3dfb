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
// A viewer that got a picture so short a time ago will ask for another one.
constexpr auto kSoon = std::chrono::milliseconds(500);
constexpr double kSlackMs = 100;
constexpr double kNewest = 0.5;  // The weight of the newest picture in a viewer's mean.
// Fewer samples say little about how long many take: on a busy machine any picture may take a tenth of a second.
constexpr std::uint64_t kTellingSamples = std::uint64_t{1} << 24;

}  // namespace

/// When much memory is taken, whoever still has a frame to read gets no other.
bool Hub::mayGetAnother(const Viewer& of) const
{
    return of.mayGetAnother() && (frameBytes() <= options_.frameBytes / 2 || of.port->framesQueued() == 0);
}

/// Draws the newest view of the viewer whose turn it is: of the one that has had the least time, and where that is the
/// same, of the next one after the viewer drawn last. So nobody who moves without end, or asks for much work, starves
/// the others. (Start-time fair queueing, Goyal et al. 1996.)
bool Hub::drawAnother()
{
    std::vector<Viewer*> turn;
    for (auto& [id, viewer] : viewers_)
        if (viewer.wanted && now_() >= viewer.mayLookFrom && mayGetAnother(viewer)) turn.push_back(&viewer);
    // Whoever was idle gets no time afterwards for that.
    for (Viewer* viewer : turn) viewer->timeHad = std::max(viewer->timeHad, timeGiven_);
    std::stable_sort(turn.begin(), turn.end(), [&](const Viewer* a, const Viewer* b) {
        const auto place = [&](const Viewer* v) { return std::pair(v->timeHad, v->id - lastDrawn_ - 1); };
        return place(a) < place(b);
    });
    for (Viewer* next : turn) {
        if (isAheadOfOthers(*next) || !draw(*next)) continue;
        lastDrawn_ = next->id;
        timeGiven_ = next->timeHad;
        return true;
    }
    return false;
}

/// Whether others, who had less time, will ask again in a moment: between two of their views, when nobody else waits, a
/// costly picture would hold them up for as long as it takes. Who is blocked or has stopped is not waited for.
bool Hub::isAheadOfOthers(const Viewer& viewer) const
{
    return std::any_of(viewers_.begin(), viewers_.end(), [&](const auto& entry) {
        const Viewer& other = entry.second;
        return other.id != viewer.id && now_() - other.drawnAt < kSoon &&
               std::max(other.timeHad, timeGiven_) + kSlackMs + 2 * other.pictureMs < viewer.timeHad;
    });
}

/// Whether a viewer has a view to be drawn, or got a picture so lately that it will ask for another one. Who is held
/// back, or has no room for a picture, keeps nobody waiting.
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

/// Turns alone do not bound what a viewer takes: where the others think for a moment after each picture, whoever asks
/// all the time would be drawn in every such moment. So who had more than its share rests while anybody else looks.
///
/// A picture of seconds is held back until its viewer has been here, without such a picture, for as long as it would
/// rest for it. Else whoever comes again and again would have one each time.
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
        fmt::format("this picture waits, because others look: it is drawn when they do not, or in {} s", left.count()),
        false);
}

/// What a picture took counts for its viewer.
void Hub::charge(Viewer& of, double ms, std::uint64_t samples)
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
        of.timeHad += std::min(ms, kSlackMs);  // The rest pays for the picture, so light views need not.
    } else {
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
