#include "base/image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace aeolic {
namespace {

using Pixels = Image<std::uint32_t>;

/// Resizes, looks at all that lies around the extent, and fills the extent with what must not be seen there next time.
void expectZerosAround(Pixels& image, const Extent& valid)
{
    image.resize(valid);
    ASSERT_EQ(image.valid(), valid);
    for (int y = valid.y0 - Pixels::kApronRows; y < valid.y1 + Pixels::kApronRows; ++y)
        for (int x = valid.x0 - Pixels::kApron; x < valid.x1 + Pixels::kApron; ++x)
            if (!valid.contains(x, y)) {
                ASSERT_EQ(image.row(y)[x], 0u) << x << "," << y << " of " << valid.width() << "x" << valid.height();
            }
    for (int y = valid.y0; y < valid.y1; ++y) std::fill(image.row(y) + valid.x0, image.row(y) + valid.x1, 0xDEADBEEF);
}

Extent rows(int y0, int height, int width = 37)
{
    return {0, y0, width, y0 + height};
}

TEST(Image, ZerosLieAroundHoweverItWasSizedBefore)
{
    Pixels image;
    for (const int height : {30, 30, 31, 29, 22, 12, 11, 1, 0, 5, 40, 41, 49, 60, 3, 60, 0, 0, 25})
        expectZerosAround(image, rows(7 * height, height));
}

TEST(Image, AndOfOtherColumns)
{
    Pixels image;
    for (const int width : {37, 38, 33, 48, 49, 5, 5, 64, 37})
        for (const int height : {20, 9, 33}) expectZerosAround(image, rows(3, height, width));
    expectZerosAround(image, {-20, -10, 17, 12});
    expectZerosAround(image, {4, 1, 41, 40});
}

TEST(Image, ColumnZeroIsAlignedAndMemoryStaysWhereItSuffices)
{
    Pixels image;
    image.resize(rows(0, 50));
    const std::size_t bytes = image.bytes();
    for (const int height : {40, 3, 50}) {
        image.resize(rows(5, height));
        EXPECT_EQ(image.bytes(), bytes);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(image.row(6)) % (16 * sizeof(std::uint32_t)), 0u);
    }
}

}  // namespace
}  // namespace aeolic
