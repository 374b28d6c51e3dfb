#include <algorithm>

#include "cluster/balance/balancer.h"

namespace aeolic {
namespace {

/// Equal shares of this frame's covered pixels (bachthaler2006parallel, section 5.3 and figure 5, "pixel-counting").
/// It needs no temporal coherence. It takes all ranks for equally fast, and guards for free. Equal rows where nothing
/// is covered.
class PixelsBalancer final : public Balancer {
public:
    std::string name() const override { return "pixels"; }
    bool needsCoverage() const override { return true; }

    Stripes partition(const BalanceInput& input) const override
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
};

}  // namespace

std::unique_ptr<Balancer> makePixelsBalancer()
{
    return std::make_unique<PixelsBalancer>();
}

}  // namespace aeolic
