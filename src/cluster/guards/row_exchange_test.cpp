#include "cluster/guards/row_exchange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "ranks/thread_communicator.h"
#include "render/gbuffer.h"

namespace aeolic {
namespace {

constexpr int kNoise = flow_texel::kNoiseZero;

Image<std::uint32_t> emptyFlow(const Extent& valid)
{
    Image<std::uint32_t> flow;
    flow.resize(valid);
    for (int y = valid.y0; y < valid.y1; ++y) std::fill_n(flow.row(y) + valid.x0, valid.width(), 0u);
    return flow;
}

/// The facts of a G-buffer with that flow.
std::vector<RowFlow> factsOf(const Image<std::uint32_t>& flow, const Extent& own)
{
    GBuffer buffer;
    buffer.resize(flow.valid(), false);
    for (int y = flow.valid().y0; y < flow.valid().y1; ++y)
        std::copy_n(flow.row(y) + flow.valid().x0, flow.valid().width(), buffer.flow.row(y) + flow.valid().x0);
    return rowFlow(buffer, own);
}

TEST(RowFlow, SpanFromTheFirstToTheLastPixelWithFlowHolesIncluded)
{
    Image<std::uint32_t> flow = emptyFlow({0, 0, 20, 4});
    for (const int x : {3, 4, 11}) flow.at(x, 1) = flow_texel::pack(1, 2, kNoise);
    flow.at(0, 2) = flow.at(19, 2) = flow_texel::pack(0, 0, kNoise);
    const std::vector<RowFlow> facts = factsOf(flow, {0, 0, 20, 4});
    EXPECT_EQ(facts[0], (RowFlow{0, 0, 0})) << "a row without flow";
    EXPECT_EQ(facts[1], (RowFlow{3, 12, 2}));
    EXPECT_EQ(facts[2], (RowFlow{0, 20, 0})) << "flow that stands still is flow";
    EXPECT_EQ(facts[3], (RowFlow{0, 0, 0}));
}

TEST(RowFlow, WhatLiesBesideTheSurfaceIsNoFlow)
{
    GBuffer buffer;
    buffer.resize({0, 0, 64, 2}, false);
    for (int y = 0; y < 2; ++y) std::fill_n(buffer.flow.row(y), 64, flow_texel::pack(1, 2, kNoise));
    buffer.surfaceColumns(0) = {16, 33};
    buffer.surfaceColumns(1) = {64, 64};
    EXPECT_EQ(rowFlow(buffer, {0, 0, 64, 2}), (std::vector<RowFlow>{{16, 33, 2}, {0, 0, 0}}));
}

TEST(RowFlow, LargestDisplacementUpOrDownWhateverGoesSideways)
{
    Image<std::uint32_t> flow = emptyFlow({0, 0, 8, 3});
    flow.at(1, 0) = flow_texel::pack(2047, 5, kNoise);
    flow.at(2, 0) = flow_texel::pack(-2047, -17, kNoise);
    flow.at(3, 1) = flow_texel::pack(0, 2047, 255);
    flow.at(3, 2) = flow_texel::pack(0, -2047, 1);
    const std::vector<RowFlow> facts = factsOf(flow, {0, 0, 8, 3});
    EXPECT_EQ(facts[0].maxUnits, 17);
    EXPECT_EQ(facts[1].maxUnits, 2047);
    EXPECT_EQ(facts[2].maxUnits, 2047);
}

TEST(RowFlow, OfTheStripeAloneNotOfItsGuard)
{
    Image<std::uint32_t> flow = emptyFlow({0, 5, 8, 12});
    flow.at(1, 6) = flow.at(2, 8) = flow_texel::pack(0, 3, kNoise);
    const std::vector<RowFlow> facts = factsOf(flow, {0, 8, 8, 10});
    ASSERT_EQ(facts.size(), 2u);
    EXPECT_EQ(facts[0], (RowFlow{2, 3, 3}));
    EXPECT_EQ(facts[1], RowFlow{});
}

RowFlow factsOf(int row)
{
    return {std::uint16_t(row), std::uint16_t(2 * row + 1), std::uint16_t(3 * row)};
}

std::vector<RowFlow> factsOf(const Extent& rows)
{
    std::vector<RowFlow> facts;
    for (int y = rows.y0; y < rows.y1; ++y) facts.push_back(factsOf(y));
    return facts;
}

TEST(RowFlow, AreEveryonesInTheOrderOfTheRows)
{
    for (const Stripes& stripes : {Stripes{{0, 11}}, Stripes{{0, 4, 11}}, Stripes{{0, 0, 5, 5, 11, 11}}})
        runRanks(stripes.ranks(), [&](Communicator& communicator) {
            const std::vector<RowFlow> own = factsOf(stripes.extent(communicator.rank(), 100));
            EXPECT_EQ(gatherRowFlow(communicator, stripes, own), factsOf({0, 0, 100, 11}));
            EXPECT_EQ(communicator.received().bytes, 6 * (11 - std::int64_t(own.size()))) << "six bytes a row";
        });
}

TEST(RowFlow, AnotherPartitionThanTheOthersThinkIsFoundOut)
{
    const auto differ = [](Communicator& communicator) {
        const Stripes stripes = communicator.isRoot() ? Stripes{{0, 5, 10}} : Stripes{{0, 6, 10}};
        gatherRowFlow(communicator, stripes, factsOf(stripes.extent(communicator.rank(), 100)));
    };
    EXPECT_THROW(runRanks(2, differ), std::logic_error);
    const auto others = [](Communicator& communicator) {
        gatherRowFlow(communicator, Stripes{{0, 5, 10}}, factsOf({0, 0, 100, communicator.isRoot() ? 5 : 4}));
    };
    EXPECT_THROW(runRanks(2, others), std::runtime_error);
}

}  // namespace
}  // namespace aeolic
