#include "render/tile.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

const std::array<std::uint8_t, 4> kBlue{0, 0, 255, 255};

/// Draws what a renderer does: a surface in some columns of some rows, and background elsewhere.
void draw(Tile& tile, const Extent& rows, const Extent& surface)
{
    tile.resize(rows);
    tile.setBackground(kBlue);
    for (int y = rows.y0; y < rows.y1; ++y) {
        const bool any = y >= surface.y0 && y < surface.y1;
        tile.clearBeside(y, any ? ColumnSpan{surface.x0, surface.x1} : ColumnSpan{});
        if (any) std::fill_n(tile.row(y) + 4 * (surface.x0 - rows.x0), 4 * surface.width(), std::uint8_t{77});
    }
}

std::vector<std::uint8_t> fresh(const Extent& rows, const Extent& surface)
{
    Tile tile;
    draw(tile, rows, surface);
    return tile.rgba;
}

/// Stripes move and grow from frame to frame, and keep the memory with what was painted there.
TEST(Tile, WhateverWasPaintedBefore)
{
    const std::vector<Extent> stripes{{0, 10, 30, 20}, {0, 12, 30, 22}, {0, 0, 30, 8},   {0, 3, 30, 20}, {0, 3, 30, 3},
                                      {0, 40, 30, 60}, {0, 40, 20, 60}, {0, 10, 50, 30}, {5, 10, 55, 30}};
    Tile tile;
    for (std::size_t i = 0; i < 4 * stripes.size(); ++i) {
        const Extent rows = stripes[(5 * i) % stripes.size()];
        const int left = rows.x0 + int(i % 7), upper = rows.y0 + int(i % 3);
        const Extent surface{left, upper, std::min(left + int(3 * i % 11), rows.x1), upper + int(i % 9)};
        draw(tile, rows, surface);
        EXPECT_EQ(tile.rgba, fresh(rows, surface)) << "frame " << i;
    }
}

TEST(Tile, BackgroundStaysWhereRowsAreOthers)
{
    Tile tile;
    draw(tile, {0, 0, 40, 10}, {});
    tile.resize({0, 25, 40, 37});
    for (int y = 25; y < 35; ++y) EXPECT_TRUE(tile.paintedIn(y).empty()) << y;
    for (int y = 35; y < 37; ++y) EXPECT_EQ(tile.paintedIn(y).x1, 40) << "nothing is known of a row that is new";
}

}  // namespace
}  // namespace aeolic
