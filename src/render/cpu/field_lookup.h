#pragma once

#include "data/vector_field.h"

namespace aeolic::cpu {

/// A GridField's constants for positions in local coordinates (relative to the surface's originWorld).
struct FieldLookup {
    float scale[3] = {}, offset[3] = {};  ///< Grid coordinate = local * scale + offset.
    float top[3] = {};                    ///< dims - 1.
    std::int64_t strideBytes[3] = {};     ///< From a sample to its neighbour in x, y, z.
    const void* samples = nullptr;
    bool half = false;
};

inline FieldLookup makeFieldLookup(const GridField& field, const glm::dvec3& originWorld)
{
    FieldLookup lookup;
    const std::int64_t sampleBytes = field.components * (field.precision == FieldPrecision::float32 ? 4 : 2);
    lookup.strideBytes[0] = sampleBytes;
    lookup.strideBytes[1] = sampleBytes * field.dims[0];
    lookup.strideBytes[2] = sampleBytes * field.dims[0] * field.dims[1];
    for (int c = 0; c < 3; ++c) {
        lookup.scale[c] = float(1.0 / field.spacingWorld[c]);
        lookup.offset[c] = float((originWorld[c] - field.originWorld[c]) / field.spacingWorld[c]);
        lookup.top[c] = float(field.dims[std::size_t(c)] - 1);
    }
    lookup.samples = field.samples.get();
    lookup.half = field.precision == FieldPrecision::float16;
    return lookup;
}

}  // namespace aeolic::cpu
