#include "stream/codec/row_filter.h"

#include <gtest/gtest.h>

#include <cstring>

#include "stream/codec/codec_testing.h"

namespace aeolic::stream {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(RowFilter, PlanesOfGreenAndWhatTheOthersDiffer)
{
    const Bytes pixels{10, 20, 30, 13, 18, 30, 12,  255, 0,  // Two rows of three pixels: rows do not see each other.
                       1,  2,  3,  0,  0,  0,  255, 128, 64};
    const Bytes planes{20, 18, 255, 246, 251, 13,  10, 12, 1,  // Green, red - green, blue - green, modulo 256.
                       2,  0,  128, 255, 0,   127, 1,  0,  192};
    Bytes expected = planes;  // Each byte less the byte before it.
    for (std::size_t i = 0; i < planes.size(); ++i)
        if (i % 3) expected[i] = std::uint8_t(planes[i] - planes[i - 1]);
    Bytes filtered(pixels.size());
    filterRows(pixels.data(), 3, 2, 3, filtered.data());
    EXPECT_EQ(filtered, expected);
    EXPECT_EQ(filtered[1], 254);  // 18 - 20.
    unfilterRows(filtered.data(), 3, 2, 3);
    EXPECT_EQ(filtered, pixels);
}

TEST(RowFilter, AlphaIsTheLastPlaneAsItIs)
{
    const Bytes pixels{10, 20, 30, 255, 13, 18, 30, 250};
    Bytes filtered(pixels.size());
    filterRows(pixels.data(), 2, 1, 4, filtered.data());
    EXPECT_EQ(filtered, (Bytes{20, 254, 246, 5, 10, 2, 255, 251}));
}

TEST(RowFilter, WideRowsAreAsNarrowOnesByTheFormula)
{
    for (const int channels : {3, 4}) {
        const test::Picture picture = test::noise(100, 1, channels);
        Bytes filtered(picture.bytes.size());
        filterRows(picture.bytes.data(), 100, 1, channels, filtered.data());
        const auto value = [&](int plane, int x) {
            const std::uint8_t* pixel = picture.bytes.data() + x * channels;
            const int source[] = {1, 0, 2, 3};
            return plane == 1 || plane == 2 ? pixel[source[plane]] - pixel[1] : pixel[source[plane]];
        };
        for (int plane = 0; plane < channels; ++plane)
            for (int x = 0; x < 100; ++x)
                ASSERT_EQ(filtered[std::size_t(plane * 100 + x)],
                          std::uint8_t(value(plane, x) - (x ? value(plane, x - 1) : 0)))
                    << plane << " " << x;
    }
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
