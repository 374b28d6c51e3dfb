#include <gtest/gtest.h>

#include "aeolic/error.h"
#include "render/gl/device/scene_limits.h"

/// The message about a scene that does not fit a device. It is made from numbers alone, so no device is needed.
namespace aeolic::gl {
namespace {

GridField grid(const GridIndex& dims, FieldPrecision precision = FieldPrecision::float32)
{
    GridField field;
    field.dims = dims;
    field.precision = precision;
    field.name = "U";
    return field;
}

SceneSizes withField(const GridField& field, std::uint64_t triangles = 0)
{
    SceneSizes sizes;
    sizes.surface = {"wing", triangles / 2, triangles};
    sizes.field = field;
    return sizes;
}

std::string refusal(const SceneSizes& sizes, const DeviceLimits& limits, bool fresh = true)
{
    try {
        requireLimits(sizes, limits, fresh);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

constexpr std::uint64_t kMb = 1 << 20;
constexpr DeviceLimits kLarge{16384, std::uint64_t{1} << 31, 80'000 * kMb};

TEST(GlLimits, WhatFitsIsNotRefused)
{
    EXPECT_EQ(refusal(withField(grid({1024, 1024, 1024}), 1'000'000), kLarge), "");
    EXPECT_EQ(refusal({}, {1, 1, 1}), "") << "nothing is known";
    EXPECT_EQ(refusal(withField(grid({2048, 2048, 2048})), {16384, 1 << 30, std::nullopt}), "")
        << "a driver that does not tell";
    EXPECT_EQ(refusal(withField(grid({2048, 2048, 2048})), kLarge, false), "") << "in the place of what is there";
}

TEST(GlLimits, AFieldLargerThanTheMemorySaysHowManyGpusWouldDo)
{
    EXPECT_EQ(refusal(withField(grid({2048, 2048, 2048})), kLarge),
              "U: 2048x2048x2048 samples take 131072 MB of GPU memory; expected at most the 80000 MB that are free: 2 "
              "or more GPUs with --bricks on, --field-precision half, or --backend cpu");
    EXPECT_EQ(refusal(withField(grid({2048, 2048, 2048}, FieldPrecision::float16)), kLarge), "");
    const std::string enough =
        refusal(withField(grid({2048, 2048, 2048}), 200'000'000), {16384, 1ull << 40, 20'000 * kMb});
    EXPECT_NE(enough.find("at most the 20000 MB that are free: 12 or more GPUs"), std::string::npos)
        << "131072 MB over the 11608 MB that the surface leaves: " << enough;
}

TEST(GlLimits, RanksOnOneGpuShareIt)
{
    DeviceLimits limits = kLarge;
    limits.ranks = 4;
    EXPECT_EQ(refusal(withField(grid({1024, 1024, 1024})), limits), "");
    limits.ranks = 5;
    EXPECT_EQ(refusal(withField(grid({1024, 1024, 1024})), limits),
              "U: 1024x1024x1024 samples take 16384 MB of GPU memory; expected at most the 16000 MB that are free for "
              "each of the 5 ranks on this GPU: 2 or more GPUs with --bricks on, --field-precision half, or --backend "
              "cpu");
}

TEST(GlLimits, AScalarTakesItsShare)
{
    SceneSizes sizes = withField(grid({1000, 1000, 1000}));
    sizes.scalarField = grid({1000, 1000, 1000});
    sizes.scalarField->components = 1;
    EXPECT_EQ(refusal(sizes, {16384, 1 << 30, 20'000'000'000}), "");
    EXPECT_NE(refusal(sizes, {16384, 1 << 30, 19'999'999'999}), "");
}

TEST(GlLimits, AFieldLongerThanATextureSaysHowManyRanksWouldDo)
{
    EXPECT_EQ(refusal(withField(grid({40000, 2, 2})), kLarge),
              "U: 40000x2x2 samples, more than a texture of this GPU takes; expected at most 16384 along each side: 3 "
              "ranks or more with --bricks on, or --backend cpu");
    GridField brick = grid({40000, 2, 2});
    brick.brick = Brick{{0, 0, 0}, {20000, 1, 1}};
    EXPECT_NE(refusal(withField(brick), kLarge).find("U: 20001x2x2 samples"), std::string::npos);
    EXPECT_NE(refusal(withField(brick), kLarge).find(": 3 ranks or more"), std::string::npos);
    brick.brick = Brick{{0, 0, 0}, {16383, 1, 1}};
    EXPECT_EQ(refusal(withField(brick), kLarge), "");
}

TEST(GlLimits, RanksThatAreEnoughAreThoseOfTheBricks)
{
    GridField field = grid({101, 101, 101});
    for (const int ranks : {1, 2, 3, 7, 16}) {
        const BrickTree tree(field.dims, ranks);
        std::int64_t most = 0;
        for (int r = 0; r < ranks; ++r) most = std::max(most, tree.brick(r).sampleCount());
        EXPECT_EQ(ranksEnough(withField(field), 1000, std::uint64_t(most) * 16), ranks);
    }
    EXPECT_EQ(ranksEnough(withField(field), 51, ~std::uint64_t{0}), 8);
    const int many = ranksEnough(withField(grid({101, 2, 2})), 2, ~std::uint64_t{0}).value_or(0);
    EXPECT_TRUE(many >= 100 && many <= 106) << many << ": a sixteenth more at most";
    EXPECT_EQ(ranksEnough(withField(field), 1, ~std::uint64_t{0}), std::nullopt) << "no brick is that small";
}

TEST(GlLimits, ASurfaceLongerThanABufferOrLargerThanTheMemory)
{
    SceneSizes sizes;
    sizes.surface = {"wing", 50'000'000, 100'000'000};
    EXPECT_EQ(refusal(sizes, kLarge),
              "wing: 100000000 triangles; expected at most 178956970 triangles and 44739242 "
              "points on this GPU, or --backend cpu");
    EXPECT_EQ(refusal(sizes, {16384, 1ull << 40, 3'000 * kMb}),
              "wing: 100000000 triangles take 4196 MB of GPU memory; expected at most the 3000 MB that are free: fewer "
              "ranks on this GPU, or --backend cpu");
}

TEST(GlLimits, OnlyTheMemoryOfADeviceThatHasItsOwnIsALimit)
{
    constexpr std::int64_t kGb = 1 << 20;  // In kilobytes.
    const auto free = [](const MemoryReport& report) { return freeBytesOf(report); };
    EXPECT_EQ(free({false, 80 * kGb, 79 * kGb}), std::uint64_t{79} << 30);
    EXPECT_EQ(free({false, 8 * kGb, 31}), std::uint64_t{31} << 10) << "a card that others fill";
    EXPECT_EQ(free({false, 8 * kGb, 0}), 0u);
    EXPECT_EQ(free({true, 8 * kGb, 4 * kGb}), std::nullopt) << "a program";
    EXPECT_EQ(free({false, 32000, 32000}), std::nullopt) << "a part of the processor's memory";
    EXPECT_EQ(free({false, 0, 32000}), std::nullopt);
    EXPECT_EQ(free({false, 8 * kGb, 9 * kGb}), std::nullopt) << "more than there is";
    EXPECT_EQ(free({false, 8 * kGb, -1}), std::nullopt);
}

TEST(GlLimits, ASurfaceInPieces)
{
    SceneSizes sizes;
    sizes.inPieces = true;
    EXPECT_EQ(refusal(sizes, kLarge),
              "--backend: gl, but a surface in pieces is drawn by processors alone; expected "
              "cpu or auto, or --bricks off");
}

}  // namespace
}  // namespace aeolic::gl
