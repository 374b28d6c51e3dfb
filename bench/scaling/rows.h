#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scaling/samples.h"
#include "scaling/scaling.h"

namespace aeolic {

/// What was measured under balancer `b`, of at least one frame, in the figures of a table: medians over the frames. The
/// names of scene and balancer are left empty.
ScalingRow measuredRow(const ScalingSamples& samples, std::size_t b, const NetworkModel& network);

/// How much longer frames took than others that were drawn in turn with them: the median of the ratios, picture by
/// picture. None where these are not the same pictures.
std::optional<double> slowdown(const BalancerSamples& of, const BalancerSamples& by, const NetworkModel& network);

/// The most that one rank alone took in one of these measurements, by the least. None with fewer than two.
std::optional<double> steadiness(const std::vector<ScalingSamples>& samples, const NetworkModel& network);

}  // namespace aeolic
