#pragma once

#include <cstdint>
#include <vector>

#include "render/gbuffer.h"

namespace aeolic {

/// What the other ranks need to know of a row of the projected image.
struct RowFacts {
    std::uint16_t x0 = 0, x1 = 0;  ///< Half-open span of the pixels with flow.
    std::uint16_t maxUnits = 0;    ///< Largest vertical displacement per step, in flow units (GBuffer::flowUnitPx).
    bool operator==(const RowFacts&) const = default;
};

/// Local. Facts of the rows of `own`, from flow texels (render/gbuffer.h). One pass over them.
std::vector<RowFacts> rowFacts(const GBuffer& buffer, const Extent& own);

}  // namespace aeolic
