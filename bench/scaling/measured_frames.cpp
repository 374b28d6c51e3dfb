#include "scaling/measured_frames.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <utility>

#include "scaling/critical_path.h"

namespace aeolic {

RankStats leastOf(const std::vector<RankStats>& repeats)
{
    RankStats least = repeats.back();
    least.busyMs = 0;
    for (const FrameStage& stage : kFrameStages) {
        StageStats& stats = least.*stage.stats;
        for (const RankStats& repeat : repeats) {
            stats.busyMs = std::min(stats.busyMs, (repeat.*stage.stats).busyMs);
            stats.workMs = std::min(stats.workMs, (repeat.*stage.stats).workMs);
        }
        least.busyMs += stats.busyMs;
    }
    return least;
}

MeasuredFrames::MeasuredFrames(const Scene& scene, Backend& backend, Communicator& others, const RunOptions& options,
                               std::mutex& alone)
    : scene_(scene),
      backend_(backend),
      others_(others),
      communicator_(others),
      // A group shares its communicator, which here is a member and stays one.
      group_(std::shared_ptr<Communicator>(&communicator_, [](Communicator*) {}), options),
      alone_(alone)
{
}

RanksOfFrame MeasuredFrames::draw(const FrameRequest& request, int repeats)
{
    now_.request = request;
    now_.before = group_.history();
    communicator_.record(now_.received);
    renderFrame(request, scene_, backend_, group_, frame_);

    std::vector<RankStats> measured;
    measured.reserve(std::size_t(repeats));
    for (int i = 0; i < repeats; ++i) {
        others_.barrier();  // All others have come as far.
        const std::lock_guard lock(alone_);
        drawAlone(last_ ? *last_ : now_);
        measured.push_back(drawAlone(now_));
    }
    const RankStats mine = leastOf(measured);
    RanksOfFrame ranks(std::size_t(others_.size()));
    const std::vector<Bytes> all = others_.allGather(std::as_bytes(std::span(&mine, 1)));
    for (std::size_t r = 0; r < ranks.size(); ++r) std::memcpy(&ranks[r], all[r].data(), sizeof mine);

    group_.goBackTo(now_.before);
    group_.remember(frame_.plan, ranks);
    if (!last_) last_.emplace();
    std::swap(*last_, now_);
    return ranks;
}

RankStats MeasuredFrames::drawAlone(Drawn& drawn)
{
    group_.goBackTo(drawn.before);
    communicator_.replay(drawn.received);
    renderFrame(drawn.request, scene_, backend_, group_, frame_);
    return frame_.mine;
}

}  // namespace aeolic
