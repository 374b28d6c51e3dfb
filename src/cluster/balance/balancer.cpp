#include "cluster/balance/balancer.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace aeolic {

namespace {

/// Equal shares of this frame's covered pixels (bachthaler2006parallel, section 5.3 and figure 5, "pixel-counting").
/// It needs no temporal coherence. It takes all ranks for equally fast, and guards for free. Equal rows where nothing
/// is covered.
Stripes pixelsStripes(const BalanceInput& input)
{
    if (input.coverage.empty()) return equalStripes(input.height, input.ranks);
    const RowSums sums(input.coverage);
    std::vector<double> edgeRow{0}, cost;
    for (int y = 0; y < input.coverage.height; y += input.coverage.factor) {
        const int end = std::min(y + input.coverage.factor, input.coverage.height);
        edgeRow.push_back(end);
        cost.push_back(sums.pixels(y, end));
    }
    return splitEvenly(edgeRow, cost, input.height, input.ranks);
}

/// Half of the way of a boundary, rounded towards `to`, so that it gets there when it is a row away.
int halfWay(int from, int to)
{
    return to > from ? from + (to - from + 1) / 2 : from - (from - to + 1) / 2;
}

/// Equal shares of the last frame's time (bachthaler2006parallel, section 5.3, "timing-based"): every row of a stripe
/// is taken to cost the same part of what its rank was busy. It costs nothing and needs temporal coherence. It nears an
/// equal load only over some frames, because it knows nothing about the rows within a stripe. Where half of a stripe is
/// background, the other rows cost twice what they are taken for. Boundaries that moved all the way would swing to and
/// fro for ever, so they move half of it. Equal rows in the first frame.
Stripes timingStripes(const BalanceInput& input)
{
    const Stripes& last = input.lastStripes;
    if (last.height() == 0 || input.lastBusyMs.size() != std::size_t(last.ranks()))
        return equalStripes(input.height, input.ranks);
    std::vector<double> cost;
    for (int r = 0; r < last.ranks(); ++r) {
        const double busyMs = input.lastBusyMs[std::size_t(r)];
        cost.push_back(last.rows(r) > 0 && std::isfinite(busyMs) && busyMs > 0 ? busyMs : 0.0);
    }
    const std::vector<double> edgeRow(last.firstRow.begin(), last.firstRow.end());
    Stripes stripes = splitEvenly(edgeRow, cost, input.height, input.ranks);
    const bool known = std::any_of(cost.begin(), cost.end(), [](double ms) { return ms > 0; });
    if (!known || last.ranks() != input.ranks || last.height() != input.height) return stripes;
    for (std::size_t r = 1; r < last.firstRow.size(); ++r)
        stripes.firstRow[r] = halfWay(last.firstRow[r], stripes.firstRow[r]);
    return stripes;
}

}  // namespace

bool needsCoverage(Balance balance)
{
    switch (balance) {
        case Balance::equal:
        case Balance::timing:
            return false;
        case Balance::pixels:
        case Balance::hybrid:
            return true;
    }
    throw std::logic_error("an unknown balancer");
}

Stripes balancedStripes(Balance balance, const BalanceInput& input)
{
    switch (balance) {
        case Balance::equal:
            return equalStripes(input.height, input.ranks);
        case Balance::timing:
            return timingStripes(input);
        case Balance::pixels:
            return pixelsStripes(input);
        case Balance::hybrid:
            return hybridStripes(input);
    }
    throw std::logic_error("an unknown balancer");
}

Stripes splitEvenly(const std::vector<double>& edgeRow, const std::vector<double>& cost, int height, int ranks)
{
    const double total = std::accumulate(cost.begin(), cost.end(), 0.0);
    if (!(total > 0)) return equalStripes(height, ranks);
    const double rowsPerEdge = height / edgeRow.back();

    Stripes stripes{{0}};
    std::size_t i = 0;
    double before = 0;  // The cost of the intervals above interval i.
    for (int r = 1; r < ranks; ++r) {
        const double target = total * r / ranks;
        while (i + 1 < cost.size() && before + cost[i] < target) before += cost[i++];
        const double share = cost[i] > 0 ? std::clamp((target - before) / cost[i], 0.0, 1.0) : 0.0;
        const double row = (edgeRow[i] + share * (edgeRow[i + 1] - edgeRow[i])) * rowsPerEdge;
        stripes.firstRow.push_back(std::clamp(int(std::floor(row + 0.5)), stripes.firstRow.back(), height));
    }
    stripes.firstRow.push_back(height);
    return stripes;
}

}  // namespace aeolic
