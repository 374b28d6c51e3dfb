#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scaling/bench_scaling.h"
#include "scaling/scaling_run.h"

namespace aeolic {

/// What was measured under balancer `b`, in the figures of a table: medians over the frames. Says neither of what scene
/// nor under which balancer. Of at least one frame.
ScalingRow measuredRow(const ScalingSamples& samples, std::size_t b, const NetworkModel& network);

/// What frames took by what others took that were drawn in turn with them: of each picture, and of those the median;
/// none where these are not the same pictures.
std::optional<double> slowdown(const BalancerSamples& of, const BalancerSamples& by, const NetworkModel& network);

/// What one rank took in one of these measurements by what it took in another, at most; none of fewer than two.
std::optional<double> steadiness(const std::vector<ScalingSamples>& samples, const NetworkModel& network);

}  // namespace aeolic
