// What a trace counts must not depend on what another sheet of the surface shows, however a step or jump lands beside
// the border: two sheets that flow alike, one of them with one noise and then with another.

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "render/cpu/lic/lic_stage.h"
#include "render/cpu/lic/sheets-inl.h"

namespace aeolic::cpu {
namespace {

constexpr Extent kImage{0, 0, 80, 24};
constexpr float kFlowUnitPx = 4.0f / 2048;  // Steps of up to four pixels.

/// Pixels a step, to the right and down. Every other row flows faster by `slides` pixels.
struct Flow {
    double right, down, slides = 0;
};

/// The first column of another sheet: so many columns farther in each row.
struct Border {
    int column;
    double slope = 0;
    bool isBeyond(int x, int y) const { return x >= column + int(std::floor(slope * (y - kImage.height() / 2))); }
};

/// Beyond the border is another sheet, whose noise is `beyond`.
GBuffer twoSheets(const Flow& flow, const Border& border, int beyond)
{
    GBuffer buffer;
    buffer.resize(kImage, false);
    buffer.flowUnitPx = kFlowUnitPx;
    const auto units = [](double px) { return std::min(int(std::lround(px / double(kFlowUnitPx))), 2047); };
    for (int y = 0; y < kImage.height(); ++y)
        for (int x = 0; x < kImage.width(); ++x) {
            const bool isOther = border.isBeyond(x, y);
            const int noise = isOther ? beyond : (7 * x + 31 * y) % 2 ? 255 : 1;
            const double right = flow.right + (y % 2) * flow.slides;
            buffer.flow.at(x, y) = flow_texel::pack(units(right), units(flow.down), noise);
            buffer.links.at(x, y) = 0;
            for (int sy = -1; sy <= 1; ++sy)
                for (int sx = -1; sx <= 1; ++sx)
                    if ((sx != 0 || sy != 0) && kImage.contains(x + sx, y + sy) &&
                        border.isBeyond(x + sx, y + sy) == isOther)
                        buffer.links.at(x, y) |= std::uint8_t(1 << linkBit(sx, sy));
        }
    return buffer;
}

/// LIC values of the first sheet.
std::vector<float> valuesOf(const Flow& flow, const Border& border, int beyond, const LicOptions& lic)
{
    GBuffer buffer = twoSheets(flow, border, beyond);
    LicStage stage;
    stage.run(buffer, lic, kImage, nullptr);
    std::vector<float> values;
    for (int y = 0; y < kImage.height(); ++y)
        for (int x = 0; x < kImage.width(); ++x)
            if (!border.isBeyond(x, y)) values.push_back(stage.values().at(x, y));
    return values;
}

/// Borders of many columns: a trace comes to them from every place in a pixel.
void expectHeld(const Flow& flow, const LicOptions& lic, double slope = 0)
{
    for (int column = 30; column < 38; ++column) {
        const Border border{column, slope};
        ASSERT_EQ(valuesOf(flow, border, 1, lic), valuesOf(flow, border, 255, lic))
            << flow.right << " pixels a step, border " << column << ", slope " << slope;
    }
}

LicOptions licOf(LicMethod method, int steps)
{
    LicOptions lic;
    lic.method = method;
    lic.integrator = Integrator::euler;
    lic.steps = steps;
    return lic;
}

/// Steps about as long as open pixels vouch for, and longer ones.
TEST(SheetsHold, ForSteps)
{
    for (const double px : {0.9, 1.3, 1.45, 1.75, 1.95, 2.05, 2.2, 2.45, 2.65, 2.9, 3.3}) {
        expectHeld({px, 0}, licOf(LicMethod::direct, 12));
        expectHeld({px, 0.3}, licOf(LicMethod::hierarchical, 8));
    }
}

/// A joined jump's end is the mean of ends in two rows. Where the border is slanted, that may lie beyond it though each
/// of them does not: such a jump ends there.
TEST(SheetsHold, ForJoinedJumps)
{
    for (const double slope : {0.0, 0.5, 1.0, 1.5, 2.0, -1.0})
        for (const double px : {0.31, 0.47, 0.63})
            for (const double slides : {0.0, 0.02, 0.04})
                expectHeld({px, 0.03, slides}, licOf(LicMethod::hierarchical, 128), slope);
}

/// A joined jump ends on the second pixel beyond the one that is on the sheet for certain: the links of that one do not
/// reach so far, and the border lies between.
TEST(SheetsHold, WhereAJumpEnds)
{
    namespace simd = HWY_NAMESPACE;
    const simd::DF d;
    GBuffer buffer = twoSheets({1, 0}, {32}, 1);
    const simd::LinkImage links(buffer);
    for (const auto& [sheet, end, holds] : {std::tuple(0.49f, 1.4f, true), std::tuple(0.49f, 1.6f, false)}) {
        simd::Traces trace = simd::startTraces(buffer, links, 12 * links.stride + 30);
        trace.alive = hwy::HWY_NAMESPACE::FirstN(d, 1);  // One trace that looks links up makes all of a vector do so.
        trace.sheetX = hwy::HWY_NAMESPACE::Set(d, sheet);
        trace.dx = hwy::HWY_NAMESPACE::Set(d, end);
        simd::settle(links, trace);
        std::uint8_t alive[8] = {};
        hwy::HWY_NAMESPACE::StoreMaskBits(d, trace.alive, alive);
        EXPECT_EQ(alive[0] & 1, int(holds)) << end;
    }
}

}  // namespace
}  // namespace aeolic::cpu
