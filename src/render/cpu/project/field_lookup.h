#pragma once

#include "data/field_tiles.h"
#include "data/vector_field.h"

namespace aeolic::cpu {

/// A GridField's constants for positions in local coordinates (relative to the surface's originWorld, in
/// units of `unitWorld`).
struct FieldLookup {
    float scale[3] = {}, offset[3] = {};  ///< Grid coordinate = local * scale + offset.
    float top[3] = {};                    ///< dims - 1.
    std::int64_t strideBytes[3] = {};     ///< From a sample to its neighbour in x, y, z; in rows.
    const void* samples = nullptr;        ///< Where sample (0, 0, 0) of the whole grid is, or would be; in tiles held.
    bool half = false;
    bool tiled = false;                    ///< The samples lie in tiles (FieldTiles).
    std::int32_t held[3] = {};             ///< In tiles: how many samples are held,
    float first[3] = {};                   ///< which one of the grid the first of them is,
    std::int64_t groupSamples = 0;         ///< and how many are in a whole group of layers.
    bool brick = false;                    ///< Only some cells are held here.
    float cellLo[3] = {}, cellHi[3] = {};  ///< The cells held, half-open.
};

inline FieldLookup makeFieldLookup(const GridField& field, const glm::dvec3& originWorld, double unitWorld)
{
    FieldLookup lookup;
    const std::int64_t sampleBytes = std::int64_t(field.sampleBytes());
    lookup.strideBytes[0] = sampleBytes;
    const GridIndex held = field.heldDims(), first = field.firstSample();
    lookup.strideBytes[1] = sampleBytes * held[0];
    lookup.strideBytes[2] = sampleBytes * held[0] * held[1];
    lookup.tiled = field.tiled;
    lookup.groupSamples = held[0] * held[1] * FieldTiles::kLayers;
    lookup.brick = field.brick.has_value();
    lookup.half = field.precision == FieldPrecision::float16;
    std::int64_t firstByte = 0;
    for (int c = 0; c < 3; ++c) {
        const auto a = std::size_t(c);
        lookup.scale[c] = float(unitWorld / field.spacingWorld[c]);
        lookup.offset[c] = float((originWorld[c] - field.originWorld[c]) / field.spacingWorld[c]);
        lookup.top[c] = float(field.dims[a] - 1);
        lookup.held[c] = std::int32_t(held[a]);
        lookup.first[c] = float(first[a]);
        if (!field.tiled) firstByte += first[a] * lookup.strideBytes[c];
        if (!lookup.brick) continue;
        lookup.cellLo[c] = float(field.brick->cellLo[a]);
        lookup.cellHi[c] = float(field.brick->cellHi[a]);
    }
    // Computed as a number: the place may lie before the memory, where no pointer may point.
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    lookup.samples = reinterpret_cast<const void*>(reinterpret_cast<std::intptr_t>(field.samples.get()) - firstByte);
    return lookup;
}

}  // namespace aeolic::cpu
