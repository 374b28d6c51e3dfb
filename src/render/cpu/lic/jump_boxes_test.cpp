#include "render/cpu/lic/hierarchical.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace aeolic::cpu {
namespace {

constexpr std::uint64_t kAlive = std::uint64_t{1} << 49;

std::uint64_t jump(int dx, int dy)
{
    return std::uint64_t(std::uint16_t(dx)) | std::uint64_t(std::uint16_t(dy)) << 16 | kAlive;
}

JumpLevel levelOf(const Extent& valid)
{
    JumpLevel level;
    level.units.displacementPx = 0.25f;
    level.jumps.resize(valid);
    for (int y = valid.y0; y < valid.y1; ++y) std::fill_n(level.jumps.row(y) + valid.x0, valid.width(), 0u);
    return level;
}

/// The boxes there would be if flow were in all columns.
NearFlow everywhere(const Extent& rows)
{
    return {rows, std::vector<ColumnSpan>(std::size_t(rows.height()), {rows.x0, rows.x1})};
}

JumpBoxes boxesOf(const JumpLevel& level, const NearFlow& near, const Extent& own)
{
    JumpBoxes boxes = emptyBoxes(level, own);
    addBoxes(level, near, own, own, boxes);
    return boxes;
}

TEST(JumpBoxes, HoldTheLeastAndTheLargestDisplacementRoundedDown)
{
    const Extent own{0, 8, 40, 20};
    JumpLevel level = levelOf(own);
    level.jumps.at(1, 8) = jump(256, -1);
    level.jumps.at(15, 15) = jump(-257, 511);
    level.jumps.at(39, 19) = jump(32767, -32768);
    const JumpBoxes boxes = boxesOf(level, everywhere(own), own);
    EXPECT_EQ(boxes.unitPx, 64.0f);
    ASSERT_EQ(boxes.columns, 3);
    ASSERT_EQ(boxes.boxes.size(), 6u);
    EXPECT_EQ(boxes.boxes[0], (JumpBox{-2, 1, -1, 1})) << "-257 is less than -256, 511 less than 512";
    EXPECT_EQ(boxes.boxes[5], (JumpBox{0, 127, -128, 0}));
    for (const std::size_t i : {1u, 2u, 3u, 4u}) EXPECT_TRUE(boxes.boxes[i].empty()) << i;
}

TEST(JumpBoxes, AJumpThatGoesNowhereIsOne)
{
    const Extent own{0, 0, 16, 8};
    JumpLevel level = levelOf(own);
    EXPECT_TRUE(boxesOf(level, everywhere(own), own).boxes[0].empty());
    level.jumps.at(3, 3) = jump(0, 0);
    EXPECT_EQ(boxesOf(level, everywhere(own), own).boxes[0], (JumpBox{0, 0, 0, 0}));
}

TEST(JumpBoxes, WhatWasNeverWrittenIsNotLookedAt)
{
    const Extent own{0, 0, 96, 8};
    JumpLevel level = levelOf(own);
    for (int y = 0; y < 8; ++y) std::fill_n(level.jumps.row(y), 96, jump(32767, 32767));
    std::vector<ColumnSpan> flow(8);
    flow[4] = {40, 41};
    const NearFlow near(own, flow);
    for (int y = 0; y < 8; ++y) std::fill(level.jumps.row(y) + near.at(y).x0, level.jumps.row(y) + near.at(y).x1, 0u);
    level.jumps.at(40, 4) = jump(-300, 300);
    const JumpBoxes boxes = boxesOf(level, near, own);
    for (std::size_t i = 0; i < boxes.boxes.size(); ++i)
        EXPECT_EQ(boxes.boxes[i], i == 2 ? (JumpBox{-2, 0, 0, 1}) : JumpBox{}) << i;
}

TEST(JumpBoxes, AreTheSameTileByTile)
{
    const Extent own{0, 3, 777, 40};
    JumpLevel level = levelOf(own);
    std::uint32_t random = 1;
    const auto next = [&] { return int(random = random * 1664525u + 1013904223u) >> 16; };
    for (int y = own.y0; y < own.y1; ++y)
        for (int x = 0; x < own.x1; ++x)
            if (next() % 3 == 0) level.jumps.at(x, y) = jump(next(), next());
    const NearFlow near = everywhere(own);
    JumpBoxes tiles = emptyBoxes(level, own);
    for (int y = own.y0; y < own.y1; y += 8)
        for (int x = 0; x < own.x1; x += 256)
            addBoxes(level, near, own, {x, y, std::min(x + 256, own.x1), std::min(y + 8, own.y1)}, tiles);
    EXPECT_EQ(tiles.boxes, boxesOf(level, near, own).boxes);
    for (int y = own.y0; y < own.y1; ++y)
        for (int x = 0; x < own.x1; ++x) {
            const std::uint64_t at = level.jumps.at(x, y);
            if (at == 0) continue;
            const JumpBox& box = tiles.boxes[std::size_t((y - own.y0) / 8 * tiles.columns + x / 16)];
            const int dx = std::int16_t(at) >> 8, dy = std::int16_t(at >> 16) >> 8;
            ASSERT_TRUE(dx >= box.x0 && dx <= box.x1 && dy >= box.y0 && dy <= box.y1) << x << "," << y;
        }
}

}  // namespace
}  // namespace aeolic::cpu
