#include <gtest/gtest.h>

#include <algorithm>

#include "render/cpu/lic/hierarchical.h"

namespace aeolic::cpu {
namespace {

constexpr Extent kImage{0, 0, 240, 64};
constexpr float kFlowUnitPx = 4.0f / 2048;

/// One flat sheet whose rows slide past each other: every other one is five times as fast.
GBuffer slidingRows(int unitsDown)
{
    GBuffer buffer;
    buffer.resize(kImage, false);
    buffer.flowUnitPx = kFlowUnitPx;
    for (int y = 0; y < kImage.height(); ++y)
        for (int x = 0; x < kImage.width(); ++x) {
            buffer.invDepth.at(x, y) = 1;
            buffer.flow.at(x, y) = flow_texel::pack(y % 2 == 0 ? 2000 : 400, unitsDown, 1 + (7 * x + 31 * y) % 255);
            for (int sy = -1; sy <= 1; ++sy)
                for (int sx = -1; sx <= 1; ++sx)
                    if ((sx != 0 || sy != 0) && kImage.contains(x + sx, y + sy))
                        buffer.links.at(x, y) |= std::uint8_t(1 << linkBit(sx, sy));
        }
    return buffer;
}

/// How far down jumps of each level lead at most, in pixels.
std::vector<float> farthestDown(GBuffer& buffer, const LicOptions& lic)
{
    const std::vector<ColumnSpan> columns(std::size_t(kImage.height()), {kImage.x0, kImage.x1});
    const NearFlow near(kImage, columns);
    FlowCells flow;
    flow.build(buffer, near, kHierarchicalSharpness);
    Hierarchy memory;
    LicImage values;
    values.resize(kImage);
    convolveHierarchical(buffer, flow, near, lic, kImage, nullptr, {}, memory, values);
    std::vector<float> farthest;
    for (const auto& level : memory.directions[0].levels) {
        int most = 0;
        for (int y = 0; y < kImage.height(); ++y)
            for (int x = 0; x < kImage.width(); ++x)
                most = std::max(most, int(std::int16_t(level.jumps.at(x, y) >> 16)));
        farthest.push_back(float(most) * level.units.displacementPx);
    }
    return farthest;
}

/// Where neighbours part, a trace must not be put on a neighbour's end: each jump of hundreds would add a row, and
/// guard rows would be too few.
TEST(JumpEnds, LieWhereTheStepsLead)
{
    LicOptions lic;
    lic.method = LicMethod::hierarchical;
    lic.steps = 128;
    for (const int unitsDown : {5, 28, 38, 48, 100}) {
        GBuffer buffer = slidingRows(unitsDown);
        const std::vector<float> farthest = farthestDown(buffer, lic);
        ASSERT_EQ(farthest.size(), 2u);
        for (std::size_t level = 0; level < 2; ++level) {
            const float steps = level == 0 ? 8 : 32, walked = steps * float(unitsDown) * kFlowUnitPx;
            EXPECT_NEAR(farthest[level], walked, 0.02f) << unitsDown << " units, level " << level;  // Rounded.
        }
    }
}

}  // namespace
}  // namespace aeolic::cpu
