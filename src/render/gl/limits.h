#pragma once

#include <cstdint>
#include <optional>

#include "data/scene.h"

namespace aeolic::gl {

/// Of the current context's device, bytes free now, where the driver tells.
std::optional<std::uint64_t> freeMemoryBytes();

/// Throws InputError where the scene does not fit the current context's device: its mesh the longest buffer, its field
/// the largest texture or, where it is `fresh` and holds nothing of it yet, the memory. Says how many ranks' GPUs would
/// hold a field that does not fit one.
void requireLimits(const Scene& scene, bool fresh);

/// Throws InputError where a frame of that size does not fit; `rows` of it are held here.
void requireFrame(int width, int height, int rows, std::uint64_t bytesPerPixel);

}  // namespace aeolic::gl
