#include <algorithm>
#include <vector>

#include "render/gl/device/dispatch.h"
#include "render/gl/device/gl_blocks.h"
#include "render/gl/lic/gl_lic_stage.h"
#include "render/gl/lic/guard_rows.h"
#include "render/lic/lic_kernel.h"

namespace aeolic::gl {
namespace {

JumpBlock makeJumpBlock(const JumpPlan& plan, float flowUnitPx)
{
    JumpBlock block{};
    const auto set = [&](std::size_t i, int stride, int count) {
        const JumpUnits units = jumpUnits(stride, flowUnitPx);
        block.units[i] = {units.displacementPx, units.sum, units.lengthPx, units.weighted};
        block.perUnit[i] = {1 / units.displacementPx, 1 / units.sum, 1 / units.lengthPx, 1 / units.weighted};
        block.counts[i][0] = stride;
        block.counts[i][1] = count;
    };
    const std::size_t levels = plan.digits.size();
    for (std::size_t i = 0; i < levels; ++i) set(i, plan.stride(i), plan.digits[i]);
    if (plan.remainder > 0) set(levels, plan.remainder, 1);
    block.levels = std::int32_t(levels);
    block.directSteps = plan.direct;
    block.remainderSteps = plan.remainder;
    return block;
}

/// Both directions of a level of jumps.
std::vector<GuardRowExchange::Plane> planesOf(const FrameImages& images, int level, bool withWeighted)
{
    std::vector<GuardRowExchange::Plane> planes;
    for (int layer = 2 * level; layer < 2 * level + 2; ++layer) {
        planes.push_back({&images.places, layer});
        planes.push_back({&images.metas, layer});
        if (withWeighted) planes.push_back({&images.weighted, layer});
    }
    return planes;
}

}  // namespace

void HierarchicalConvolution::prepare(const ConvolvePass& pass, const LicOptions& lic)
{
    if (plannedSteps_ != lic.steps) {
        plan_ = planJumps(lic.steps);
        plannedSteps_ = lic.steps;
    }
    const KernelModel kernel = makeKernelModel(lic);
    pass.images.resizeJumps(int(plan_.digits.size()) + (plan_.remainder > 0), kernel.weighted());
    const JumpBlock block = makeJumpBlock(plan_, pass.flowUnitPx);
    if (block_.bytes() == 0) block_ = Buffer(sizeof block, GL_DYNAMIC_STORAGE_BIT);
    block_.write(0, sizeof block, &block);
    bindUniforms(kJumpBinding, block_);
    if (!kernel.weighted()) return;
    const std::vector<Turn> down = turnsOf(kernel, 1), up = turnsOf(kernel, -1);
    std::vector<Turn> turns;  // Both of each number of steps.
    for (std::size_t i = 0; i < down.size(); ++i) turns.insert(turns.end(), {down[i], up[i]});
    const std::size_t bytes = turns.size() * sizeof turns[0];
    turns_.reserve(bytes).write(0, bytes, turns.data());
    bindStorage(0, turns_.get());
}

void HierarchicalConvolution::run(const ConvolvePass& pass, const LicOptions& lic, int y0, int y1,
                                  GuardRowExchange* guards)
{
    prepare(pass, lic);
    const FrameImages& images = pass.images;
    const KernelModel kernel = makeKernelModel(lic);
    const bool weighted = kernel.weighted();
    const std::vector<Define> defines{{"WEIGHTED", weighted}};
    const auto compute = [&](GLuint program, int levelY0, int levelY1) {
        bindTraces(pass, program);
        images.places.bind(4);
        images.metas.bind(5);
        images.places.bindImage(0);
        images.metas.bindImage(1);
        if (weighted) images.weighted.bind(6), images.weighted.bindImage(2);
        bindUniforms(kJumpBinding, block_);
        if (weighted) bindStorage(0, turns_.get());
        pass.near.run(program, levelY0, levelY1, 2);
    };
    // A level, or what one program makes of several. What others read of it is computed first, and travels while the
    // rest is.
    const auto level = [&](GLuint program) {
        if (!guards) return compute(program, 0, images.valid.height());
        const GuardRows sent = guards->sent();
        const int upperEnd = std::min(y0 + sent.above, y1), lowerBegin = std::max(y1 - sent.below, upperEnd);
        compute(program, y0, upperEnd);
        compute(program, lowerBegin, y1);
        guards->send();
        compute(program, upperEnd, lowerBegin);
        guards->receive();
    };
    const auto exchanged = [&](std::size_t i, int reach) {
        if (guards) guards->add(planesOf(images, int(i), weighted), reach);
    };
    const std::size_t levels = plan_.digits.size();
    const GLuint walk = pass.programs.compute("hierarchical_walk", defines);
    setFloats(walk, 3, kSharpenedNoiseUnit);
    setInts(walk, 4, lic.streaks == Streaks::even);
    exchanged(0, plan_.levelReach(0));
    if (plan_.remainder > 0) exchanged(levels, plan_.remainderReach());
    level(walk);
    for (std::size_t i = 0; i < plan_.radix.size(); ++i) {
        const GLuint join = pass.programs.compute("hierarchical_join", defines);
        setInts(join, 3, int(i), plan_.radix[i]);
        exchanged(i + 1, plan_.levelReach(i + 1));
        level(join);
    }
    const GLuint finish = pass.programs.compute("hierarchical_finish", defines);
    setContrast(finish, lic);
    setFloats(finish, 3, kernel.ofPlain, kernel.ofFirst, kernel.ofSecond, float(kernel.weight(0)));
    bindTraces(pass, finish);
    images.places.bind(4);
    images.metas.bind(5);
    if (weighted) images.weighted.bind(6);
    bindUniforms(kJumpBinding, block_);
    if (weighted) bindStorage(0, turns_.get());
    images.lic.bindImage(0);
    pass.near.run(finish, y0, y1);
}

}  // namespace aeolic::gl
