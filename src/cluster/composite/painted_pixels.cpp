#include "cluster/composite/painted_pixels.h"

#include <cstring>

#include "base/parallel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cluster/composite/painted_pixels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace aeolic::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// RGBA to RGB.
void dropAlpha(const std::uint8_t* rgba, std::size_t pixels, std::uint8_t* rgb)
{
    const hn::FixedTag<std::uint8_t, 16> d;
    constexpr std::size_t kPixels = 4, kStoredPixels = 6;  // A store reaches into pixels that are written next.
    alignas(16) constexpr std::uint8_t kColors[16] = {0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 3, 7, 11, 15};
    const auto colors = hn::Load(d, kColors);
    std::size_t i = 0;
    for (; i + kStoredPixels <= pixels; i += kPixels)
        hn::StoreU(hn::TableLookupBytes(hn::LoadU(d, rgba + 4 * i), colors), d, rgb + 3 * i);
    for (; i < pixels; ++i) std::memcpy(rgb + 3 * i, rgba + 4 * i, 3);
}

}  // namespace aeolic::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic {
namespace {

HWY_EXPORT(dropAlpha);

constexpr std::size_t kRowsAtOnce = 64;

void copyPixels(const std::uint8_t* rgba, std::size_t pixels, int channels, std::uint8_t* out)
{
    if (channels == 4)
        std::copy_n(rgba, 4 * pixels, out);
    else
        HWY_DYNAMIC_DISPATCH(dropAlpha)(rgba, pixels, out);
}

const std::uint8_t* pixelsOf(const Tile& tile, int y)
{
    return tile.row(y) + 4 * std::ptrdiff_t(tile.painted[std::size_t(y - tile.extent.y0)].x0 - tile.extent.x0);
}

/// Puts rows in place: copy(row, where) writes the painted pixels of one.
template <class Rows, class Copy>
void layOutRows(const Rows& rows, const PictureRows& into, const Copy& copy)
{
    const Extent& extent = rows.extent;
    const auto channels = std::size_t(into.channels), width = std::size_t(extent.width());
    std::vector<std::uint8_t> background(width * channels);
    for (std::size_t i = 0; i < background.size(); ++i) background[i] = rows.background[i % channels];
    parallelRanges(std::size_t(std::max(extent.height(), 0)), kRowsAtOnce, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            const ColumnSpan columns = rows.painted[row];
            const auto x0 = columns.empty() ? std::size_t{0} : std::size_t(columns.x0 - extent.x0),
                       x1 = columns.empty() ? std::size_t{0} : std::size_t(columns.x1 - extent.x0);
            std::uint8_t* out = into.pixels + (std::size_t(extent.y0 - into.firstRow) + row) * width * channels;
            std::copy_n(background.data(), x0 * channels, out);
            copy(row, out + x0 * channels);
            std::copy_n(background.data(), (width - x1) * channels, out + x1 * channels);
        }
    });
}

}  // namespace

std::size_t PaintedPixels::rowBytes(std::size_t row) const
{
    const ColumnSpan columns = painted[row];
    return columns.empty() ? 0 : std::size_t(columns.x1 - columns.x0) * std::size_t(channels());
}

std::size_t PaintedPixels::allBytes() const
{
    std::size_t sum = 0;
    for (std::size_t row = 0; row < painted.size(); ++row) sum += rowBytes(row);
    return sum;
}

void pack(const Tile& tile, PaintedPixels& into)
{
    into.extent = tile.extent;
    into.background = tile.background;
    into.painted = tile.painted;
    into.bytes.clear();
    into.bytes.resize(into.allBytes());
    auto* out = reinterpret_cast<std::uint8_t*>(into.bytes.data());
    for (int y = tile.extent.y0; y < tile.extent.y1; ++y) {
        const std::size_t bytes = into.rowBytes(std::size_t(y - tile.extent.y0));
        if (bytes == 0) continue;
        copyPixels(pixelsOf(tile, y), bytes / std::size_t(into.channels()), into.channels(), out);
        out += bytes;
    }
}

void layOut(const Tile& rows, const PictureRows& into)
{
    layOutRows(rows, into, [&](std::size_t row, std::uint8_t* out) {
        const ColumnSpan columns = rows.painted[row];
        if (columns.empty()) return;
        copyPixels(pixelsOf(rows, rows.extent.y0 + int(row)), std::size_t(columns.x1 - columns.x0), into.channels, out);
    });
}

void layOut(const PaintedPixels& rows, const PictureRows& into)
{
    std::vector<std::size_t> firstByte{0};
    for (std::size_t row = 0; row < rows.painted.size(); ++row)
        firstByte.push_back(firstByte.back() + rows.rowBytes(row));
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(rows.bytes.data());
    layOutRows(rows, into, [&](std::size_t row, std::uint8_t* out) {
        std::copy_n(bytes + firstByte[row], rows.rowBytes(row), out);
    });
}

}  // namespace aeolic
#endif
