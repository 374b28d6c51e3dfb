#include "cluster/composite/painted_pixels.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

using Color = std::array<std::uint8_t, 4>;
constexpr Extent kRows{0, 30, 67, 70};

/// Rows with every number of painted pixels from none to all, at any place.
Tile painted(const Color& background)
{
    Tile tile;
    tile.resize(kRows);
    tile.setBackground(background);
    for (int y = kRows.y0; y < kRows.y1; ++y) {
        const int count = (y - kRows.y0) * kRows.width() / (kRows.height() - 1),
                  x0 = (y * 7) % (kRows.width() - count + 1);
        tile.clearBeside(y, count == 0 ? ColumnSpan{} : ColumnSpan{x0, x0 + count});
        for (int x = x0; x < x0 + count; ++x) {
            const Color color{std::uint8_t(x), std::uint8_t(y), std::uint8_t(x * y), std::uint8_t(255 - background[0])};
            std::copy(color.begin(), color.end(), tile.row(y) + 4 * std::ptrdiff_t(x));
        }
    }
    return tile;
}

/// The picture's rows by the plainest means.
std::vector<std::uint8_t> expected(const Tile& tile, int channels)
{
    std::vector<std::uint8_t> pixels;
    for (std::size_t i = 0; i < tile.rgba.size(); ++i)
        if (i % 4 != 3 || channels == 4) pixels.push_back(tile.rgba[i]);
    return pixels;
}

TEST(PaintedPixels, AllPixelsComeToTheirPlaceAndNoOthersAreTouched)
{
    for (const Color& background : {Color{0, 128, 255, 255}, Color{255, 255, 255, 0}}) {
        const Tile tile = painted(background);
        PaintedPixels packed;
        pack(tile, packed);
        const int channels = packed.channels();
        EXPECT_EQ(channels, background[3] == 255 ? 3 : 4);
        EXPECT_EQ(packed.bytes.size(), packed.allBytes());
        for (const bool travelled : {false, true}) {
            Picture whole{kRows.width(), 100, channels, {}};
            const std::size_t rowBytes = std::size_t(kRows.width() * channels);
            whole.pixels.assign(100 * rowBytes, 77);
            if (travelled)
                layOut(packed, whole);
            else
                layOut(tile, whole);
            const auto first = whole.pixels.begin() + std::ptrdiff_t(std::size_t(kRows.y0) * rowBytes),
                       last = whole.pixels.begin() + std::ptrdiff_t(std::size_t(kRows.y1) * rowBytes);
            EXPECT_EQ(std::vector<std::uint8_t>(first, last), expected(tile, channels)) << travelled;
            EXPECT_EQ(std::count(whole.pixels.begin(), first, 77), first - whole.pixels.begin());
            EXPECT_EQ(std::count(last, whole.pixels.end(), 77), whole.pixels.end() - last);
        }
    }
}

/// Pixels are packed several at once. The last of a row end where the row does, however many they are.
TEST(PaintedPixels, NoByteBeyondARowOfAnyWidth)
{
    for (int width = 1; width <= 40; ++width) {
        Tile tile;
        tile.resize({0, 1, width, 2});
        tile.setBackground({0, 0, 0, 255});
        tile.clearBeside(1, {0, width});
        for (int i = 0; i < 4 * width; ++i) tile.row(1)[i] = i % 4 == 3 ? 255 : std::uint8_t(100 + i);
        Picture whole{width, 3, 3, {}};
        whole.pixels.assign(std::size_t(3 * 3 * width), 77);
        layOut(tile, whole);
        std::vector<std::uint8_t> rows(whole.pixels.size(), 77);
        const std::vector<std::uint8_t> row = expected(tile, 3);
        std::copy(row.begin(), row.end(), rows.begin() + 3 * width);
        EXPECT_EQ(whole.pixels, rows) << width;
        PaintedPixels packed;
        pack(tile, packed);
        ASSERT_EQ(packed.bytes.size(), row.size());
        EXPECT_TRUE(std::equal(row.begin(), row.end(), reinterpret_cast<const std::uint8_t*>(packed.bytes.data())));
    }
}

TEST(PaintedPixels, MemoryIsKeptAndNothingOfItShows)
{
    PaintedPixels packed;
    pack(painted({0, 0, 0, 255}), packed);
    Tile none;
    none.resize({0, 0, 5, 0});
    pack(none, packed);
    EXPECT_EQ(packed.allBytes(), 0u);
    EXPECT_TRUE(packed.bytes.empty());
    EXPECT_GT(packed.bytes.capacity(), 0u);
}

}  // namespace
}  // namespace aeolic
