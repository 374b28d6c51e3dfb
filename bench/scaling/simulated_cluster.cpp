#include "scaling/simulated_cluster.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cluster/balance/balancer.h"
#include "cluster/balance/speed_history.h"
#include "cluster/composite/picture_gather.h"
#include "description/choices.h"

namespace aeolic {
namespace {

constexpr double kMsPerNs = 1e-6;

struct Load {
    std::int64_t bytes = 0, messages = 0;
    void add(std::int64_t count) { bytes += count, messages += 1; }
};

double speedOf(const SimulatedCluster& cluster, int rank)
{
    return cluster.speeds.empty() ? 1.0 : cluster.speeds[std::size_t(rank)];
}

double slowestMs(const NetworkModel& network, const std::vector<Load>& loads)
{
    double slowest = 0;
    for (const Load& load : loads) slowest = std::max(slowest, network.transferMs(load.bytes, load.messages));
    return slowest;
}

Extent guardedRows(const SimulatedCluster& cluster, const Stripes& stripes, int rank)
{
    return withGuard(stripes.extent(rank, cluster.imageWidth), {cluster.guardRows, cluster.guardRows},
                     stripes.height());
}

/// Every rank's compute time in every stage; the frame keeps each stage's slowest.
void addCompute(const SimulatedCluster& cluster, const RowSums& truth, bool countsCoverage, SimulatedFrame& frame)
{
    const MeasuredCosts& costs = cluster.costs;
    for (int r = 0; r < cluster.ranks; ++r) {
        const Extent stripe = frame.stripes.extent(r, cluster.imageWidth),
                     guarded = guardedRows(cluster, frame.stripes, r);
        const double pixels = truth.pixels(stripe.y0, stripe.y1);
        const double guardPixels = truth.pixels(guarded.y0, guarded.y1) - pixels;
        const double area = double(stripe.width()) * double(stripe.height()), speed = speedOf(cluster, r);
        const double guardedArea = double(guarded.width()) * double(guarded.height());
        const bool drawsGuard = cluster.guardSource == GuardSource::project;
        const double projected = drawsGuard ? pixels + guardPixels : pixels;
        const double projectedArea = drawsGuard ? guardedArea : area;

        const double coverageMs = countsCoverage ? costs.coverageMs / speed : 0.0;
        const double projectNs = costs.projectPixelNs * projected + costs.projectAreaNs * projectedArea;
        const double convolveNs = costs.convolvePixelNs * pixels + costs.convolveGuardPixelNs * guardPixels +
                                  costs.convolveAreaNs * guardedArea;
        const double projectMs = (costs.projectFixedMs + projectNs * kMsPerNs) / speed;
        const double convolveMs = convolveNs * kMsPerNs / speed;
        const double shadeMs = costs.shadePixelNs * kMsPerNs * area / speed;
        frame.busyMs.push_back(coverageMs + projectMs + convolveMs + shadeMs);
        frame.guardPixels += std::int64_t(guardPixels);
        frame.coverageMs = std::max(frame.coverageMs, coverageMs);
        frame.projectMs = std::max(frame.projectMs, projectMs);
        frame.convolveMs = std::max(frame.convolveMs, convolveMs);
        frame.shadeMs = std::max(frame.shadeMs, shadeMs);
    }
}

/// Guard rows from every rank that owns some to the rank that reads them.
void addGuardTransfers(const SimulatedCluster& cluster, const RowSums& truth, SimulatedFrame& frame)
{
    std::vector<Load> sent(std::size_t(cluster.ranks)), received(std::size_t(cluster.ranks));
    for (int reader = 0; reader < cluster.ranks; ++reader) {
        const Extent guarded = guardedRows(cluster, frame.stripes, reader);
        if (guarded.empty()) continue;
        const int first = frame.stripes.ownerOf(guarded.y0), last = frame.stripes.ownerOf(guarded.y1 - 1);
        for (int owner = first; owner <= last; ++owner) {
            const Extent stripe = frame.stripes.extent(owner, cluster.imageWidth);
            if (owner == reader || stripe.empty()) continue;
            const double pixels = truth.pixels(std::max(stripe.y0, guarded.y0), std::min(stripe.y1, guarded.y1));
            const std::int64_t bytes = std::int64_t(pixels) * cluster.guardPixelBytes;
            if (bytes == 0) continue;
            sent[std::size_t(owner)].add(bytes);
            received[std::size_t(reader)].add(bytes);
            frame.sentBytes += bytes;
            frame.messages += 1;
        }
    }
    frame.guardNetworkMs = std::max(slowestMs(cluster.network, sent), slowestMs(cluster.network, received));
}

/// Finished pixels, and where they are, on their way to rank 0: what sendPainted() sends.
void addGather(const SimulatedCluster& cluster, const RowSums& truth, SimulatedFrame& frame)
{
    Load root;
    for (int r = 1; r < cluster.ranks; ++r) {
        const Extent stripe = frame.stripes.extent(r, cluster.imageWidth);
        const double pixels = truth.pixels(stripe.y0, stripe.y1);
        root.add(paintedColumnsBytes(stripe.height()) + std::int64_t(pixels) * cluster.imagePixelBytes);
        const double packMs = cluster.costs.packPixelNs * kMsPerNs * pixels / speedOf(cluster, r);
        frame.busyMs[std::size_t(r)] += packMs;
        frame.gatherMs = std::max(frame.gatherMs, packMs);
    }
    frame.gatherNetworkMs = cluster.network.transferMs(root.bytes, root.messages);
    frame.sentBytes += root.bytes;
    frame.messages += root.messages;
}

/// The costs as the balancer's own model takes them, in units of a covered pixel.
StripeCosts relativeCosts(const SimulatedCluster& cluster)
{
    const MeasuredCosts& costs = cluster.costs;
    const double pixelNs = costs.projectPixelNs + costs.convolvePixelNs;
    if (!(pixelNs > 0)) return {};
    const bool drawsGuard = cluster.guardSource == GuardSource::project;
    const double guardNs = std::min(costs.convolveGuardPixelNs + (drawsGuard ? costs.projectPixelNs : 0.0), pixelNs);
    const double areaNs = costs.projectAreaNs + costs.convolveAreaNs + costs.shadePixelNs;
    const double guardAreaNs = costs.convolveAreaNs + (drawsGuard ? costs.projectAreaNs : 0.0);
    const double rowPixels = cluster.imageWidth / pixelNs;
    return {cluster.guardRows, guardNs / pixelNs, areaNs * rowPixels, guardAreaNs * rowPixels};
}

/// What balancing itself sends around: every rank's time, and the pixels that it counted.
double balanceNetworkMs(const SimulatedCluster& cluster, Balance balance)
{
    if (balance == Balance::equal) return 0;
    const std::int64_t coverage = needsCoverage(balance) ? cluster.coverageBytes : std::int64_t{0};
    return cluster.network.collectiveMs(
        cluster.ranks, cluster.ranks * std::int64_t(sizeof(double)) + collectiveRounds(cluster.ranks) * coverage);
}

}  // namespace

RowCoverage coarsened(const RowCoverage& rows, int factor)
{
    RowCoverage coarse{rows.height, rows.factor * factor, {}};
    const std::int64_t count = std::int64_t(rows.coveredPerRow.size());
    for (std::int64_t begin = 0; begin < count; begin += factor) {
        const std::int64_t end = std::min(begin + factor, count), area = (end - begin) * factor;
        const auto* covered = rows.coveredPerRow.data();
        coarse.coveredPerRow.push_back((std::accumulate(covered + begin, covered + end, std::int64_t{0}) + area / 2) /
                                       area);
    }
    return coarse;
}

double SimulatedFrame::balance() const
{
    const double slowest = *std::max_element(busyMs.begin(), busyMs.end());
    const double mean = std::accumulate(busyMs.begin(), busyMs.end(), 0.0) / double(busyMs.size());
    return slowest > 0 ? mean / slowest : 1.0;
}

std::vector<SimulatedFrame> simulate(const SimulatedCluster& cluster, std::span<const RowCoverage> frames)
{
    const Balance balance = choiceNamed<Balance>(cluster.balancer).value();
    SpeedHistory history;
    BalanceInput input;
    input.ranks = cluster.ranks;
    input.costs = relativeCosts(cluster);
    std::vector<SimulatedFrame> simulated;
    for (const RowCoverage& coverage : frames) {
        const RowSums truth(coverage);
        const bool countsCoverage = needsCoverage(balance) && cluster.ranks > 1;
        input.height = coverage.height;
        input.coverage = needsCoverage(balance) ? coarsened(coverage, cluster.coverageFactor) : RowCoverage{};
        input.speeds = relativeSpeeds(history);

        SimulatedFrame frame;
        frame.stripes = balancedStripes(balance, input);
        frame.balanceNetworkMs = balanceNetworkMs(cluster, balance);
        addCompute(cluster, truth, countsCoverage, frame);
        if (cluster.guardSource == GuardSource::receive) addGuardTransfers(cluster, truth, frame);
        addGather(cluster, truth, frame);

        std::vector<double> work;
        work.reserve(std::size_t(cluster.ranks));
        for (int r = 0; r < cluster.ranks; ++r)
            work.push_back(stripeCost(truth, input.costs, frame.stripes.firstRow[std::size_t(r)],
                                      frame.stripes.firstRow[std::size_t(r) + 1]));
        addFrame(history, work, frame.busyMs);
        input.lastStripes = frame.stripes;
        input.lastBusyMs = frame.busyMs;
        simulated.push_back(std::move(frame));
    }
    return simulated;
}

}  // namespace aeolic
