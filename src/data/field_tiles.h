#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "data/vector_field.h"

namespace aeolic {

/// Large fields of vectors lie in tiles rather than in rows: the same memory in another order, in which a surface meets
/// few pages and cache lines however it lies. In rows, one that stands across them meets a page with each sample.
/// (512^3 samples on a Xeon in a virtual machine: projecting takes three quarters of the time.)
///
/// Groups of kLayers layers in z follow each other, in each group columns of kWidth samples in x, in each column all y,
/// in each y the group's layers, and there the samples in x. What is left at the far ends makes a thinner group and a
/// narrower column; nothing is padded.
struct FieldTiles {
    /// So that a page, and eight of them, are about as wide as high and deep: where a page lies in memory is itself
    /// looked up eight pages at a time. An odd width: fields are often powers of two wide, and all columns would lie in
    /// the same sets of a cache. (Columns of 2 or 3 samples, 4 layers: fewer cache lines, more pages, 10 to 12 ms
    /// for 8.5.)
    static constexpr std::int64_t kWidth = 11, kLayers = 8;

    /// Which of the samples held (x, y, z) is, all counted from 0.
    static std::int64_t index(const GridIndex& held, std::int64_t x, std::int64_t y, std::int64_t z)
    {
        const std::int64_t column = x / kWidth, group = z / kLayers;
        const std::int64_t width = std::min(kWidth, held[0] - column * kWidth),
                           layers = std::min(kLayers, held[2] - group * kLayers);
        return (group * held[0] * kLayers + column * kWidth * layers) * held[1] +
               (y * layers + z - group * kLayers) * width + x - column * kWidth;
    }
};

/// Whether tiles are worth it: vectors, more of them than caches hold, and at most 2^32 - 1. The same on every rank
/// that holds the same.
bool worthTiling(const GridField& field);

/// From rows to tiles, in place: nobody else may be reading the samples. Throws InputError where there is not enough
/// memory for a group of layers. Cost: two passes over the samples.
void toTiles(GridField& field);

/// The same field in tiles if that is worth it. `field`'s samples must not be read by anyone any more.
std::shared_ptr<const GridField> inTiles(const std::shared_ptr<const GridField>& field);

/// Row (y, z) of the samples held, in the order of x, whichever way they lie; `out`: as many bytes as those have.
void copyRow(const GridField& field, std::int64_t y, std::int64_t z, std::byte* out);

}  // namespace aeolic
