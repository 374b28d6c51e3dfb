#include "render/cpu/project/raster/raster.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "render/cpu/project/raster/transform.h"

namespace aeolic::cpu {
namespace {

constexpr Extent kTile{0, 0, TileKeys::kSize, TileKeys::kSize};
constexpr std::uint32_t kNear = 7, kOther = 3;

/// Draws the lower left half of a square of so many pixels, all at one depth.
void drawHalf(TileKeys& keys, int pixels, float invDepth, std::uint32_t id, const TileDepths* drawn)
{
    const std::int64_t side = std::int64_t(pixels) * kSubpixels;
    drawTriangle({0, 0, invDepth}, {side, side, invDepth}, {0, side, invDepth}, id, kTile, {}, drawn, keys);
}

/// A near triangle over the whole tile's lower left half; the other half shows nothing.
std::unique_ptr<TileKeys> halfATile()
{
    auto keys = std::make_unique<TileKeys>();
    std::memset(keys.get(), 0, sizeof *keys);
    drawHalf(*keys, TileKeys::kSize, 0.5f, kNear, nullptr);
    return keys;
}

TEST(FarthestDepths, AreThoseOfWholeBlocksAndZeroWhereAPixelShowsNothing)
{
    const auto keys = halfATile();
    const TileDepths drawn = farthestDepths(*keys);
    EXPECT_EQ(drawn.farthest[7][0], 0.5f) << "all covered";
    EXPECT_EQ(drawn.farthest[0][7], 0.0f) << "background";
    EXPECT_EQ(drawn.farthest[3][3], 0.0f) << "on the diagonal";
}

TEST(FarthestDepths, HideWhatLiesBeyondAllThatABoxOfBlocksShows)
{
    const auto keys = halfATile();
    const TileDepths drawn = farthestDepths(*keys);
    EXPECT_TRUE(drawn.hide(0.25f, 0, 56, 8, 64));
    EXPECT_FALSE(drawn.hide(0.5f, 0, 56, 8, 64)) << "as near: the smaller id shows";
    EXPECT_FALSE(drawn.hide(0.75f, 0, 56, 8, 64));
    EXPECT_FALSE(drawn.hide(0.25f, 0, 0, 64, 64)) << "some of it is beside the surface";
}

TEST(DrawTriangle, ShowsTheSameWithAndWithoutWhatIsDrawn)
{
    for (const float invDepth : {0.25f, 0.5f, 0.75f})
        for (const int pixels : {5, 40, 64}) {
            const auto with = halfATile(), without = halfATile();
            const TileDepths drawn = farthestDepths(*with);
            drawHalf(*with, pixels, invDepth, kOther, &drawn);
            drawHalf(*without, pixels, invDepth, kOther, nullptr);
            EXPECT_EQ(std::memcmp(with->key, without->key, sizeof with->key), 0) << invDepth << ", " << pixels;
            const std::uint32_t seen = TileKeys::triangle(with->key[4][0]);
            EXPECT_EQ(seen, invDepth < 0.5f ? kNear : kOther);
        }
}

}  // namespace
}  // namespace aeolic::cpu
