#include <algorithm>
#include <cmath>
#include <vector>

#include "stream/gateway/hub.h"

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

/// What a picture took counts for its viewer.
void Hub::charge(Viewer& of, double ms)
{
    std::vector<double> others;
    for (const auto& [id, viewer] : viewers_)
        if (id != of.id && viewer.pictureMs > 0) others.push_back(viewer.pictureMs);
    of.pictureMs = of.pictureMs > 0 ? of.pictureMs + kNewest * (ms - of.pictureMs) : ms;
    double factor = 1;
    if (!others.empty()) {
        const auto middle = others.begin() + std::ptrdiff_t(others.size() / 2);
        std::nth_element(others.begin(), middle, others.end());
        if (ms > kCostly * *middle) factor = kCostly;
    }
    of.timeHad += factor * ms;
    of.drawnAt = now_();
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
