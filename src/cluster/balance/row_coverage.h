#pragma once

#include <cstdint>
#include <vector>

#include "cluster/comm/communicator.h"
#include "render/coverage_bits.h"

namespace aeolic {

/// Coverage is counted at 1 / this of the resolution in each dimension: a fifth (bachthaler2006parallel, section 5.3),
/// and in large pictures less, but so that every rank has its rows: 20, and 160 in all.
int coverageFactor(int height, int ranks);

/// How much of every row the surface covers, perhaps seen at a lower resolution (bachthaler2006parallel, figure 5).
struct RowCoverage {
    int height = 0;  ///< Rows of the full image.
    int factor = 1;  ///< The resolution counted at is 1 / factor of the image's in each dimension.
    /// [ceil(height / factor)]: covered pixels of that low-resolution row, which stands for `factor` rows of the image
    /// (the last one perhaps for fewer). Empty: not measured.
    std::vector<std::int64_t> coveredPerRow;
    /// [ceil(height / factor)]: how many times covered pixels begin in that row. Empty: unknown, and costs nothing
    /// then.
    std::vector<std::int64_t> runsPerRow = {};

    bool empty() const { return coveredPerRow.empty(); }
};

/// Collective. Each rank gives what its part of the surface covers, an image of the same size, and gets what any rank's
/// part covers, in ⌈log2 ranks⌉ messages of one image each. Throws where another rank's has another size.
void uniteCoverage(Communicator& communicator, CoverageBits& bits);

/// Covered pixels of any range of rows in constant time.
class RowSums {
public:
    /// Cost: one pass over the image's rows.
    explicit RowSums(const RowCoverage& coverage);

    int height() const { return int(above_.size()) - 1; }

    /// Covered pixels, of full resolution, in rows [y0, y1); both may lie outside the image.
    double pixels(int y0, int y1) const { return between(y0, y1).pixels; }

    /// Runs of covered pixels in them, row by row.
    double runs(int y0, int y1) const { return between(y0, y1).runs; }

private:
    struct Sums {
        double pixels = 0, runs = 0;  // Whole numbers, so their sums are exact.
    };
    Sums between(int y0, int y1) const;

    std::vector<Sums> above_;  // [height + 1]: above the row.
};

/// A stripe's costs beside its covered pixels. The unit is one covered pixel, from projection to shading.
struct StripeCosts {
    int guardRows = 0;      ///< On each side of a stripe, >= 0.
    double guardPixel = 0;  ///< A covered pixel of the guard, [0, 1].
    double row = 0;         ///< Any row of the stripe, covered or not: background, clearing, sending. >= 0.
    double guardRow = 0;    ///< Any row of the guard, [0, row].
    double run = 0;         ///< A run of covered pixels in a row of the stripe, beside the pixels: its two ends. >= 0.
};

/// The cost of rows [y0, y1) without guards. A sum over rows.
double ownCost(const RowSums& sums, const StripeCosts& costs, int y0, int y1);

/// The cost of rows [y0, y1) as a stripe, 0 where it is empty. Never falls when the stripe grows at either end.
double stripeCost(const RowSums& sums, const StripeCosts& costs, int y0, int y1);

}  // namespace aeolic
