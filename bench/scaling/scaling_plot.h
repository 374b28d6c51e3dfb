#pragma once

#include <string>

#include "scaling/bench_scaling.h"

namespace aeolic {

/// An SVG picture: speedup against the number of nodes, modelled, for every balancer, beside the paper's and the ideal.
/// Needs the plan's part `nodes`.
std::string scalingPlot(const ScalingBenchPlan& plan, const ScalingBench& bench);

}  // namespace aeolic
