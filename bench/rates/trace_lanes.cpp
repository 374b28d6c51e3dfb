#include "rates/trace_lanes.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "render/lic/lic_kernel.h"

namespace aeolic::cpu {
namespace {

constexpr int kBlockLanes = 4;

int samplesPerStep(Integrator integrator)
{
    switch (integrator) {
        case Integrator::euler:
            return 1;
        case Integrator::rk2:
            return 2;
        case Integrator::rk4:
            return 4;
    }
    return 0;
}

/// Hops along links from (x, y) to the target. false: there is no way.
bool followLinks(const GBuffer& buffer, int& x, int& y, int toX, int toY)
{
    while (x != toX || y != toY) {
        const int hopX = std::clamp(toX - x, -1, 1), hopY = std::clamp(toY - y, -1, 1);
        if (!(buffer.links.at(x, y) >> linkBit(hopX, hopY) & 1)) return false;
        x += hopX;
        y += hopY;
    }
    return true;
}

/// A trace ends where the vector vanishes, and where the flow turns back (sinks, sources): so does the LIC stage.
bool flowsOn(std::uint32_t from, std::uint32_t to)
{
    return flow_texel::dx(from) * flow_texel::dx(to) + flow_texel::dy(from) * flow_texel::dy(to) > 2;
}

int walkedSteps(const GBuffer& buffer, int x, int y, float unitPx, int steps)
{
    float atX = float(x), atY = float(y);
    std::uint32_t texel = buffer.flow.at(x, y);
    if (!flowsOn(texel, texel)) return 0;
    for (int walked = 0; walked < steps; ++walked) {
        atX += float(flow_texel::dx(texel)) * unitPx;
        atY += float(flow_texel::dy(texel)) * unitPx;
        if (!followLinks(buffer, x, y, int(std::lround(atX)), int(std::lround(atY)))) return walked;
        const std::uint32_t next = buffer.flow.at(x, y);
        if (!flowsOn(texel, next)) return walked + 1;
        texel = next;
    }
    return steps;
}

}  // namespace

TraceLanes::TraceLanes(const LicOptions& lic)
    : method_(lic.method),
      steps_(lic.steps),
      samplesPerStep_(samplesPerStep(lic.integrator)),
      lanesPerJump_(2 * kBlockLanes + (makeKernelModel(lic).weighted() ? 4 : 0))
{
    if (method_ == LicMethod::hierarchical) plan_ = planJumps(lic.steps);
}

std::int64_t TraceLanes::of(int walkedSteps) const
{
    if (method_ == LicMethod::none) return 0;
    if (method_ == LicMethod::direct)
        return std::int64_t(std::min(walkedSteps + 1, steps_)) * samplesPerStep_ * kBlockLanes;

    // A jump is looked up where the trace still goes on at its start. The first of each sequence is read in a row.
    int jumps = 0;
    const auto jumpFrom = [&](int step) { jumps += step > 0 && walkedSteps >= step; };
    for (std::size_t level = 0; level < plan_.radix.size(); ++level)
        for (int j = 1; j < plan_.radix[level]; ++j) jumpFrom(j * plan_.stride(level));
    int step = 0;
    for (std::size_t level = plan_.digits.size(); level-- > 0;)
        for (int j = 0; j < plan_.digits[level]; ++j, step += plan_.stride(level)) jumpFrom(step);
    if (plan_.remainder > 0) jumpFrom(step);
    return std::int64_t(std::min(walkedSteps + 1, plan_.direct)) * kBlockLanes + std::int64_t(jumps) * lanesPerJump_;
}

std::vector<int> sampleWalkedSteps(const GBuffer& buffer, int steps, int count)
{
    const Extent& valid = buffer.valid();
    const double area = double(valid.width()) * double(valid.height());
    const int spacing = std::max(1, int(std::sqrt(area / count)));
    const int rows = (valid.height() + spacing - 1) / spacing;
    std::vector<std::vector<int>> perRow(static_cast<std::size_t>(rows));
    parallelFor(std::size_t(rows), [&](std::size_t row) {
        const int y = valid.y0 + int(row) * spacing;
        for (int x = valid.x0; x < valid.x1; x += spacing) {
            if (buffer.flow.at(x, y) == 0) continue;
            for (const float sign : {1.0f, -1.0f})
                perRow[row].push_back(walkedSteps(buffer, x, y, sign * buffer.flowUnitPx, steps));
        }
    });
    std::vector<int> all;
    for (const auto& row : perRow) all.insert(all.end(), row.begin(), row.end());
    return all;
}

}  // namespace aeolic::cpu
