#include "cluster/balance/balancer.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace aeolic {

std::unique_ptr<Balancer> makeBalancer(Balance balance)
{
    switch (balance) {
        case Balance::equal:
            return makeStaticBalancer();
        case Balance::timing:
            return makeTimingBalancer();
        case Balance::pixels:
            return makePixelsBalancer();
        case Balance::hybrid:
            return makeHybridBalancer();
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
