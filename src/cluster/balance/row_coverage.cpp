#include "cluster/balance/row_coverage.h"

#include <algorithm>

namespace aeolic {

int coverageFactor(int height, int ranks)
{
    return std::max(5, height / std::max(160, 20 * ranks));
}

void uniteCoverage(Communicator& communicator, CoverageBits& bits)
{
    const int ranks = communicator.size(), me = communicator.rank();
    std::vector<std::uint64_t> others(bits.words.size());
    // After every round a rank knows twice as many ranks' parts. A bit that comes twice does no harm.
    for (int step = 1; step < ranks; step *= 2) {
        communicator.exchangeInPlace({{(me + step) % ranks, std::as_bytes(std::span(bits.words))}},
                                     {{(me + ranks - step) % ranks, std::as_writable_bytes(std::span(others))}});
        for (std::size_t i = 0; i < others.size(); ++i) bits.words[i] |= others[i];
    }
}

RowSums::RowSums(const RowCoverage& coverage) : above_(std::size_t(coverage.height) + 1)
{
    if (coverage.empty()) return;
    for (std::size_t y = 0; y + 1 < above_.size(); ++y) {
        const std::size_t coarse = y / std::size_t(coverage.factor);
        above_[y + 1].pixels = above_[y].pixels + double(coverage.coveredPerRow[coarse] * coverage.factor);
        above_[y + 1].runs = above_[y].runs + (coverage.runsPerRow.empty() ? 0 : double(coverage.runsPerRow[coarse]));
    }
}

RowSums::Sums RowSums::between(int y0, int y1) const
{
    const int begin = std::clamp(y0, 0, height()), end = std::clamp(y1, begin, height());
    const Sums &first = above_[std::size_t(begin)], &last = above_[std::size_t(end)];
    return {last.pixels - first.pixels, last.runs - first.runs};
}

double ownCost(const RowSums& sums, const StripeCosts& costs, int y0, int y1)
{
    return sums.pixels(y0, y1) + costs.run * sums.runs(y0, y1) + costs.row * (y1 - y0);
}

double stripeCost(const RowSums& sums, const StripeCosts& costs, int y0, int y1)
{
    if (y0 >= y1) return 0;
    const int above = std::max(y0 - costs.guardRows, 0), below = std::min(y1 + costs.guardRows, sums.height());
    const double guard = sums.pixels(above, y0) + sums.pixels(y1, below);
    return ownCost(sums, costs, y0, y1) + costs.guardPixel * guard + costs.guardRow * (y0 - above + below - y1);
}

}  // namespace aeolic
