#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "data/vector_field.h"

namespace aeolic {

/// The samples of large vector fields lie in tiles rather than in rows, in the same memory. A surface then meets few
/// pages and cache lines, however it lies. A surface that stands across rows would meet another page with each sample.
/// (Measured with 512^3 samples on a Xeon in a virtual machine: with tiles projecting takes three quarters of the
/// time.)
///
/// Groups of kLayers layers in z follow each other, in each group columns of kWidth samples in x, in each column all y,
/// in each y the group's layers, and there the samples in x. What is left at the far ends makes a thinner group and a
/// narrower column; nothing is padded.
struct FieldTiles {
    /// These sizes make a page, and eight pages, about as wide as high and deep: the place of a page in memory is
    /// itself looked up eight pages at a time. The width is odd because fields are often powers of two wide; all
    /// columns would then lie in the same sets of a cache. (Columns of 2 or 3 samples and 4 layers meet fewer cache
    /// lines but more pages: 10 to 12 ms instead of 8.5.)
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

/// Whether tiles are worth it: for vectors, where they are more than caches hold, and at most 2^32 - 1. Ranks that hold
/// the same find the same.
bool worthTiling(const GridField& field);

/// Reorders rows into tiles, in place. Nobody else may be reading the samples. Throws InputError where there is not
/// enough memory for a group of layers. Cost: two passes over the samples.
void toTiles(GridField& field);

/// The field in tiles if that is worth it, else as it is. Nobody may read the samples of `field` any more.
std::shared_ptr<const GridField> inTiles(const std::shared_ptr<const GridField>& field);

/// Copies row (y, z) of the samples held, in the order of x, whichever way they lie. `out` has room for the row.
void copyRow(const GridField& field, std::int64_t y, std::int64_t z, std::byte* out);

}  // namespace aeolic
