#pragma once

#include <cstdint>
#include <optional>

#include "data/scene.h"

namespace aeolic::gl {

/// Of the current context's device, bytes free now, where the driver tells.
std::optional<std::uint64_t> freeMemoryBytes();

/// Throws InputError where the scene does not fit the current context's device: its mesh the longest buffer, its field
/// the largest texture or, where it is `fresh` and holds nothing of it yet, both the memory.
void requireLimits(const Scene& scene, bool fresh);

/// Throws InputError: the scene takes more memory than the device has, and how many GPUs would be enough.
[[noreturn]] void throwDoesNotFit(const Scene& scene);

/// Throws InputError where a frame of that size does not fit; `rows` of it are held here, in the place of `heldBytes`.
void requireFrame(int width, int height, int rows, std::uint64_t bytesPerPixel, std::uint64_t heldBytes);

}  // namespace aeolic::gl
