#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "aeolic/picture.h"
#include "base/extent.h"

namespace aeolic {

/// Rows of a picture whose other rows may be elsewhere. Coordinates are the whole picture's. Does not own the pixels.
struct PictureRows {
    int width = 0, height = 0;  ///< The whole picture's.
    int channels = 3;
    int firstRow = 0, rows = 0;  ///< Those that are here.
    std::uint8_t* pixels = nullptr;

    PictureRows(Picture& rowsOf, int wholeHeight, int first)
        : width(rowsOf.width),
          height(wholeHeight),
          channels(rowsOf.channels),
          firstRow(first),
          rows(rowsOf.height),
          pixels(rowsOf.pixels.data())
    {
    }
    PictureRows(Picture& whole) : PictureRows(whole, whole.height, 0) {}  // NOLINT: a picture is all of its rows.
};

/// Finished pixels of some rows: 8-bit RGBA, sRGB values, alpha not premultiplied, no padding. Most of a picture is
/// background, and stays background from frame to frame: a tile knows where it may hold anything else.
struct Tile {
    Extent extent;
    std::vector<std::uint8_t> rgba;
    std::array<std::uint8_t, 4> background{};  ///< In all pixels that are not painted.
    std::vector<ColumnSpan> painted;           ///< [rows] Columns that may hold something else.

    /// For these rows. The n-th row takes the memory of the n-th row before, wherever in the picture that was. Where
    /// rows are as wide as before, background stays background. A row that is new may hold anything.
    void resize(const Extent& rows)
    {
        const bool sameColumns = rows.x0 == extent.x0 && rows.x1 == extent.x1;
        const int height = std::max(rows.height(), 0), known = sameColumns ? int(painted.size()) : 0;
        extent = rows;
        rgba.resize(std::size_t(rows.width()) * std::size_t(height) * 4);
        painted.resize(std::size_t(height));
        paint(rows.y0 + std::min(known, height), rows.y1);
    }
    std::uint8_t* row(int y) { return rgba.data() + std::size_t(y - extent.y0) * std::size_t(extent.width()) * 4; }
    const std::uint8_t* row(int y) const
    {
        return rgba.data() + std::size_t(y - extent.y0) * std::size_t(extent.width()) * 4;
    }

    /// Replaces a pixel, RGBA.
    void put(int x, int y, const std::array<std::uint8_t, 4>& color)
    {
        std::memcpy(row(y) + 4 * std::ptrdiff_t(x - extent.x0), color.data(), color.size());
        paintedIn(y) = paintedIn(y).with({x, x + 1});
    }
    ColumnSpan& paintedIn(int y) { return painted[std::size_t(y - extent.y0)]; }
    /// Rows [y0, y1) may hold anything.
    void paint(int y0, int y1)
    {
        for (int y = y0; y < y1; ++y) paintedIn(y) = {extent.x0, extent.x1};
    }
    void setBackground(const std::array<std::uint8_t, 4>& color)
    {
        if (color == background) return;
        background = color;
        paint(extent.y0, extent.y1);
    }
    /// What row `y` holds beside `columns` becomes background. Where it is background already nothing is written.
    void clearBeside(int y, const ColumnSpan& columns)
    {
        ColumnSpan& before = paintedIn(y);
        const ColumnSpan kept = columns.empty() ? ColumnSpan{before.x1, before.x1} : columns;
        fill(y, before.x0, std::min(before.x1, kept.x0));
        fill(y, std::max(before.x0, kept.x1), before.x1);
        before = kept;
    }

private:
    void fill(int y, int x0, int x1)
    {
        const auto color = background;  // A copy, which the pixels written cannot change.
        std::uint8_t* pixels = row(y) - 4 * std::ptrdiff_t(extent.x0);
        for (int x = x0; x < x1; ++x) std::memcpy(pixels + 4 * std::ptrdiff_t(x), color.data(), 4);
    }
};

}  // namespace aeolic
