#include "engine/frame_group.h"

#include <algorithm>
#include <span>

#include "cluster/composite/composite.h"
#include "cluster/composite/edge_composite.h"
#include "cluster/composite/picture_gather.h"
#include "cluster/guards/stripe_guards.h"
#include "description/option_table.h"
#include "description/scene_text.h"

namespace aeolic {
namespace {

/// Nothing: whichever is cheaper.
std::optional<GuardSource> forcedSource(GuardRowsChoice choice)
{
    if (choice == GuardRowsChoice::automatic) return std::nullopt;
    return choice == GuardRowsChoice::project ? GuardSource::project : GuardSource::receive;
}

FrameRows rowsOf(const FramePlan& plan, int rank)
{
    FrameRows rows;
    rows.stripe = plan.stripes.extent(rank, plan.width);
    const int guard = std::max(plan.guardRows, plan.edgeRows > 0 ? plan.edgeRows + limits::kAlongRows : 0);
    rows.valid = withGuard(rows.stripe, {guard, guard}, plan.stripes.height());
    rows.drawn = plan.source == GuardSource::project ? rows.valid : rows.stripe;
    rows.read = rows.valid;
    return rows;
}

/// The options without the phase.
std::string textOf(const LicOptions& lic)
{
    SceneDescription scene;
    scene.lic = lic;
    scene.lic.phase = 0;
    return groupText(scene, options::lic.key);
}

}  // namespace

bool HeldCycle::holds(const Camera& camera, const LicOptions& lic, const Palette& palette) const
{
    return frame_ && frame_->camera == camera && frame_->lic == textOf(lic) && frame_->antialias == palette.antialias &&
           frame_->occlusion == palette.occlusion;
}

void HeldCycle::hold(const Camera& camera, const LicOptions& lic, const Palette& palette, const FramePlan& plan)
{
    frame_ = {camera, textOf(lic), palette.antialias, palette.occlusion, plan};
}

FrameGroup::FrameGroup(std::shared_ptr<Communicator> communicator, const RunOptions& options)
    : communicator_(std::move(communicator)),
      balance_(options.balance),
      estimateGuards_(options.guard == GuardChoice::estimate),
      forcedSource_(forcedSource(options.guardRows))
{
}

RowCoverage FrameGroup::coverage(const View& view, const Scene& scene, Backend& backend)
{
    if (ranks() == 1 || !needsCoverage(balance_)) return {};
    const int height = view.camera.height, factor = coverageFactor(height, ranks());
    const Camera coarse = coarseView(view, factor).camera;
    const auto triangles = std::int64_t(scene.surface.triangles.size());
    const bool shared =
        !scene.inPieces && cheaperShared(triangles, CoverageBits::bytes(coarse.width, coarse.height), ranks());
    CoverageBits* const mine =
        shared ? backend.coverageOfPart(view, factor, rank(), ranks()) : backend.coverageOfPart(view, factor, 0, 1);
    if (!mine) return {height, factor, backend.coverage(view, factor)};
    if (shared || scene.inPieces) uniteCoverage(*communicator_, *mine);
    return {height, factor, mine->pixelsPerRow(), mine->runsPerRow()};
}

void FrameGroup::partition(const View& view, const LicOptions& lic, const Scene& scene, Backend& backend,
                           FramePlan& plan)
{
    const int height = view.camera.height;
    plan.width = view.camera.width;
    plan.reach = traceReach(lic);
    plan.guardRows = plan.reach.steps > 0 ? guardRowsBound(plan.reach.steps, view.maxStepPx, plan.reach.levels) : 0;
    plan.maxStepPx = view.maxStepPx;
    plan.flowUnitPx = view.flowUnitPx;
    const FrameCosts costs = frameCosts(lic);
    plan.source = forcedSource_.value_or(cheaperGuard(costs, lic, plan.width, plan.guardRows, 2 * ranks()));
    plan.costs = stripeCosts(costs, lic, plan.source, plan.width, plan.guardRows, estimateGuards_ ? kEstimatedPart : 1);
    plan.coverage = coverage(view, scene, backend);
    plan.stripes = balancedStripes(balance_, {height, ranks(), history_.stripes, history_.workMs, plan.coverage,
                                              relativeSpeeds(history_.speeds), plan.costs});
    plan.rows = rowsOf(plan, rank());
}

void FrameGroup::composite(const FramePlan& plan, const Share& share)
{
    composited_ = !std::holds_alternative<std::monostate>(share);
    if (!composited_) return;
    std::vector<Extent> rowsOfRanks;  // Links need the neighbours.
    rowsOfRanks.reserve(std::size_t(ranks()));
    for (int r = 0; r < ranks(); ++r) {
        const FrameRows rows = rowsOf(plan, r);
        rowsOfRanks.push_back(withNeighbours(rows.drawn, rows.valid));
    }
    if (const auto* brick = std::get_if<BrickShare>(&share)) aeolic::composite(*communicator_, *brick, rowsOfRanks);
    if (const auto* piece = std::get_if<PieceShare>(&share)) aeolic::composite(*communicator_, *piece, rowsOfRanks);
}

std::unique_ptr<GuardExchange> FrameGroup::guards(Backend& projected, FramePlan& plan)
{
    if (ranks() == 1 || plan.source == GuardSource::project) return nullptr;
    const std::vector<RowFlow> own = projected.rowFlow(plan.rows.stripe);
    std::vector<RowFlow> facts = gatherRowFlow(*communicator_, plan.stripes, own);
    std::unique_ptr<GuardEstimate> reach = std::make_unique<BoundReach>(plan.maxStepPx);
    if (estimateGuards_)
        reach = std::make_unique<VectorReach>(facts, plan.flowUnitPx, plan.maxStepPx, plan.reach.levels);
    auto guards = std::make_unique<StripeGuards>(
        *communicator_, GuardPlan(plan.stripes, std::move(reach), std::move(facts)), guardRoom_);
    plan.rows.read = withGuard(plan.rows.stripe, guards->rows(plan.reach.steps), plan.stripes.height());
    return guards;
}

std::unique_ptr<RowExchange> FrameGroup::beside(const FramePlan& plan)
{
    if (ranks() == 1) return nullptr;
    return std::make_unique<StripeNeighbours>(*communicator_, plan.stripes);
}

std::unique_ptr<EdgeExchange> FrameGroup::edges(const FramePlan& plan, const Scene& scene)
{
    if (ranks() == 1 || plan.edgeRows == 0 || !scene.inPieces) return nullptr;
    return std::make_unique<EdgeComposite>(*communicator_, plan.stripes, plan.width);
}

void FrameGroup::gather(const FramePlan& plan, FrameTiles& tiles)
{
    if (ranks() == 1 || !tiles.gather) return;
    if (rank() == 0)
        receivePainted(*communicator_, plan.stripes, plan.width, tiles.others);
    else
        sendPainted(*communicator_, tiles.stripe, tiles.sent);
}

double FrameGroup::stripeMs(const RankStats& rank) const
{
    const double ms = rank.convolve.workMs + rank.shade.workMs;
    return composited_ ? ms : ms + rank.project.workMs;
}

void FrameGroup::finish(const FramePlan& plan, RankStats& mine, FrameStats& stats)
{
    mine.rank = rank();
    // What is sent below is part of what it tells.
    const std::int64_t messages = collectiveRounds(ranks()), bytes = (ranks() - 1) * std::int64_t(sizeof mine);
    mine.balance.sentMessages += messages, mine.balance.receivedMessages += messages, mine.sentMessages += messages;
    mine.balance.sentBytes += bytes, mine.balance.receivedBytes += bytes, mine.sentBytes += bytes;
    stats.ranks.assign(std::size_t(ranks()), mine);
    communicator_->allGatherInPlace(std::as_writable_bytes(std::span(stats.ranks)),
                                    std::vector<std::size_t>(stats.ranks.size(), sizeof mine));
    stats.busyMs = mine.busyMs;
    stats.coveredPixels = 0;
    for (const RankStats& rank : stats.ranks) stats.coveredPixels += rank.pixels;
    if (!plan.again) remember(plan, stats.ranks);
}

void FrameGroup::remember(const FramePlan& plan, const std::vector<RankStats>& ranks)
{
    history_.stripes = plan.stripes;
    history_.workMs.clear();
    std::vector<double> work;
    const RowSums sums(plan.coverage);
    for (const RankStats& rank : ranks) {
        history_.workMs.push_back(stripeMs(rank));
        if (!plan.coverage.empty())
            work.push_back(stripeCost(sums, plan.costs, rank.firstRow, rank.firstRow + rank.rows));
    }
    if (!work.empty()) addFrame(history_.speeds, work, history_.workMs);
}

}  // namespace aeolic
