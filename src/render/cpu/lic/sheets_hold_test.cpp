// What a trace counts must not depend on what another sheet of the surface shows, however a step or jump lands beside
// the border: two sheets that flow alike, one of them with one noise and then with another.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/cpu/lic/lic_stage.h"

namespace aeolic::cpu {
namespace {

constexpr Extent kImage{0, 0, 80, 24};
constexpr float kFlowUnitPx = 2.0f / 2048;  // Steps of up to two pixels.

/// Flow to the right and a little down: rows in turn of these speeds, pixels a step.
struct Flow {
    double even, odd, down;
};

/// Columns from `border` on are another sheet, whose noise is `beyond`.
GBuffer twoSheets(const Flow& flow, int border, int beyond)
{
    GBuffer buffer;
    buffer.resize(kImage, false);
    buffer.flowUnitPx = kFlowUnitPx;
    const auto units = [](double px) { return std::min(int(std::lround(px / double(kFlowUnitPx))), 2047); };
    for (int y = 0; y < kImage.height(); ++y)
        for (int x = 0; x < kImage.width(); ++x) {
            const bool other = x >= border;
            buffer.flow.at(x, y) = flow_texel::pack(units(y % 2 == 0 ? flow.even : flow.odd), units(flow.down),
                                                    other                  ? beyond
                                                    : (7 * x + 31 * y) % 2 ? 255
                                                                           : 1);
            buffer.links.at(x, y) = 0;
            for (int sy = -1; sy <= 1; ++sy)
                for (int sx = -1; sx <= 1; ++sx)
                    if ((sx != 0 || sy != 0) && kImage.contains(x + sx, y + sy) && (x + sx >= border) == other)
                        buffer.links.at(x, y) |= std::uint8_t(1 << linkBit(sx, sy));
        }
    return buffer;
}

/// LIC values of the sheet on the left.
std::vector<float> valuesBefore(int border, const Flow& flow, int beyond, const LicOptions& lic)
{
    GBuffer buffer = twoSheets(flow, border, beyond);
    LicStage stage;
    stage.run(buffer, lic, kImage, nullptr);
    std::vector<float> values;
    for (int y = 0; y < kImage.height(); ++y)
        values.insert(values.end(), stage.values().row(y), stage.values().row(y) + border);
    return values;
}

/// Every place in a pixel that a trace may be when it comes to the border: borders of many columns.
void expectHeld(const Flow& flow, const LicOptions& lic)
{
    for (int border = 30; border < 38; ++border)
        ASSERT_EQ(valuesBefore(border, flow, 1, lic), valuesBefore(border, flow, 255, lic))
            << flow.even << " and " << flow.odd << " pixels a step, border " << border;
}

LicOptions licOf(LicMethod method, int steps)
{
    LicOptions lic;
    lic.method = method;
    lic.integrator = Integrator::euler;
    lic.steps = steps;
    return lic;
}

/// Single steps of up to two pixels, the farthest that open pixels vouch for, and double steps of up to four.
TEST(SheetsHold, ForSteps)
{
    for (const double px : {0.9, 1.07, 1.2, 1.3, 1.45, 1.75, 1.95, 1.99}) {
        expectHeld({px, px, 0}, licOf(LicMethod::direct, 24));
        expectHeld({px, px, 0.3}, licOf(LicMethod::hierarchical, 8));
    }
}

/// Jumps of eight steps, some pixels long.
TEST(SheetsHold, ForJumps)
{
    for (const double px : {0.12, 0.19, 0.235, 0.245, 0.27, 0.3, 0.34, 0.43})
        expectHeld({px, px, 0.013}, licOf(LicMethod::hierarchical, 32));
}

/// Rows slide past each other: the end of an interpolated jump and that of the nearest pixel's part, by up to some
/// pixels.
TEST(SheetsHold, WhereNeighboursPart)
{
    for (const double px : {0.25, 0.5})
        for (const double more : {0.1, 0.16, 0.22, 0.3, 0.4})
            for (const double down : {0.02, 0.06})
                expectHeld({px, px + more, down}, licOf(LicMethod::hierarchical, 128));
}

}  // namespace
}  // namespace aeolic::cpu
