#include <cmath>

#include "cluster/balancer.h"

namespace aeolic {
namespace {

/// Equal shares of the last frame's time (bachthaler2006parallel, section 5.3, "timing-based"): every row of a stripe
/// is taken to cost the same part of what its rank was busy. Costs nothing, needs temporal coherence, and nears an
/// equal load only over some frames, because within a stripe it knows nothing. Equal rows in the first frame.
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
        return splitEvenly(edgeRow, cost, input.height, input.ranks);
    }
};

}  // namespace

std::unique_ptr<Balancer> makeTimingBalancer()
{
    return std::make_unique<TimingBalancer>();
}

}  // namespace aeolic
