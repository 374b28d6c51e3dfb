#include "render/cpu/lic/hierarchical.h"

#include <algorithm>

#include "base/parallel.h"

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
    level.units = jumpUnits(stride, buffer.flowUnitPx);
}

// The first row of a level that is looked up: by the next level, or from anywhere in the picture.
int firstLookedUp(const JumpPlan& plan, std::size_t level, const FreshRows& fresh, const Extent& valid)
{
    if (plan.digits[level] > 0) return valid.y0;
    return fresh.readFrom(plan.stride(level + 1), int(level) + 2, valid);
}

void prepareDirection(const HierarchicalPass& pass, const FreshRows& fresh, float sign, JumpHierarchy& jumps)
{
    const JumpPlan& plan = pass.memory.plan;
    const Extent& valid = pass.buffer.valid();
    const bool weighted = pass.kernel.weighted();
    jumps.sign = sign;
    if (jumps.levels.size() < plan.digits.size()) jumps.levels.resize(plan.digits.size());
    for (std::size_t i = 0; i < plan.digits.size(); ++i)
        prepareLevel(jumps.levels[i], plan.stride(i), pass.buffer, fresh, firstLookedUp(plan, i, fresh, valid),
                     weighted);
    if (plan.remainder > 0) prepareLevel(jumps.remainder, plan.remainder, pass.buffer, fresh, valid.y0, weighted);
    jumps.turns = turnsOf(pass.kernel, sign);
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
void receiveHighest(const HierarchicalPass& pass, const std::vector<JumpBoxes>& boxes, GuardExchange& guards)
{
    const JumpPlan& plan = pass.memory.plan;
    const std::size_t top = plan.digits.size() - 1;
    const std::vector<JumpFootprint> reached = guards.reached(boxes, plan.levelReach(top), plan.digits[top] - 1);
    std::vector<GuardPart> parts;
    for (std::size_t k = 0; k < pass.memory.directions.size(); ++k)
        parts.push_back({levelImages(pass.memory.directions[k].levels[top], pass.kernel.weighted()),
                         plan.levelReach(top), reached.empty() ? nullptr : &reached[k]});
    // Links are the same for both directions, and the nearest came with the level before.
    const JumpFootprint anyWay = reached.empty() ? JumpFootprint{} : unitedFootprint(reached);
    parts.push_back({{imageRows(pass.buffer.links)},
                     plan.levelReach(top),
                     reached.empty() ? nullptr : &anyWay,
                     plan.linkReach(top - 1)});
    guards.receive(parts);
}

void receiveLevel(const HierarchicalPass& pass, std::size_t i, GuardExchange& guards)
{
    const JumpPlan& plan = pass.memory.plan;
    const bool weighted = pass.kernel.weighted();
    std::vector<GuardPart> parts{{{imageRows(pass.buffer.links)}, plan.linkReach(i)}};
    for (JumpHierarchy& jumps : pass.memory.directions) {
        parts.push_back({levelImages(jumps.levels[i], weighted), plan.levelReach(i)});
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
    if (memory.plan.steps() != lic.steps) memory.plan = planJumps(lic.steps);
    const JumpPlan& plan = memory.plan;
    const KernelModel kernel = makeKernelModel(lic);
    const HierarchicalPass pass{
        buffer, near, memory, kernel, float(kernel.weight(0)), lic.streaks, makeContrastModel(lic), out};
    prepareDirection(pass, fresh, 1, memory.directions[0]);
    prepareDirection(pass, fresh, -1, memory.directions[1]);
    const auto tiles = [](const Extent& extent, const auto& body) {
        forEachTile(extent, kTileWidth, kTileHeight, body);
    };
    const auto rowsOf = [&](std::size_t level) {
        Extent rows = guards ? compute : buffer.valid();
        if (!guards) rows.y0 = fresh.changedFrom(plan.stride(level), int(level) + 1, rows);
        return rows;
    };
    tiles(rowsOf(0), [&](const Extent& tile) { walkDirectTile(pass, flow, tile); });
    if (guards) receiveLevel(pass, 0, *guards);
    for (std::size_t i = 0; i < plan.radix.size(); ++i) {
        std::vector<JumpBoxes> boxes;
        const bool highest = i + 1 == plan.radix.size();
        for (const JumpHierarchy& jumps : memory.directions)
            if (guards && highest) boxes.push_back(emptyBoxes(jumps.levels[i + 1], compute));
        tiles(rowsOf(i + 1), [&](const Extent& tile) {
            joinJumpsTile(pass, i, tile);
            for (std::size_t k = 0; k < boxes.size(); ++k)
                addBoxes(memory.directions[k].levels[i + 1], near, compute, tile, boxes[k]);
        });
        if (!guards) continue;
        if (highest)
            receiveHighest(pass, boxes, *guards);
        else
            receiveLevel(pass, i + 1, *guards);
    }
    tiles(compute, [&](const Extent& tile) { finishTile(pass, tile); });
}

}  // namespace aeolic::cpu
