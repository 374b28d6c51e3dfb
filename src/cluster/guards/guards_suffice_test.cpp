// Constructed flows whose traces read as far from their stripe as they may: several ranks' LIC values beside one's,
// byte for byte. Rows that a rank is not given are poisoned, so that whatever reads too far shows.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <mutex>
#include <string>

#include "cluster/guards/stripe_guards.h"
#include "ranks/thread_communicator.h"
#include "render/cpu/lic/lic_stage.h"
#include "render/limits.h"

namespace aeolic {
namespace {

constexpr int kWidth = 48, kHeight = 200;
constexpr int kNoSheet = -1;

/// What a pixel shows: displacement per step in pixels, and which sheet of the surface it is on.
struct Pixel {
    double dx = 0, dy = 0;
    int sheet = 0;
};
using FlowOf = std::function<Pixel(int x, int y)>;

/// A whole image of constructed flow.
struct Flow {
    std::string name;
    double maxStepPx;
    FlowOf at;

    float unitPx() const { return float(std::exp2(std::ceil(std::log2(maxStepPx))) / 2048); }
};

std::uint32_t hash(int x, int y)
{
    std::uint32_t h = std::uint32_t(x) * 0x9E3779B1u ^ std::uint32_t(y) * 0x85EBCA77u;
    h ^= h >> 15;
    h *= 0x2C1B3C6Du;
    return h ^ h >> 12;
}

std::uint32_t texelAt(const Flow& flow, int x, int y)
{
    const Pixel pixel = flow.at(x, y);
    if (pixel.sheet == kNoSheet) return 0;
    const auto units = [&](double px) { return std::clamp(int(std::lround(px / double(flow.unitPx()))), -2047, 2047); };
    return flow_texel::pack(units(pixel.dx), units(pixel.dy), hash(x, y) % 2 ? 255 : 1);
}

std::uint8_t linksAt(const Flow& flow, const Extent& known, int x, int y)
{
    std::uint8_t mask = 0;
    const int sheet = flow.at(x, y).sheet;
    for (int sy = -1; sy <= 1; ++sy)
        for (int sx = -1; sx <= 1; ++sx) {
            if ((sx == 0 && sy == 0) || sheet == kNoSheet || !known.contains(x + sx, y + sy)) continue;
            if (flow.at(x + sx, y + sy).sheet == sheet) mask |= std::uint8_t(1 << linkBit(sx, sy));
        }
    return mask;
}

/// A buffer over `valid`, right in `known`; elsewhere flow at full speed on one sheet that is everywhere.
void fill(const Flow& flow, const Extent& valid, const Extent& known, const Extent& linksKnownFrom, GBuffer& buffer)
{
    buffer.resize(valid, false);
    buffer.flowUnitPx = flow.unitPx();
    for (int y = valid.y0; y < valid.y1; ++y)
        for (int x = valid.x0; x < valid.x1; ++x) {
            const bool right = known.contains(x, y);
            buffer.flow.at(x, y) =
                right ? texelAt(flow, x, y) : flow_texel::pack(2000, hash(y, x) % 2 ? 2000 : -2000, 255);
            buffer.links.at(x, y) = right ? linksAt(flow, linksKnownFrom, x, y) : std::uint8_t{0xFF};
        }
}

const Extent kWhole{0, 0, kWidth, kHeight};

std::vector<float> valuesOf(cpu::LicStage& stage)
{
    std::vector<float> values;
    const Extent& extent = stage.values().valid();
    for (int y = extent.y0; y < extent.y1; ++y)
        values.insert(values.end(), stage.values().row(y) + extent.x0, stage.values().row(y) + extent.x1);
    return values;
}

/// A frame of other flow first: what memory holds where nothing is written must not matter.
void leaveOtherFlowBehind(const Flow& flow, const Extent& valid, const LicOptions& lic, const Extent& compute,
                          cpu::LicStage& stage)
{
    GBuffer other;
    fill(flow, valid, {}, {}, other);
    stage.run(other, lic, compute, nullptr);
}

std::vector<float> byOne(const Flow& flow, const LicOptions& lic)
{
    GBuffer buffer;
    fill(flow, kWhole, kWhole, kWhole, buffer);
    cpu::LicStage stage;
    stage.run(buffer, lic, kWhole, nullptr);
    return valuesOf(stage);
}

enum class Guards { bound, estimate, drawnAgain };

std::vector<float> byRanks(const Flow& flow, const LicOptions& lic, const Stripes& stripes, Guards guards)
{
    std::vector<float> all(std::size_t(kWidth) * std::size_t(kHeight));
    const TraceReach reach = traceReach(lic);
    const int bound = guardRowsBound(reach.steps, flow.maxStepPx, reach.levels);
    runRanks(stripes.ranks(), [&](Communicator& communicator) {
        const Extent stripe = stripes.extent(communicator.rank(), kWidth),
                     valid = withGuard(stripe, {bound, bound}, kHeight);
        cpu::LicStage stage;
        leaveOtherFlowBehind(flow, valid, lic, stripe, stage);
        GBuffer buffer;
        if (guards == Guards::drawnAgain) {
            fill(flow, valid, valid, valid, buffer);  // The outermost rows lack their neighbours' links.
            stage.run(buffer, lic, stripe, nullptr);
        } else {
            fill(flow, valid, stripe, kWhole, buffer);
            const std::vector<RowFlow> facts = gatherRowFlow(communicator, stripes, rowFlow(buffer, stripe));
            std::unique_ptr<GuardEstimate> estimate = std::make_unique<BoundReach>(flow.maxStepPx);
            if (guards == Guards::estimate)
                estimate = std::make_unique<VectorReach>(facts, double(flow.unitPx()), flow.maxStepPx, reach.levels);
            Bytes room;
            StripeGuards exchange(communicator, GuardPlan(stripes, std::move(estimate), facts), room);
            stage.run(buffer, lic, stripe, &exchange);
        }
        const std::vector<float> mine = valuesOf(stage);
        std::copy(mine.begin(), mine.end(), all.begin() + std::ptrdiff_t(stripe.y0) * kWidth);
    });
    return all;
}

/// Uniform flow of any direction and speed: by how much a trace misses a row is of every size.
std::vector<Flow> uniformFlows()
{
    std::vector<Flow> flows;
    for (const double maxStepPx : {1.0, 1.75})
        for (const double share : {1.0, 0.77, 0.376, 0.0208})
            for (const double degrees : {90.0, 50.0}) {
                const double dx = share * maxStepPx * std::cos(degrees * 0.0174532925),
                             dy = share * maxStepPx * std::sin(degrees * 0.0174532925);
                flows.push_back({"uniform " + std::to_string(dx) + ", " + std::to_string(dy), maxStepPx, [=](int, int) {
                                     return Pixel{dx, dy, 0};
                                 }});
            }
    return flows;
}

/// Columns that slide past each other, some up and some down: interpolated ends lie between neighbours that part.
std::vector<Flow> partingFlows()
{
    std::vector<Flow> flows;
    for (const int columns : {1, 3, 7})
        for (const double slow : {-1.0, 0.1, 0.45})
            flows.push_back(
                {"columns of " + std::to_string(columns) + ", " + std::to_string(slow), 1.0, [=](int x, int) {
                     return Pixel{0.05, x / columns % 2 ? slow : 0.99, 0};
                 }});
    for (const int rows : {1, 5})
        for (const double down : {0.02, 0.3})
            flows.push_back({"rows of " + std::to_string(rows) + ", " + std::to_string(down), 1.0, [=](int, int y) {
                                 return Pixel{y / rows % 2 ? 0.95 : 0.2, down, 0};
                             }});
    return flows;
}

/// Calm rows in which stripes end, and rapids at every distance from there.
std::vector<Flow> rapids()
{
    std::vector<Flow> flows;
    for (int distance = 0; distance < 12; distance += 3)
        flows.push_back({"rapids " + std::to_string(distance) + " rows from where stripes end", 1.75, [=](int, int y) {
                             const bool calm = std::abs((y + 20) % 40 - 20) <= distance;
                             return Pixel{0.3, calm ? 0.11 : 1.7, 0};
                         }});
    return flows;
}

/// Eddies, sheets with borders askew, and background: everything at once.
std::vector<Flow> eddies()
{
    std::vector<Flow> flows;
    for (int seed = 0; seed < 4; ++seed)
        flows.push_back({"eddies " + std::to_string(seed), 1.5, [=](int x, int y) {
                             const double angle = 3 * std::sin(0.05 * x + seed) + 3 * std::cos(0.031 * y + 2 * seed);
                             const double speed = 0.75 + 0.7 * std::sin(0.021 * (x + y) * (1 + seed % 3) + seed);
                             const int sheet = (x + (2 + seed % 3) * y / 2) % (17 + 4 * seed) == 0
                                                   ? kNoSheet
                                                   : (x + y / 3) / (9 + 5 * seed);
                             return Pixel{speed * std::cos(angle), speed * std::sin(angle), sheet};
                         }});
    return flows;
}

/// One direction for all, along the borders of sheets: traces of one direction lead up alone, those of the other down.
std::vector<Flow> oneWay()
{
    std::vector<Flow> flows;
    for (const double dy : {0.95, -0.95})
        flows.push_back({"along borders, " + std::to_string(dy), 1.0, [=](int x, int y) {
                             return Pixel{-0.2 * dy, dy, (x + y / 5) / 7};
                         }});
    return flows;
}

LicOptions licOf(LicMethod method, int steps)
{
    LicOptions lic;
    lic.method = method;
    lic.steps = steps;
    lic.integrator = Integrator::rk2;
    return lic;
}

void expectEnough(const std::vector<Flow>& flows, const LicOptions& lic)
{
    const Stripes stripes{{0, 60, 61, 61, 140, kHeight}};
    for (const Flow& flow : flows) {
        const std::vector<float> expected = byOne(flow, lic);
        for (const Guards guards : {Guards::bound, Guards::estimate, Guards::drawnAgain}) {
            const std::vector<float> values = byRanks(flow, lic, stripes, guards);
            std::size_t wrong = 0, first = values.size();
            for (std::size_t i = values.size(); i-- > 0;)
                if (std::memcmp(&values[i], &expected[i], sizeof(float)) != 0) ++wrong, first = i;
            EXPECT_EQ(wrong, 0u) << flow.name << ", "
                                 << (guards == Guards::bound      ? "bound"
                                     : guards == Guards::estimate ? "estimate"
                                                                  : "drawn again")
                                 << ", " << lic.steps << " steps, first in row " << first / kWidth;
        }
    }
}

TEST(GuardsSuffice, DirectTraces)
{
    for (const auto& flows : {uniformFlows(), rapids(), eddies()})
        for (const int steps : {2, 23}) expectEnough(flows, licOf(LicMethod::direct, steps));
}

TEST(GuardsSuffice, JumpsOfOneLevel)
{
    for (const auto& flows : {uniformFlows(), partingFlows(), rapids(), eddies()})
        for (const int steps : {3, 8, 24}) expectEnough(flows, licOf(LicMethod::hierarchical, steps));
}

TEST(GuardsSuffice, JumpsOfJumps)
{
    for (const auto& flows : {uniformFlows(), partingFlows(), rapids(), eddies(), oneWay()})
        for (const int steps : {100, 128}) expectEnough(flows, licOf(LicMethod::hierarchical, steps));
}

}  // namespace
}  // namespace aeolic
