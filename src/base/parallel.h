#pragma once

/// Parallel loops. oneTBB stays behind this header. No loop's result may depend on how it is cut.

#if defined(__SANITIZE_THREAD__)
#include "base/parallel_threads.h"
#else
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "base/extent.h"

namespace aeolic {

#if !defined(__SANITIZE_THREAD__)

/// Calls body(begin, end) for disjoint ranges covering [0, count), on all threads of the current arena.
template <class Body>
void parallelRanges(std::size_t count, std::size_t grain, const Body& body)
{
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                      [&](const tbb::blocked_range<std::size_t>& r) { body(r.begin(), r.end()); });
}

/// Calls body(i) for every i in [0, count).
template <class Body>
void parallelFor(std::size_t count, const Body& body)
{
    tbb::parallel_for(std::size_t{0}, count, body);
}

#endif

/// Whether holds(begin, end) is true for all of disjoint ranges that cover [0, count).
template <class Holds>
bool holdsForAll(std::size_t count, std::size_t grain, const Holds& holds)
{
    std::atomic<bool> all = true;
    parallelRanges(count, grain, [&](std::size_t begin, std::size_t end) {
        if (!holds(begin, end)) all = false;
    });
    return all;
}

/// The sum of valueOf(i) for every i in [0, count): whole numbers, whose order does not matter.
template <class ValueOf>
std::int64_t parallelSum(std::size_t count, std::size_t grain, const ValueOf& valueOf)
{
    std::atomic<std::int64_t> sum{0};
    parallelRanges(count, grain, [&](std::size_t begin, std::size_t end) {
        std::int64_t part = 0;
        for (std::size_t i = begin; i < end; ++i) part += valueOf(i);
        sum += part;
    });
    return sum;
}

/// Calls body(y) for the rows of `extent`, `grain` of them or more at a time.
template <class Body>
void parallelRows(const Extent& extent, std::size_t grain, const Body& body)
{
    parallelRanges(std::size_t(std::max(extent.height(), 0)), grain, [&](std::size_t begin, std::size_t end) {
        for (int y = extent.y0 + int(begin); y < extent.y0 + int(end); ++y) body(y);
    });
}

/// Calls body(tile) for tiles of at most width x height pixels that together cover `extent`. The next tile is the one
/// below: a thread that goes down columns finds in its cache what it read around the tile before.
template <class Body>
void forEachTile(const Extent& extent, int width, int height, const Body& body)
{
    if (extent.empty()) return;
    const int across = (extent.width() + width - 1) / width, down = (extent.height() + height - 1) / height;
    parallelFor(std::size_t(across) * std::size_t(down), [&](std::size_t i) {
        const int x = extent.x0 + int(i) / down * width, y = extent.y0 + int(i) % down * height;
        body(Extent{x, y, std::min(x + width, extent.x1), std::min(y + height, extent.y1)});
    });
}

}  // namespace aeolic
