#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "render/cpu/hierarchical_pass.h"

namespace aeolic::cpu {
namespace {

constexpr int kTileWidth = 1024, kTileHeight = 8;  // Long runs of memory, and enough tiles for many threads.

void prepareLevel(JumpLevel& level, int stride, const GBuffer& buffer, bool hann)
{
    level.jumps.resize(buffer.valid());
    if (hann) level.waves.resize(buffer.valid());
    level.stride = stride;
    const JumpUnits units = jumpUnits(stride, buffer.flowUnitPx);
    level.displacementUnitPx = units.displacementPx;
    level.sumUnit = units.sum;
    level.lengthUnitPx = units.lengthPx;
}

void prepareDirection(const LicOptions& lic, const JumpPlan& plan, const GBuffer& buffer, float sign,
                      JumpHierarchy& jumps)
{
    const bool hann = lic.kernel == Kernel::hann;
    jumps.sign = sign;
    while (jumps.levels.size() < plan.digits.size()) jumps.levels.push_back(std::make_unique<JumpLevel>());
    for (std::size_t i = 0; i < plan.digits.size(); ++i) prepareLevel(*jumps.levels[i], plan.stride(i), buffer, hann);
    if (plan.remainder > 0) prepareLevel(jumps.remainder, plan.remainder, buffer, hann);
    jumps.rotations.clear();
    for (int i = 0; hann && i <= lic.steps; ++i) {
        const double angle = hannFrequency(lic) * i;
        jumps.rotations.push_back({float(std::cos(angle)), sign * float(std::sin(angle))});
    }
}

// A level's images in both directions.
template <class LevelOf>
std::vector<ImageRows> levelImages(Hierarchy& memory, const LevelOf& levelOf, bool hann)
{
    std::vector<ImageRows> images;
    for (JumpHierarchy& jumps : memory.directions) {
        JumpLevel& level = levelOf(jumps);
        images.push_back(imageRows(level.jumps));
        if (hann) images.push_back(imageRows(level.waves));
    }
    return images;
}

}  // namespace

void convolveHierarchical(GBuffer& buffer, const FlowCells& flow, const NearFlow& near, const LicOptions& lic,
                          const Extent& compute, GuardExchange* guards, Hierarchy& memory, LicImage& out)
{
    if (memory.plannedSteps != lic.steps) {
        memory.plan = planJumps(lic.steps);
        memory.plannedSteps = lic.steps;
    }
    const JumpPlan& plan = memory.plan;
    prepareDirection(lic, plan, buffer, 1, memory.directions[0]);
    prepareDirection(lic, plan, buffer, -1, memory.directions[1]);
    const HierarchicalPass pass{&memory,
                                &plan,
                                lic.kernel == Kernel::hann,
                                float(std::cos(lic.phaseRad)),
                                float(std::sin(lic.phaseRad)),
                                makeKernelWeights(lic).forward[0],
                                makeContrastModel(lic),
                                &near,
                                &out};
    const auto tiles = [](const Extent& extent, const auto& body) {
        forEachTile(extent, kTileWidth, kTileHeight, body);
    };
    const Extent& levelRows = guards ? compute : buffer.valid();
    const auto partOf = [&](auto levelOf, const TraceReach& reach) {
        return GuardPart{levelImages(memory, levelOf, pass.hann), reach};
    };
    const auto receiveLevel = [&](std::size_t i) {
        if (!guards) return;
        std::vector<GuardPart> parts{{{imageRows(buffer.links)}, plan.linkReach(i)}};
        parts.push_back(
            partOf([i](JumpHierarchy& jumps) -> JumpLevel& { return *jumps.levels[i]; }, plan.levelReach(i)));
        if (i == 0 && plan.remainder > 0)
            parts.push_back(
                partOf([](JumpHierarchy& jumps) -> JumpLevel& { return jumps.remainder; }, plan.remainderReach()));
        guards->receive(parts);
    };
    tiles(levelRows, [&](const Extent& tile) { walkDirectTile(buffer, flow, pass, tile); });
    receiveLevel(0);
    for (std::size_t i = 0; i < plan.radix.size(); ++i) {
        tiles(levelRows, [&](const Extent& tile) { joinJumpsTile(buffer, pass, i, plan.radix[i], tile); });
        receiveLevel(i + 1);
    }
    tiles(compute, [&](const Extent& tile) { finishTile(buffer, pass, tile); });
}

}  // namespace aeolic::cpu
