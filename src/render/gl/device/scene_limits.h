#pragma once

#include <cstdint>
#include <optional>

#include "data/load/scene_sizes.h"
#include "render/gl/device/gl_limits.h"

namespace aeolic::gl {

/// Throws InputError where a scene does not fit a device, naming how many ranks or GPUs would be enough: its mesh the
/// longest buffer, its fields the largest texture or, where it is `fresh` and the device holds nothing of it yet, both
/// the memory. What is missing from `sizes` fits.
void requireLimits(const SceneSizes& sizes, const DeviceLimits& limits, bool fresh);

/// Throws InputError: the scene takes more memory than the device has, and how many GPUs would be enough.
[[noreturn]] void throwDoesNotFit(const SceneSizes& sizes, const DeviceLimits& limits);

/// The least number of ranks, or one at most a sixteenth above it, whose bricks of the fields have no side of more than
/// `side` samples and take at most `bytes` each; nothing where 65536 are not enough.
std::optional<int> ranksEnough(const SceneSizes& sizes, std::uint64_t side, std::uint64_t bytes);

}  // namespace aeolic::gl
