#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "aeolic/scene_description.h"
#include "data/bricks.h"

namespace aeolic {

/// Samples on a uniform grid, x fastest, components interleaved: value[((z*ny + y)*nx + x)*components + c],
/// counted from firstSample() in steps of heldDims(); large ones in tiles (FieldTiles).
/// Masked samples (NaN or infinite in the input, outside the valid region of a resampling) are NaN: interpolation then
/// yields NaN by itself, which is the mask. Immutable once built; the memory may belong to a reader's array.
struct GridField {
    GridIndex dims{0, 0, 0};     ///< Samples in x, y, z of the whole grid; each at least 2 for a usable field.
    std::optional<Brick> brick;  ///< The part of it that `samples` holds; none: all.
    glm::dvec3 originWorld{0};   ///< World position of sample (0, 0, 0).
    glm::dvec3 spacingWorld{1};  ///< Positive.
    int components = 3;          ///< 3 for vectors, 1 for a scalar to colour by.
    FieldPrecision precision = FieldPrecision::float32;
    bool tiled = false;                   ///< The samples lie in tiles.
    std::shared_ptr<const void> samples;  ///< float or IEEE half (as uint16_t), by `precision`.
    double maxMagnitude = 0;              ///< Largest finite vector length (or |scalar|).
    std::string name;                     ///< The array's name, for messages.

    GridIndex heldDims() const { return brick ? brick->sampleDims() : dims; }
    GridIndex firstSample() const { return brick ? brick->cellLo : GridIndex{0, 0, 0}; }
    std::size_t sampleCount() const
    {
        const GridIndex held = heldDims();
        return std::size_t(held[0]) * std::size_t(held[1]) * std::size_t(held[2]);
    }
    std::size_t sampleBytes() const { return std::size_t(components) * (precision == FieldPrecision::float32 ? 4 : 2); }
    std::size_t bytes() const { return sampleCount() * sampleBytes(); }
    const float* floats() const { return static_cast<const float*>(samples.get()); }
    const std::uint16_t* halves() const { return static_cast<const std::uint16_t*>(samples.get()); }
};

/// A copy of the field's grid, name and range, without its samples.
inline GridField withoutSamples(GridField field)
{
    field.samples = nullptr;
    return field;
}

}  // namespace aeolic
