#include <algorithm>
#include <cmath>

#include "cluster/balance/balancer.h"

namespace aeolic {
namespace {

/// Equal shares of the last frame's time (bachthaler2006parallel, section 5.3, "timing-based"): every row of a stripe
/// is taken to cost the same part of what its rank was busy. It costs nothing and needs temporal coherence. It nears an
/// equal load only over some frames, because it knows nothing about the rows within a stripe. Where half of a stripe is
/// background, the other rows cost twice what they are taken for. Boundaries that moved all the way would swing to and
/// fro for ever, so they move half of it. Equal rows in the first frame.
class TimingBalancer final : public Balancer {
public:
    std::string name() const override { return "timing"; }
    bool needsCoverage() const override { return false; }

    Stripes partition(const BalanceInput& input) const override
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

private:
    /// Rounded towards `to`, so that it gets there when it is a row away.
    static int halfWay(int from, int to) { return to > from ? from + (to - from + 1) / 2 : from - (from - to + 1) / 2; }
};

}  // namespace

std::unique_ptr<Balancer> makeTimingBalancer()
{
    return std::make_unique<TimingBalancer>();
}

}  // namespace aeolic
