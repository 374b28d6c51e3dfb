#include "render/lic/near_flow.h"

#include <algorithm>

namespace aeolic {
namespace {

constexpr int kBlock = 16;  // Texels looked at together.

bool anyFlow(const std::uint32_t* texels)
{
    std::uint32_t any = 0;
    for (int i = 0; i < kBlock; ++i) any |= texels[i];
    return any != 0;
}

}  // namespace

ColumnSpan flowColumns(const std::uint32_t* row, int x0, int x1)
{
    while (x1 - x0 >= kBlock && !anyFlow(row + x0)) x0 += kBlock;
    while (x0 < x1 && row[x0] == 0) ++x0;
    while (x1 - x0 >= kBlock && !anyFlow(row + x1 - kBlock)) x1 -= kBlock;
    while (x0 < x1 && row[x1 - 1] == 0) --x1;
    return x0 < x1 ? ColumnSpan{x0, x1} : ColumnSpan{};
}

NearFlow::NearFlow(const Extent& rows, const std::vector<ColumnSpan>& flow) : rows_(rows), near_(flow.size())
{
    constexpr int kMargin = kColumns / 2;
    const int height = rows.height();
    for (int y = 0; y < height; ++y) {
        ColumnSpan near;
        for (int k = std::max(y - kRows, 0); k <= std::min(y + kRows, height - 1); ++k)
            near = near.with(flow[std::size_t(k)]);
        if (near.empty()) continue;
        const int fromLeft = std::max(near.x0 - kMargin - rows.x0, 0);
        near_[std::size_t(y)] = {rows.x0 + fromLeft / kMargin * kMargin, std::min(near.x1 + kMargin, rows.x1)};
    }
}

}  // namespace aeolic
