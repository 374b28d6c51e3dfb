#pragma once

#include <cstdint>
#include <vector>

#include "render/gbuffer.h"

namespace aeolic {

/// What other ranks need to know about a row of the projected image.
struct RowFlow {
    std::uint16_t x0 = 0, x1 = 0;  ///< Half-open span of the pixels with flow.
    std::uint16_t maxUnits = 0;    ///< Largest vertical displacement per step, in flow units (GBuffer::flowUnitPx).
    bool operator==(const RowFlow&) const = default;
};

/// Local. The facts about each row of `own`, from its flow texels (render/gbuffer.h). Cost: one pass over them.
std::vector<RowFlow> rowFlow(const GBuffer& buffer, const Extent& own);

}  // namespace aeolic
