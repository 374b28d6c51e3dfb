#pragma once

#include <algorithm>
#include <cstddef>

#include "base/image.h"

namespace aeolic::cpu {

inline constexpr std::size_t kCacheLine = 64;

// Inline for certain: calls of functions that do nothing but prefetch GCC takes for calls without effect, and drops.
#define AEOLIC_PREFETCH [[gnu::always_inline]] inline

/// Asks for the cache lines of bytes, which need not be aligned to lines. `kWrite`: 1 where they are written soon.
template <int kWrite = 0>
AEOLIC_PREFETCH void prefetchBytes(const void* from, std::size_t bytes)
{
    const auto* first = static_cast<const std::byte*>(from);
    for (std::size_t i = 0; i < bytes; i += kCacheLine) __builtin_prefetch(first + i, kWrite);
}

/// Prefetches pixels `rows` below the next `pixels` pixels of an image: traces get there long before the pass does, to
/// places that no hardware foresees. A row ahead of the farthest, each line is there when it is first wanted. (Zen 5:
/// hierarchical LIC at 800x800 in 5/6 of the time.)
template <class T>
AEOLIC_PREFETCH void prefetchBelow(const Image<T>& image, std::ptrdiff_t at, int rows, std::size_t pixels)
{
    prefetchBytes(image.origin() + at + rows * image.stride(), pixels * sizeof(T));
}

/// Asks for pixels that are written soon, some vectors further in the row.
template <class T>
AEOLIC_PREFETCH void prefetchToWrite(const Image<T>& image, std::ptrdiff_t at, std::size_t pixels)
{
    constexpr std::ptrdiff_t kAhead = 64;  // Pixels.
    prefetchBytes<1>(image.origin() + at + kAhead, pixels * sizeof(T));
}

/// Asks for a row's pixels [x0, x1), which are written soon.
template <class T>
AEOLIC_PREFETCH void prefetchRowToWrite(const Image<T>& image, int x0, int x1, int y)
{
    prefetchBytes<1>(image.row(y) + x0, std::size_t(std::max(x1 - x0, 0)) * sizeof(T));
}

}  // namespace aeolic::cpu
