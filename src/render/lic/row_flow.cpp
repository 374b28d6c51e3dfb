#include "render/lic/row_flow.h"

#include <algorithm>
#include <cstdlib>

#include "base/parallel.h"
#include "render/gbuffer.h"
#include "render/lic/near_flow.h"

namespace aeolic {
namespace {

RowFlow factsOf(const std::uint32_t* row, int x0, int x1)
{
    const ColumnSpan flow = flowColumns(row, x0, x1);
    if (flow.empty()) return {};
    int largest = 0;
    for (int x = flow.x0; x < flow.x1; ++x) largest = std::max(largest, std::abs(flow_texel::dy(row[x])));
    return {std::uint16_t(flow.x0), std::uint16_t(flow.x1), std::uint16_t(largest)};
}

}  // namespace

std::vector<RowFlow> rowFlow(const GBuffer& buffer, const Extent& own)
{
    std::vector<RowFlow> facts(std::size_t(own.height()));
    parallelRows(own, 32, [&](int y) {
        const ColumnSpan& surface = buffer.surfaceColumns(y);
        facts[std::size_t(y - own.y0)] =
            factsOf(buffer.flow.row(y), std::max(own.x0, surface.x0), std::min(own.x1, surface.x1));
    });
    return facts;
}

}  // namespace aeolic
