#pragma once

#include <vector>

#include "aeolic/scene_description.h"
#include "cluster/balance/row_coverage.h"
#include "cluster/balance/stripes.h"

namespace aeolic {

/// Everything a balancer may go by. All ranks have the same, so that they find the same stripes.
struct BalanceInput {
    int height = 0, ranks = 1;  ///< The image's height and the group's size; both at least 1.
    Stripes lastStripes;  ///< The last frame's, perhaps for another height or group; none: this is the first frame.
    std::vector<double> lastBusyMs;  ///< [lastStripes.ranks()]: wall time of the last frame without waiting for others.
    RowCoverage coverage;            ///< This frame's; empty where the balancer does not need it.
    std::vector<double> speeds;      ///< [ranks]: relativeSpeeds(); empty: all alike.
    StripeCosts costs;               ///< A stripe's costs beside its pixels.
};

/// Whether somebody has to count this frame's pixels first.
bool needsCoverage(Balance balance);

/// Local. Splits the image among the ranks so that all are busy equally long (bachthaler2006parallel, section 5.3):
/// input.ranks stripes over input.height rows. Equal input gives equal stripes.
Stripes balancedStripes(Balance balance, const BalanceInput& input);

/// Balance::hybrid. Our own. It goes by the coverage of *this* frame, by what guards and empty rows cost, and by how
/// fast each rank is known to be. It needs no temporal coherence, since a rank's speed does not depend on the view, and
/// suits unequal nodes. It finds the best whole rows, unlike rounding an inverted histogram. Equal rows where nothing
/// is covered.
Stripes hybridStripes(const BalanceInput& input);

/// Stripes of equal cost. Rows [edgeRow[i], edgeRow[i + 1]) of a picture cost cost[i] together, evenly spread. This is
/// the accumulated histogram, inverted at equal intervals (figure 5) and rounded to whole rows. edgeRow ascends from 0
/// to any end, which is scaled to `height`. Equal rows where nothing costs anything.
Stripes splitEvenly(const std::vector<double>& edgeRow, const std::vector<double>& cost, int height, int ranks);

}  // namespace aeolic
