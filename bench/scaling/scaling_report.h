#pragma once

#include <string>

#include "scaling/bench_scaling.h"

namespace aeolic {

/// For people: at most 110 columns for up to eight numbers of ranks; what the numbers mean below.
std::string scalingTables(const ScalingBenchPlan& plan, const ScalingBench& bench);

/// "100 Gbit/s and 2 us a message"
std::string networkText(const NetworkModel& network);

/// For programs: machine, scene, networks, rows with every rank of the median frame, costs, simulations.
std::string scalingJson(const ScalingBenchPlan& plan, const ScalingBench& bench);

}  // namespace aeolic
