#include <algorithm>
#include <cmath>
#include <numeric>

#include "cluster/balance/balancer.h"

namespace aeolic {
namespace {

/// Finds stripes whose slowest one is as fast as possible. A stripe that grows never gets cheaper. So all stripes can
/// stay under a time if they do when each rank in turn takes all the rows it can. The best time is found by halving.
class BottleneckSearch {
public:
    explicit BottleneckSearch(const BalanceInput& input)
        : sums_(input.coverage),
          costs_(input.costs),
          height_(input.height),
          ranks_(input.ranks),
          speeds_(usableSpeeds(input))
    {
    }

    bool nothingCovered() const { return !(sums_.pixels(0, height_) > 0); }

    Stripes best() const
    {
        // Less than everyone's share without any guard is impossible; the fastest rank could draw everything alone.
        const double all = stripeCost(sums_, costs_, 0, height_);
        double tooShort = all / std::accumulate(speeds_.begin(), speeds_.end(), 0.0),
               feasible = all / *std::max_element(speeds_.begin(), speeds_.end());
        // The answer is mostly longer than that by the guards' part. Then halving, to a part in 2^12: below a row's
        // cost.
        for (double near = 1.125 * tooShort; near < feasible; near *= 1.125)
            if (canFinishIn(near)) {
                feasible = near;
            } else {
                tooShort = near;
            }
        while (feasible - tooShort > kFineness * feasible) {
            const double middle = 0.5 * (tooShort + feasible);
            (canFinishIn(middle) ? feasible : tooShort) = middle;
        }
        return evenStripesWithin(feasible);
    }

private:
    static constexpr double kFineness = 0x1p-12;

    static std::vector<double> usableSpeeds(const BalanceInput& input)
    {
        std::vector<double> speeds(std::size_t(input.ranks), 1.0);
        if (input.speeds.size() == speeds.size())
            for (std::size_t r = 0; r < speeds.size(); ++r)
                if (std::isfinite(input.speeds[r]) && input.speeds[r] > 0) speeds[r] = input.speeds[r];
        return speeds;
    }

    /// How many of the rows [y0, y1) come before the first for which `holds` is false.
    template <class Holds>
    static int rowsBefore(int y0, int y1, const Holds& holds)
    {
        int begin = y0, end = y1;
        while (begin < end) {
            const int middle = begin + (end - begin) / 2;
            if (holds(middle))
                begin = middle + 1;
            else
                end = middle;
        }
        return begin - y0;
    }

    double timeOf(int rank, int y0, int y1) const
    {
        return stripeCost(sums_, costs_, y0, y1) / speeds_[std::size_t(rank)];
    }

    /// The last row end that `rank` reaches from `begin` within `time`; `begin` if it cannot do a single row.
    int farthestEnd(int rank, int begin, double time) const
    {
        return begin + rowsBefore(begin + 1, height_ + 1, [&](int end) { return timeOf(rank, begin, end) <= time; });
    }

    /// The first row from which `rank` gets to `end` within `time`.
    int earliestBegin(int rank, int end, double time) const
    {
        return rowsBefore(0, end, [&](int begin) { return timeOf(rank, begin, end) > time; });
    }

    bool canFinishIn(double time) const
    {
        int row = 0;
        for (int r = 0; r < ranks_ && row < height_; ++r) row = farthestEnd(r, row, time);
        return row == height_;
    }

    /// A partition within `time` that is near equal shares. If each rank took all it can, the last ones would have
    /// nothing to do.
    Stripes evenStripesWithin(double time) const
    {
        // Rank r and those after it can still finish in time if rank r begins at this row or below.
        std::vector<int> earliest(std::size_t(ranks_) + 1, height_);
        for (int r = ranks_ - 1; r > 0; --r)
            earliest[std::size_t(r)] = earliestBegin(r, earliest[std::size_t(r) + 1], time);

        const double totalSpeed = std::accumulate(speeds_.begin(), speeds_.end(), 0.0);
        double speedAbove = 0;
        Stripes stripes{{0}};
        for (int r = 1; r < ranks_; ++r) {
            speedAbove += speeds_[std::size_t(r) - 1];
            const int begin = stripes.firstRow.back(), reach = farthestEnd(r - 1, begin, time);
            const int lowest = std::clamp(earliest[std::size_t(r)], begin, reach);
            stripes.firstRow.push_back(std::clamp(rowOfShare(speedAbove / totalSpeed), lowest, reach));
        }
        stripes.firstRow.push_back(height_);
        return stripes;
    }

    /// The row boundary above which rows cost nearest to `share` of all, without guards.
    int rowOfShare(double share) const
    {
        const auto costAbove = [&](int row) { return ownCost(sums_, costs_, 0, row); };
        const double wanted = share * costAbove(height_);
        const int below = rowsBefore(1, height_, [&](int row) { return costAbove(row) <= wanted; });
        return wanted - costAbove(below) <= costAbove(below + 1) - wanted ? below : below + 1;
    }

    RowSums sums_;
    StripeCosts costs_;
    int height_, ranks_;
    std::vector<double> speeds_;
};

}  // namespace

Stripes hybridStripes(const BalanceInput& input)
{
    if (input.coverage.empty()) return equalStripes(input.height, input.ranks);
    const BottleneckSearch search(input);
    return search.nothingCovered() ? equalStripes(input.height, input.ranks) : search.best();
}

}  // namespace aeolic
