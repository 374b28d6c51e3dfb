#pragma once

#include <memory>
#include <string>
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

/// Splits the image among the ranks so that all are busy equally long (bachthaler2006parallel, section 5.3). Keeps no
/// state: equal input gives equal stripes.
class Balancer {
public:
    virtual ~Balancer() = default;
    virtual std::string name() const = 0;    ///< Its name on the command line.
    virtual bool needsCoverage() const = 0;  ///< Somebody has to count this frame's pixels first.
    virtual Stripes partition(
        const BalanceInput& input) const = 0;  ///< Local. input.ranks stripes over input.height rows.
};

std::unique_ptr<Balancer> makeStaticBalancer();
std::unique_ptr<Balancer> makeTimingBalancer();
std::unique_ptr<Balancer> makePixelsBalancer();
std::unique_ptr<Balancer> makeHybridBalancer();

std::unique_ptr<Balancer> makeBalancer(Balance balance);

/// Stripes of equal cost. Rows [edgeRow[i], edgeRow[i + 1]) of a picture cost cost[i] together, evenly spread. This is
/// the accumulated histogram, inverted at equal intervals (figure 5) and rounded to whole rows. edgeRow ascends from 0
/// to any end, which is scaled to `height`. Equal rows where nothing costs anything.
Stripes splitEvenly(const std::vector<double>& edgeRow, const std::vector<double>& cost, int height, int ranks);

}  // namespace aeolic
