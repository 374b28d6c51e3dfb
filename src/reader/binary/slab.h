#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace aeolic {

/// A block of an array's elements: `count` from `first` on, in each dimension, slowest first.
struct Slab {
    std::vector<std::uint64_t> first, count;
};

/// All elements of an array.
inline Slab wholeSlab(const std::vector<std::uint64_t>& shape)
{
    return {std::vector<std::uint64_t>(shape.size(), 0), shape};
}

inline bool isWithin(const Slab& slab, const std::vector<std::uint64_t>& shape)
{
    bool within = slab.first.size() == shape.size() && slab.count.size() == shape.size();
    for (std::size_t i = 0; within && i < shape.size(); ++i)
        within = slab.count[i] <= shape[i] && slab.first[i] <= shape[i] - slab.count[i];
    return within;
}

inline std::uint64_t productOf(const std::vector<std::uint64_t>& lengths)
{
    std::uint64_t result = 1;
    for (const std::uint64_t length : lengths) result *= length;
    return result;
}

/// run(source, target, count): elements that stand in a row both in the box and in the slab, by their places in each.
template <class Run>
void forEachRun(const Slab& box, const Slab& slab, const Run& run)
{
    const std::size_t rank = slab.count.size();
    std::vector<std::uint64_t> begin(rank), length(rank);
    for (std::size_t i = 0; i < rank; ++i) {
        begin[i] = std::max(box.first[i], slab.first[i]);
        const std::uint64_t end = std::min(box.first[i] + box.count[i], slab.first[i] + slab.count[i]);
        if (end <= begin[i]) return;
        length[i] = end - begin[i];
    }
    std::size_t outer = rank == 0 ? 0 : rank - 1;
    std::uint64_t count = rank == 0 ? 1 : length[outer];
    while (outer > 0 && length[outer] == box.count[outer] && length[outer] == slab.count[outer])
        count *= length[--outer];
    std::vector<std::uint64_t> at = begin;
    for (;;) {
        std::uint64_t source = 0, target = 0;
        for (std::size_t i = 0; i < rank; ++i) {
            source = source * box.count[i] + (at[i] - box.first[i]);
            target = target * slab.count[i] + (at[i] - slab.first[i]);
        }
        run(source, target, count);
        std::size_t i = outer;
        while (i > 0 && ++at[i - 1] == begin[i - 1] + length[i - 1]) {
            at[i - 1] = begin[i - 1];
            --i;
        }
        if (i == 0) return;
    }
}

}  // namespace aeolic
