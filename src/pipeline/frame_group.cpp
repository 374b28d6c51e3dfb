#include "pipeline/frame_group.h"

#include <algorithm>
#include <cstring>
#include <span>

#include "aeolic/error.h"
#include "cluster/field_composite.h"
#include "cluster/surface_composite.h"

namespace aeolic {
namespace {

std::optional<GuardSource> guardSourceFrom(const std::string& name)
{
    if (name == "project") return GuardSource::project;
    if (name == "receive") return GuardSource::receive;
    return std::nullopt;
}

BusyClock::Of busyOf(const Communicator& communicator)
{
    return communicator.name() == "threads" ? BusyClock::Of::thread : BusyClock::Of::process;
}

}  // namespace

FrameGroup::FrameGroup(std::shared_ptr<Communicator> communicator, const RunOptions& options, std::mutex* turn)
    : communicator_(std::move(communicator)),
      balancer_(makeBalancer(options.balance)),
      estimateGuards_(options.guard == "estimate"),
      forcedSource_(guardSourceFrom(options.guardRows)),
      busy_(busyOf(*communicator_), turn)
{
}

RowCoverage FrameGroup::coverage(const View& view, const Scene& scene, Backend& backend)
{
    if (ranks() == 1 || !balancer_->needsCoverage()) return {};
    const int factor = coverageFactor(view.camera.height, ranks());
    RowCoverage coverage{view.camera.height, factor, backend.coverage(view, factor)};
    if (!scene.inPieces) return coverage;
    busy_.stop();
    communicator_->allReduce(std::span(coverage.coveredPerRow), Reduction::sum);
    busy_.start();
    const std::int64_t width = coarseView(view, factor).camera.width;  // Pieces may hide one another.
    for (std::int64_t& pixels : coverage.coveredPerRow) pixels = std::min(pixels, width);
    return coverage;
}

FrameRows FrameGroup::rowsOf(int rank) const
{
    FrameRows rows;
    rows.stripe = stripes_.extent(rank, width_);
    rows.valid = withGuard(rows.stripe, {guardRows_, guardRows_}, stripes_.height());
    rows.drawn = source_ == GuardSource::project ? rows.valid : rows.stripe;
    rows.linked = withGuard(rows.drawn, {1, 1}, stripes_.height());
    if (guardRows_ == 0) rows.linked = rows.drawn;
    return rows;
}

std::vector<Extent> FrameGroup::linkedRows() const
{
    std::vector<Extent> rows;
    for (int r = 0; r < ranks(); ++r) rows.push_back(rowsOf(r).linked);
    return rows;
}

FrameRows FrameGroup::partition(const View& view, const LicOptions& lic, const Scene& scene, Backend& backend)
{
    const int height = view.camera.height;
    const TraceReach reach = backend.reach(lic);
    width_ = view.camera.width;
    guardRows_ = reach.steps > 0 ? guardRowsBound(reach.steps, view.maxStepPx, reach.jumps) : 0;
    maxStepPx_ = view.maxStepPx;
    flowUnitPx_ = view.flowUnitPx;
    costs_ = frameCosts(lic);
    source_ = forcedSource_.value_or(estimateGuards_ ? GuardSource::receive
                                                     : cheaperGuard(costs_, lic, width_, guardRows_, 2 * ranks()));
    stripeCosts_ = stripeCosts(costs_, lic, source_, width_, guardRows_);
    coverage_ = coverage(view, scene, backend);
    stripes_ = balancer_->partition(
        {height, ranks(), lastStripes_, lastBusyMs_, coverage_, relativeSpeeds(speeds_), stripeCosts_});
    return rowsOf(rank());
}

void FrameGroup::composite(const FieldPixels& mine, const FieldRows& into)
{
    composited_ = true;
    compositeField(*communicator_, mine, linkedRows(), into, busy_);
}

void FrameGroup::composite(const SurfacePixels& mine, GBuffer& into)
{
    composited_ = true;
    std::vector<Extent> rows = linkedRows();
    for (int r = 0; r < ranks(); ++r) {
        const Extent valid = rowsOf(r).valid;
        Extent& linked = rows[std::size_t(r)];
        linked = {linked.x0, std::max(linked.y0, valid.y0), linked.x1, std::min(linked.y1, valid.y1)};
    }
    compositeSurface(*communicator_, mine, rows, into, busy_);
}

std::unique_ptr<GuardExchange> FrameGroup::guards(Backend& projected, const FrameRows& rows)
{
    if (ranks() == 1 || source_ == GuardSource::project) return nullptr;
    const std::vector<RowFacts> own = projected.rowFacts(rows.stripe);
    busy_.stop();
    std::vector<RowFacts> facts = gatherRowFacts(*communicator_, stripes_, own);
    busy_.start();
    std::unique_ptr<GuardReach> reach = std::make_unique<BoundReach>(maxStepPx_);
    if (estimateGuards_) reach = std::make_unique<VectorReach>(facts, flowUnitPx_, maxStepPx_);
    return std::make_unique<StripeGuards>(*communicator_, stripes_, std::move(reach), std::move(facts), busy_);
}

Tile& FrameGroup::tileFor(const FrameRows& rows, FrameTiles& tiles) const
{
    const bool whole = tiles.gather && rank() == 0;
    Tile& tile = whole ? tiles.picture : tiles.stripe;
    tile.resize(whole ? Extent{0, 0, width_, stripes_.height()} : rows.stripe);
    return tile;
}

void FrameGroup::gather(FrameTiles& tiles)
{
    if (ranks() == 1 || !tiles.gather) return;
    Tile& finished = rank() == 0 ? tiles.picture : tiles.stripe;
    std::vector<std::int64_t> bytes;
    for (int r = 0; r < ranks(); ++r) bytes.push_back(std::int64_t(stripes_.rows(r)) * width_ * 4);
    const std::span<std::byte> pixels = std::as_writable_bytes(std::span(finished.rgba));
    busy_.stop();
    communicator_->gatherInPlace(pixels, pixels, bytes);
    busy_.start();
}

double FrameGroup::stripeMs(const RankStats& rank) const
{
    const double ms = rank.convolve.busyMs + rank.shade.busyMs;
    return composited_ ? ms : ms + rank.project.busyMs;
}

void FrameGroup::finish(RankStats mine, FrameStats& stats)
{
    const std::int64_t others = ranks() - 1, bytes = others * std::int64_t(sizeof mine);
    mine.balance.sentMessages += others, mine.balance.receivedMessages += others, mine.sentMessages += others;
    mine.balance.sentBytes += bytes, mine.balance.receivedBytes += bytes, mine.sentBytes += bytes;
    stats.ranks.assign(1, mine);
    if (ranks() > 1) {
        const std::vector<Bytes> all = communicator_->allGather(std::as_bytes(std::span(&mine, 1)));
        stats.ranks.resize(all.size());
        for (std::size_t r = 0; r < all.size(); ++r) std::memcpy(&stats.ranks[r], all[r].data(), sizeof mine);
    }
    stats.coveredPixels = 0;
    stats.busyMs = mine.busyMs;
    lastStripes_ = stripes_;
    lastBusyMs_.clear();
    std::vector<double> work;
    const RowSums sums(coverage_);
    for (const RankStats& rank : stats.ranks) {
        stats.coveredPixels += rank.pixels;
        lastBusyMs_.push_back(stripeMs(rank));
        if (!coverage_.empty())
            work.push_back(stripeCost(sums, stripeCosts_, rank.firstRow, rank.firstRow + rank.rows));
    }
    if (!work.empty()) addFrame(speeds_, work, lastBusyMs_);
}

}  // namespace aeolic
