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

/// Rolls, and looks at what stays and at what lies around.
void expectKept(Pixels& image, const Extent& from, const Extent& to, int keepFrom)
{
    const auto valueOf = [](int x, int y) { return 1000u * std::uint32_t(y + 500) + std::uint32_t(x); };
    image.resize(from);
    for (int y = from.y0; y < from.y1; ++y)
        for (int x = from.x0; x < from.x1; ++x) image.at(x, y) = valueOf(x, y);
    image.roll(to, keepFrom);
    ASSERT_EQ(image.valid(), to);
    for (int y = std::max({from.y0, to.y0, keepFrom}); y < std::min(from.y1, to.y1); ++y)
        for (int x = to.x0; x < to.x1; ++x) ASSERT_EQ(image.at(x, y), valueOf(x, y)) << x << "," << y;
    const Extent held{to.x0, std::max(to.y0, keepFrom), to.x1, to.y1};
    for (int y = held.y0 - Pixels::kApronRows; y < held.y1 + Pixels::kApronRows; ++y)
        for (int x = held.x0 - Pixels::kApron; x < held.x1 + Pixels::kApron; ++x)
            if (!held.contains(x, y)) {
                ASSERT_EQ(image.row(y)[x], 0u) << x << "," << y;
            }
}

TEST(Image, RollsDownAPicture)
{
    Pixels image;
    expectKept(image, rows(0, 30), rows(10, 30), 0);
    expectKept(image, rows(0, 30), rows(10, 30), 25);
    expectKept(image, rows(0, 30), rows(3, 30), 0);   // Rows go where others come from.
    expectKept(image, rows(0, 30), rows(20, 12), 0);  // The last window,
    expectKept(image, rows(0, 30), rows(10, 90), 0);  // one that grows,
    expectKept(image, rows(0, 30), rows(30, 30), 0);  // one that has nothing in common with the last,
    expectKept(image, rows(0, 30), rows(70, 20), 0);
    expectKept(image, rows(5, 30), rows(0, 30), 0);  // or goes up.
    expectKept(image, {-7, -20, 50, 40}, {-7, 0, 50, 60}, -50);
    for (const Extent& other : {rows(10, 30, 38), rows(10, 30, 20), Extent{1, 10, 38, 40}}) {  // Other columns.
        image.resize(rows(0, 30));
        image.roll(other, 0);
        expectZerosAround(image, other);
        image.roll(rows(20, 30), 0);
        expectZerosAround(image, rows(20, 30));
    }
    Pixels empty;
    empty.roll(rows(4, 9), 0);
    EXPECT_EQ(empty.valid(), rows(4, 9));
}

TEST(Image, RollsWithMemoryForTheLastRowsAlone)
{
    Pixels whole;
    whole.resize(rows(0, 1000));
    Pixels image;
    for (const int y0 : {0, 100, 200, 350}) {
        image.roll(rows(y0, 1000), y0 + 950);
        EXPECT_EQ(image.valid(), rows(y0, 1000));
        EXPECT_LT(image.bytes(), whole.bytes() / 5);
        for (int y = y0 + 950 - Pixels::kApronRows; y < y0 + 1000; ++y)
            for (int x = 0; x < 37; ++x) {
                const bool held = y >= y0 + 950;
                if (!held) {
                    ASSERT_EQ(image.at(x, y), 0U) << x << "," << y;
                }
                if (held) image.at(x, y) = 9;
            }
    }
    image.resizeFrom(rows(0, 1000), 990);
    EXPECT_EQ(image.at(3, 989), 0U);
    expectZerosAround(image, rows(0, 1000));
}

TEST(Image, LargeOnesAreRolledInPartsAndHaveZerosAround)
{
    constexpr int width = 3000, height = 1500;
    Pixels image;
    expectZerosAround(image, rows(0, height, width));
    expectKept(image, rows(0, height, width), rows(1000, height, width), 0);
    expectKept(image, rows(0, height, width), rows(300, height, width), 0);
    expectKept(image, rows(0, height, width), rows(1000, 3 * height, width), 0);
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
