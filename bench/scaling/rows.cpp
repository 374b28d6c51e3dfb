#include "scaling/rows.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "base/median.h"
#include "scaling/critical_path.h"
#include "scaling/paper.h"

namespace aeolic {
namespace {

std::vector<double> totalsMs(const std::vector<RanksOfFrame>& frames, const NetworkModel& network)
{
    std::vector<double> totals;
    totals.reserve(frames.size());
    for (const RanksOfFrame& ranks : frames) totals.push_back(criticalPath(ranks, network).totalMs());
    return totals;
}

std::vector<double> cpuMs(const std::vector<RanksOfFrame>& frames)
{
    std::vector<double> sums;
    sums.reserve(frames.size());
    for (const RanksOfFrame& ranks : frames)
        sums.push_back(std::accumulate(ranks.begin(), ranks.end(), 0.0,
                                       [](double sum, const RankStats& rank) { return sum + rank.busyMs; }));
    return sums;
}

/// The frame whose critical path is the median; with an even number the quicker of the middle two.
const RanksOfFrame& medianFrame(const std::vector<RanksOfFrame>& frames, const NetworkModel& network)
{
    const std::vector<double> totals = totalsMs(frames, network);
    std::vector<std::size_t> order(frames.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return totals[a] < totals[b]; });
    return frames[order[(order.size() - 1) / 2]];
}

/// The median of of[i] / by[i], where i is a picture. None where these are not the same pictures.
std::optional<double> medianRatio(const std::vector<double>& of, const std::vector<double>& by)
{
    if (of.empty() || of.size() != by.size()) return {};
    std::vector<double> ratios;
    for (std::size_t i = 0; i < of.size(); ++i) ratios.push_back(of[i] / by[i]);
    return median(ratios);
}

}  // namespace

ScalingRow measuredRow(const ScalingSamples& samples, std::size_t b, const NetworkModel& network)
{
    const auto& [rotation, jumps, wallMs] = samples.of[b];
    ScalingRow row;
    row.totalMs = median(totalsMs(rotation, network));
    row.paperNetworkMs = median(totalsMs(rotation, kPaperNetwork));
    row.cpuMs = median(cpuMs(rotation));
    if (!wallMs.empty()) row.wallMs = median(wallMs);
    row.speedup = medianRatio(totalsMs(samples.alone, network), totalsMs(rotation, network));
    row.paperNetworkSpeedup = medianRatio(totalsMs(samples.alone, kPaperNetwork), totalsMs(rotation, kPaperNetwork));
    row.wallSpeedup = medianRatio(samples.aloneWallMs, wallMs);
    row.work = medianRatio(cpuMs(rotation), cpuMs(samples.alone));

    std::vector<double> balances;
    balances.reserve(rotation.size());
    for (const RanksOfFrame& ranks : rotation) balances.push_back(loadBalance(ranks));
    row.loadBalance = median(balances);
    for (const RanksOfFrame& ranks : jumps) row.afterJump.push_back(loadBalance(ranks));
    row.ofRanks = medianFrame(rotation, network);
    row.path = criticalPath(row.ofRanks, network);
    return row;
}

std::optional<double> slowdown(const BalancerSamples& of, const BalancerSamples& by, const NetworkModel& network)
{
    return medianRatio(totalsMs(of.rotation, network), totalsMs(by.rotation, network));
}

std::optional<double> steadiness(const std::vector<ScalingSamples>& samples, const NetworkModel& network)
{
    std::vector<double> mediansMs;
    for (const ScalingSamples& of : samples)
        if (!of.alone.empty()) mediansMs.push_back(median(totalsMs(of.alone, network)));
    if (mediansMs.size() < 2) return {};
    const auto [least, most] = std::minmax_element(mediansMs.begin(), mediansMs.end());
    return *most / *least;
}

}  // namespace aeolic
