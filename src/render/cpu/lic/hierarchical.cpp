#include "render/cpu/lic/hierarchical.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "render/cpu/lic/cpu_jump_boxes.h"

namespace aeolic::cpu {
namespace {

constexpr int kTileWidth = 1024, kTileHeight = 8;  // Long runs of memory, and enough tiles for many threads.
static_assert(kTileWidth % JumpBoxes::kColumns == 0 && kTileHeight % JumpBoxes::kRows == 0);

// Rows from `first` on are looked up.
void prepareLevel(JumpLevel& level, int stride, const GBuffer& buffer, const FreshRows& fresh, int first, bool weighted)
{
    fresh.prepare(level.jumps, buffer.valid(), first);
    if (weighted) fresh.prepare(level.weighted, buffer.valid(), first);
    level.stride = stride;
    const JumpUnits units = jumpUnits(stride, buffer.flowUnitPx);
    level.displacementUnitPx = units.displacementPx;
    level.sumUnit = units.sum;
    level.lengthUnitPx = units.lengthPx;
    level.weightedUnit = units.weighted;
}

// The first row of a level that is looked up: by the next level, or from anywhere in the picture.
int firstLookedUp(const JumpPlan& plan, std::size_t level, const FreshRows& fresh, const Extent& valid)
{
    if (plan.digits[level] > 0) return valid.y0;
    return fresh.readFrom(plan.stride(level + 1), int(level) + 2, valid);
}

void prepareDirection(const KernelModel& kernel, const JumpPlan& plan, const GBuffer& buffer, const FreshRows& fresh,
                      float sign, JumpHierarchy& jumps)
{
    const Extent& valid = buffer.valid();
    const bool weighted = kernel.weighted();
    jumps.sign = sign;
    while (jumps.levels.size() < plan.digits.size()) jumps.levels.push_back(std::make_unique<JumpLevel>());
    for (std::size_t i = 0; i < plan.digits.size(); ++i)
        prepareLevel(*jumps.levels[i], plan.stride(i), buffer, fresh, firstLookedUp(plan, i, fresh, valid), weighted);
    if (plan.remainder > 0) prepareLevel(jumps.remainder, plan.remainder, buffer, fresh, valid.y0, weighted);
    jumps.turns = turnsOf(kernel, sign);
}

// Images of a level of jumps in one direction.
std::vector<ImageRows> levelImages(JumpLevel& level, bool weighted)
{
    std::vector<ImageRows> images{imageRows(level.jumps)};
    if (weighted) images.push_back(imageRows(level.weighted));
    return images;
}

JumpFootprint unitedFootprint(const std::vector<JumpFootprint>& directions)
{
    JumpFootprint united = directions.front();
    for (const JumpFootprint& reached : directions)
        for (std::size_t i = 0; i < united.rows.size(); ++i) {
            united.rows[i].y0 = std::min(united.rows[i].y0, reached.rows[i].y0);
            united.rows[i].y1 = std::max(united.rows[i].y1, reached.rows[i].y1);
        }
    return united;
}

// The highest level is the one looked up furthest away, but where jumps lead is known by now, and little of all those
// rows is on the way.
void receiveHighest(GBuffer& buffer, const JumpPlan& plan, const std::vector<JumpBoxes>& boxes, bool weighted,
                    Hierarchy& memory, GuardExchange& guards)
{
    const std::size_t top = plan.digits.size() - 1;
    const std::vector<JumpFootprint> reached = guards.reached(boxes, plan.levelReach(top), plan.digits[top] - 1);
    std::vector<GuardPart> parts;
    for (std::size_t k = 0; k < memory.directions.size(); ++k)
        parts.push_back({levelImages(*memory.directions[k].levels[top], weighted), plan.levelReach(top),
                         reached.empty() ? nullptr : &reached[k]});
    // Links are the same for both directions, and the nearest came with the level before.
    const JumpFootprint anyWay = reached.empty() ? JumpFootprint{} : unitedFootprint(reached);
    parts.push_back({{imageRows(buffer.links)},
                     plan.levelReach(top),
                     reached.empty() ? nullptr : &anyWay,
                     plan.linkReach(top - 1)});
    guards.receive(parts);
}

void receiveLevel(GBuffer& buffer, const JumpPlan& plan, std::size_t i, bool weighted, Hierarchy& memory,
                  GuardExchange& guards)
{
    std::vector<GuardPart> parts{{{imageRows(buffer.links)}, plan.linkReach(i)}};
    for (JumpHierarchy& jumps : memory.directions) {
        parts.push_back({levelImages(*jumps.levels[i], weighted), plan.levelReach(i)});
        if (i == 0 && plan.remainder > 0)
            parts.push_back({levelImages(jumps.remainder, weighted), plan.remainderReach()});
    }
    guards.receive(parts);
}

}  // namespace

void convolveHierarchical(GBuffer& buffer, const FlowCells& flow, const NearFlow& near, const LicOptions& lic,
                          const Extent& compute, GuardExchange* guards, const FreshRows& fresh, Hierarchy& memory,
                          LicImage& out)
{
    if (memory.plannedSteps != lic.steps) {
        memory.plan = planJumps(lic.steps);
        memory.plannedSteps = lic.steps;
    }
    const JumpPlan& plan = memory.plan;
    const KernelModel kernel = makeKernelModel(lic);
    prepareDirection(kernel, plan, buffer, fresh, 1, memory.directions[0]);
    prepareDirection(kernel, plan, buffer, fresh, -1, memory.directions[1]);
    const HierarchicalPass pass{&memory,
                                &plan,
                                kernel.weighted(),
                                lic.streaks,
                                kernel.ofPlain,
                                kernel.ofFirst,
                                kernel.ofSecond,
                                float(kernel.weight(0)),
                                makeContrastModel(lic),
                                &near,
                                &out};
    const auto tiles = [](const Extent& extent, const auto& body) {
        forEachTile(extent, kTileWidth, kTileHeight, body);
    };
    const auto rowsOf = [&](std::size_t level) {
        Extent rows = guards ? compute : buffer.valid();
        if (!guards) rows.y0 = fresh.changedFrom(plan.stride(level), int(level) + 1, rows);
        return rows;
    };
    tiles(rowsOf(0), [&](const Extent& tile) { walkDirectTile(buffer, flow, pass, tile); });
    if (guards) receiveLevel(buffer, plan, 0, pass.weighted, memory, *guards);
    for (std::size_t i = 0; i < plan.radix.size(); ++i) {
        std::vector<JumpBoxes> boxes;
        const bool highest = i + 1 == plan.radix.size();
        for (const JumpHierarchy& jumps : memory.directions)
            if (guards && highest) boxes.push_back(emptyBoxes(*jumps.levels[i + 1], compute));
        tiles(rowsOf(i + 1), [&](const Extent& tile) {
            joinJumpsTile(buffer, pass, i, plan.radix[i], tile);
            for (std::size_t k = 0; k < boxes.size(); ++k)
                addBoxes(*memory.directions[k].levels[i + 1], near, compute, tile, boxes[k]);
        });
        if (!guards) continue;
        if (highest)
            receiveHighest(buffer, plan, boxes, pass.weighted, memory, *guards);
        else
            receiveLevel(buffer, plan, i + 1, pass.weighted, memory, *guards);
    }
    tiles(compute, [&](const Extent& tile) { finishTile(buffer, pass, tile); });
}

}  // namespace aeolic::cpu
