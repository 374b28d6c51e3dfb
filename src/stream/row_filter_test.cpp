#include "stream/row_filter.h"

#include <gtest/gtest.h>

#include <cstring>

#include "stream/codec_testing.h"

namespace aeolic::stream {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(RowFilter, TakesThePixelToTheLeftOffModulo256)
{
    const Bytes pixels{10, 20, 30, 13, 18, 30, 12,  255, 0,  // Two rows of three pixels: rows do not see each other.
                       1,  2,  3,  0,  0,  0,  255, 128, 64};
    const Bytes expected{10, 20, 30, 3, 254, 0, 255, 237, 226, 1, 2, 3, 255, 254, 253, 255, 128, 64};
    Bytes filtered(pixels.size());
    filterRows(pixels.data(), 3, 2, 3, filtered.data());
    EXPECT_EQ(filtered, expected);
    unfilterRows(filtered.data(), 3, 2, 3);
    EXPECT_EQ(filtered, pixels);
}

TEST(RowFilter, ComesBackAtEveryWidthAroundAVectors)
{
    for (const int channels : {3, 4})
        for (int width = 1; width <= 70; ++width) {
            const test::Picture picture = test::noise(width, 3, channels);
            Bytes filtered(picture.bytes.size());
            filterRows(picture.bytes.data(), width, 3, channels, filtered.data());
            unfilterRows(filtered.data(), width, 3, channels);
            ASSERT_EQ(filtered, picture.bytes) << width << " pixels of " << channels;
        }
}

TEST(RowFilter, TouchesNoByteBesideThePixels)
{
    const test::Picture picture = test::noise(37, 2, 3);
    Bytes filtered(picture.bytes.size() + 32, 0xAA);
    filterRows(picture.bytes.data(), 37, 2, 3, filtered.data() + 16);
    unfilterRows(filtered.data() + 16, 37, 2, 3);
    for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_EQ(filtered[i], 0xAA);
        EXPECT_EQ(filtered[filtered.size() - 1 - i], 0xAA);
    }
    EXPECT_EQ(std::memcmp(filtered.data() + 16, picture.bytes.data(), picture.bytes.size()), 0);
}

}  // namespace
}  // namespace aeolic::stream
