// How many rows around a pixel its links and the flow cells beside it depend on: what guard rows must hold beyond the
// row that a trace gets to (render/limits.h).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "render/cpu/lic/flow_cells.h"
#include "render/cpu/project/links.h"
#include "render/lic/jump_plan.h"
#include "render/limits.h"

namespace aeolic::cpu {
namespace {

constexpr Extent kImage{0, 0, 32, 24};
constexpr int kRow = 12, kColumn = 16;

/// One flat sheet that flows everywhere.
GBuffer sheet()
{
    GBuffer buffer;
    buffer.resize(kImage, false);
    for (int y = 0; y < kImage.height(); ++y)
        for (int x = 0; x < kImage.width(); ++x) {
            buffer.invDepth.at(x, y) = 1;
            buffer.gradX.at(x, y) = buffer.gradY.at(x, y) = 0;
            buffer.flow.at(x, y) = flow_texel::pack(100, 100, 128);
            buffer.links.at(x, y) = 0xFF;
        }
    return buffer;
}

FlowCells cellsOf(const GBuffer& buffer)
{
    const std::vector<ColumnSpan> columns(std::size_t(kImage.height()), {kImage.x0, kImage.x1});
    FlowCells cells;
    cells.build(buffer, NearFlow(kImage, columns), kHierarchicalSharpness);
    return cells;
}

bool sameCells(const FlowCells& a, const FlowCells& b, int row)
{
    return std::memcmp(a.cells.row(row), b.cells.row(row), sizeof(FlowCell) * std::size_t(kImage.width())) == 0;
}

/// What is read between rows kRow and kRow + 1, when the noise or the links of another row are changed.
TEST(ReadRows, FlowCells)
{
    const FlowCells before = cellsOf(sheet());
    int first = kRow, last = kRow;
    for (int y = 4; y < 20; ++y) {
        GBuffer noise = sheet(), links = sheet();
        noise.flow.at(kColumn, y) = flow_texel::pack(100, 100, 255);
        links.links.at(kColumn, y) = 0;
        if (sameCells(before, cellsOf(noise), kRow) && sameCells(before, cellsOf(links), kRow)) continue;
        first = std::min(first, y);
        last = std::max(last, y);
    }
    EXPECT_EQ(first, kRow - limits::kOpenRings);
    EXPECT_EQ(last, kRow + limits::kCellRows);
}

TEST(ReadRows, LinksOfAPixel)
{
    View view;
    view.focalPx = 100;
    const auto linksOf = [&](GBuffer buffer) {
        linkSheets(view, kImage, buffer);
        return buffer.links.at(kColumn, kRow);
    };
    int farthest = 0;
    for (int y = 4; y < 20; ++y) {
        GBuffer hole = sheet();
        for (int x = 0; x < kImage.width(); ++x) hole.flow.at(x, y) = 0;
        if (y != kRow && linksOf(std::move(hole)) != linksOf(sheet()))
            farthest = std::max(farthest, std::abs(y - kRow));
    }
    EXPECT_EQ(farthest, limits::kLinkRows);
}

/// The row that a trace gets to, and what it reads beyond. The links there may depend on a row more, which ranks that
/// draw their guards again have not.
TEST(ReadRows, BeyondWhereATraceGetsTo)
{
    EXPECT_GE(limits::kTapRows, limits::kCellRows + limits::kLinkRows);
}

/// A trace is half a pixel from its sheet's pixel at most, and goes kOpenReachPx from there without looking links up.
/// There it looks at the pixel before and the one after.
TEST(ReadRows, BesideASheet)
{
    const int before = int(std::floor(0.5 + limits::kOpenReachPx));
    EXPECT_EQ(limits::kNearPx, before + 1);
    EXPECT_GE(Image<std::uint32_t>::kApronRows, limits::kNearPx) << "beyond the picture's edge, too";
}

}  // namespace
}  // namespace aeolic::cpu
