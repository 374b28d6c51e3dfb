#include "render/cpu/project/background.h"

#include <algorithm>

#include "base/parallel.h"
#include "render/cpu/simd/prefetch.h"
#include "render/lic/near_flow.h"

namespace aeolic::cpu {
namespace {

/// What traces look at.
void clearFlow(const Extent& tile, GBuffer& out)
{
    constexpr int kRowsAhead = 8;
    for (int y = tile.y0; y < tile.y1; ++y) {
        if (y + kRowsAhead < tile.y1) {
            prefetchRowToWrite(out.flow, tile.x0, tile.x1, y + kRowsAhead);
            prefetchRowToWrite(out.links, tile.x0, tile.x1, y + kRowsAhead);
        }
        out.flow.fill({tile.x0, y, tile.x1, y + 1}, 0);
        out.links.fill({tile.x0, y, tile.x1, y + 1}, 0);
    }
}

void clearNear(const Extent& tile, const TileSides& surface, GBuffer& out)
{
    const int left = std::min(tile.x0 + NearFlow::kColumns, tile.x1),
              right = std::max(tile.x1 - NearFlow::kColumns, tile.x0),
              upper = std::min(tile.y0 + NearFlow::kRows, tile.y1),
              lower = std::max(tile.y1 - NearFlow::kRows, tile.y0);
    if (surface.upper) clearFlow({tile.x0, tile.y0, tile.x1, upper}, out);
    if (surface.lower) clearFlow({tile.x0, lower, tile.x1, tile.y1}, out);
    if (surface.left) clearFlow({tile.x0, tile.y0, left, tile.y1}, out);
    if (surface.right) clearFlow({right, tile.y0, tile.x1, tile.y1}, out);
}

/// Where edges are looked for in some row of the tile (edgeColumns()), and a tile more on either side.
ColumnSpan columnsAround(const Extent& tile, const Extent& rows, const GBuffer& out)
{
    ColumnSpan all;
    for (const int y : {tile.y0 - 1, tile.y0, tile.y1})
        if (y >= rows.y0 && y < rows.y1) all = all.with(out.surfaceColumns(y));
    return all.empty() ? all : ColumnSpan{all.x0 - TileKeys::kSize, all.x1 + TileKeys::kSize};
}

}  // namespace

void clearTile(const Extent& tile, GBuffer& out)
{
    out.invDepth.fill(tile, 0);
    out.flow.fill(tile, 0);
}

void findSurfaceColumns(const Visibility& visibility, const Extent& rows, const std::vector<char>& seen, GBuffer& out)
{
    for (int y = rows.y0; y < rows.y1; ++y) out.surfaceColumns(y) = {rows.x1, rows.x1};
    for (std::size_t i = seen.size(); i-- > 0;) {
        if (!seen[i]) continue;
        const Extent tile = visibility.tileExtent(int(i));
        for (int y = tile.y0; y < tile.y1; ++y) {
            ColumnSpan& columns = out.surfaceColumns(y);
            if (columns.empty()) columns.x1 = tile.x1;
            columns.x0 = tile.x0;
        }
    }
}

void clearBackground(const Visibility& visibility, const std::vector<char>& seen, GBuffer& out)
{
    parallelFor(seen.size(), [&](std::size_t i) {
        if (seen[i]) return;
        const Extent tile = visibility.tileExtent(int(i));
        const ColumnSpan& surface = out.surfaceColumns(tile.y0);
        const auto within = [&](const ColumnSpan& columns) { return tile.x0 >= columns.x0 && tile.x1 <= columns.x1; };
        if (within(surface)) {
            clearTile(tile, out);
        } else {
            clearNear(tile, visibility.marksBeside(int(i), seen), out);
            if (within(columnsAround(tile, visibility.scissor(), out))) out.invDepth.fill(tile, 0);
        }
    });
}

}  // namespace aeolic::cpu
