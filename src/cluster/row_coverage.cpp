#include "cluster/row_coverage.h"

#include <algorithm>

namespace aeolic {

int coverageFactor(int height, int ranks)
{
    return std::max(5, height / std::max(160, 20 * ranks));
}

RowCoverage coarsened(const RowCoverage& rows, int factor)
{
    RowCoverage coarse{rows.height, rows.factor * factor, {}};
    const std::int64_t count = std::int64_t(rows.coveredPerRow.size());
    for (std::int64_t begin = 0; begin < count; begin += factor) {
        const std::int64_t end = std::min(begin + factor, count), area = (end - begin) * factor;
        std::int64_t covered = 0;
        for (std::int64_t i = begin; i < end; ++i) covered += rows.coveredPerRow[std::size_t(i)];
        coarse.coveredPerRow.push_back((covered + area / 2) / area);
    }
    return coarse;
}

RowSums::RowSums(const RowCoverage& coverage) : above_(std::size_t(coverage.height) + 1, 0.0)
{
    if (coverage.empty()) return;
    for (std::size_t y = 0; y + 1 < above_.size(); ++y)
        above_[y + 1] = above_[y] + double(coverage.coveredPerRow[y / std::size_t(coverage.factor)] * coverage.factor);
}

double RowSums::pixels(int y0, int y1) const
{
    const int begin = std::clamp(y0, 0, height()), end = std::clamp(y1, begin, height());
    return above_[std::size_t(end)] - above_[std::size_t(begin)];
}

double stripeCost(const RowSums& sums, const StripeCosts& costs, int y0, int y1)
{
    if (y0 >= y1) return 0;
    const int above = std::max(y0 - costs.guardRows, 0), below = std::min(y1 + costs.guardRows, sums.height());
    const double guard = sums.pixels(above, y0) + sums.pixels(y1, below);
    return sums.pixels(y0, y1) + costs.row * (y1 - y0) + costs.guardPixel * guard +
           costs.guardRow * (y0 - above + below - y1);
}

}  // namespace aeolic
