#include <cmath>

#include "base/parallel.h"
#include "render/cpu/hierarchical_pass.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/convolve_hierarchical.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/contrast-inl.h"
#include "render/cpu/jumps-inl.h"
#include "render/cpu/trace-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE std::ptrdiff_t indexOf(const GBuffer& buffer, int x, int y)
{
    return (y - buffer.valid().y0) * buffer.flow.stride() + (x - buffer.valid().x0);
}

HWY_INLINE bool anyFlow(const GBuffer& buffer, std::ptrdiff_t at)
{
    return !hn::AllTrue(DU(), hn::Eq(hn::LoadU(DU(), buffer.flow.origin() + at), hn::Zero(DU())));
}

HWY_INLINE VU linkMaskAt(const GBuffer& buffer, std::ptrdiff_t at)
{
    const hn::Rebind<std::uint8_t, DU> d8;
    return hn::PromoteTo(DU(), hn::LoadU(d8, buffer.links.origin() + at));
}

// Walks the first steps one by one. Second-order steps two pixels long whose middles serve as samples too: every look-up is
// both a Runge-Kutta stage and a noise sample, half the cost of unit RK2 steps at nearly their accuracy.
template <bool kHann>
void walkDirect(const GBuffer& buffer, const FlowCells& flow, const HierarchicalPass& pass, const Extent& tile)
{
    const DF d;
    const LinkImage links(buffer);
    const VF unit = hn::Set(d, pass.direction * buffer.flowUnitPx), two = hn::Set(d, 2.0f);
    JumpLevel& level = pass.level(0);
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; x += int(hn::Lanes(d))) {
            const std::ptrdiff_t at = indexOf(buffer, x, y);
            if (!anyFlow(buffer, at)) {
                storeNoJump(level, at);
                if (pass.remainder) storeNoJump(*pass.remainder, at);
                continue;
            }
            Traces t = startTraces(buffer, at);
            Walk walk = noWalk();
            FlowSample here = flowAtPixel(buffer, at);
            t.alive = hn::And(t.alive, flowsOn(here, here));
            const VU mask = linkMaskAt(buffer, at);
            const auto count = [&](const FlowSample& s, VF length, int step) {
                const VF ds = hn::IfThenElseZero(t.alive, length), noise = hn::Mul(ds, s.noise);
                walk.sum = hn::Add(walk.sum, noise);
                walk.lengthPx = hn::Add(walk.lengthPx, ds);
                if constexpr (kHann) {
                    walk.cosSum = hn::MulAdd(noise, hn::Set(d, pass.rotation(step).cosine), walk.cosSum);
                    walk.sinSum = hn::MulAdd(noise, hn::Set(d, pass.rotation(step).sine), walk.sinSum);
                }
                if (pass.remainder && step == pass.remainder->stride) storeJump<kHann>(*pass.remainder, at, t, walk, mask);
            };
            for (int i = 0; i < level.stride; i += 2) {
                const VF x0 = t.dx, y0 = t.dy;
                const FlowSample middle = sampleFlow(flow, links, hn::MulAdd(here.vx, unit, x0), hn::MulAdd(here.vy, unit, y0), t);
                const VF length = stepLength(middle.vx, middle.vy, hn::Abs(unit));  // Of either half of the double step.
                count(middle, length, i + 1);
                t.alive = hn::And(t.alive, flowsOn(here, middle));
                if (i + 1 == level.stride) break;
                const VF twice = hn::Mul(unit, two);
                here = sampleFlow(flow, links, hn::MulAdd(middle.vx, twice, x0), hn::MulAdd(middle.vy, twice, y0), t);
                count(here, length, i + 2);
                t.alive = hn::And(t.alive, flowsOn(middle, here));
            }
            storeJump<kHann>(level, at, t, walk, mask);
        }
}

// Joins `radix` jumps of one level to one of the next.
template <bool kHann>
void joinJumps(const GBuffer& buffer, const HierarchicalPass& pass, std::size_t from, int radix, const Extent& tile)
{
    const DF d;
    const LinkImage links(buffer);
    const JumpLevel& lower = pass.level(from);
    JumpLevel& upper = pass.level(from + 1);
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; x += int(hn::Lanes(d))) {
            const std::ptrdiff_t at = indexOf(buffer, x, y);
            if (!anyFlow(buffer, at)) {
                storeNoJump(upper, at);
                continue;
            }
            Traces t = startTraces(buffer, at);
            Walk walk = noWalk();
            firstJump<kHann>(lower, at, t, walk);
            for (int j = 1; j < radix && !hn::AllFalse(d, t.alive); ++j) nextJump<kHann>(lower, links, pass.rotation(j * lower.stride), t, walk);
            storeJump<kHann>(upper, at, t, walk, linkMaskAt(buffer, at));
        }
}

// The kernel's full length from the highest level down.
template <bool kHann>
HWY_INLINE Walk walkAll(const GBuffer& buffer, const LinkImage& links, const HierarchicalPass& pass, std::ptrdiff_t at)
{
    const DF d;
    Traces t = startTraces(buffer, at);
    Walk walk = noWalk();
    bool first = true;
    int walked = 0;
    const auto jump = [&](const JumpLevel& level) {
        if (first) firstJump<kHann>(level, at, t, walk);
        else if (!hn::AllFalse(d, t.alive)) nextJump<kHann>(level, links, pass.rotation(walked), t, walk);
        first = false;
        walked += level.stride;
    };
    for (std::size_t level = pass.plan->digits.size(); level-- > 0;)
        for (int k = 0; k < pass.plan->digits[level]; ++k) jump(pass.level(level));
    if (pass.remainder) jump(*pass.remainder);
    return walk;
}

// Both directions' sums to the pixel's LIC value.
template <bool kHann>
void finishTile(const GBuffer& buffer, const HierarchicalPass& pass, const Extent& tile)
{
    const DF d;
    const DU du;
    const LinkImage links(buffer);
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; x += int(hn::Lanes(d))) {
            const std::ptrdiff_t at = indexOf(buffer, x, y);
            float* out = pass.out->row(y) + x;
            if (!anyFlow(buffer, at)) {
                hn::StoreU(hn::Zero(d), d, out);
                continue;
            }
            const Walk walk = walkAll<kHann>(buffer, links, pass, at);
            const FlowSample origin = flowAtPixel(buffer, at);
            VF sum = walk.sum, length = walk.lengthPx;
            if constexpr (kHann) {
                // (1 + cos(omega i - phase)) / 2 from the plain sum and the two waves.
                const VF wave = hn::MulAdd(hn::Set(d, pass.phaseCosine), walk.cosSum, hn::Mul(hn::Set(d, pass.phaseSine), walk.sinSum));
                sum = hn::Mul(hn::Set(d, 0.5f), hn::Add(walk.sum, wave));
            }
            if (pass.direction > 0) {  // Downstream comes first: the pixel's own sample, and a place to wait.
                const VF own = ownLength(origin, buffer.flowUnitPx);
                hn::StoreU(hn::MulAdd(hn::Mul(own, hn::Set(d, pass.ownWeight)), origin.noise, sum), d, out);
                hn::StoreU(hn::Add(length, own), d, pass.memory->lengths.row(y) + x);
                continue;
            }
            sum = hn::Add(sum, hn::LoadU(d, out));
            length = hn::Add(length, hn::LoadU(d, pass.memory->lengths.row(y) + x));
            const auto active = hn::RebindMask(d, hn::Ne(hn::LoadU(du, buffer.flow.origin() + at), hn::Zero(du)));
            hn::StoreU(hn::IfThenElseZero(active, licValue(sum, length, pass.contrast)), d, out);
        }
}

void walkDirectTile(const GBuffer& buffer, const FlowCells& flow, const HierarchicalPass& pass, const Extent& tile)
{
    pass.hann ? walkDirect<true>(buffer, flow, pass, tile) : walkDirect<false>(buffer, flow, pass, tile);
}
void joinJumpsTile(const GBuffer& buffer, const HierarchicalPass& pass, std::size_t from, int radix, const Extent& tile)
{
    pass.hann ? joinJumps<true>(buffer, pass, from, radix, tile) : joinJumps<false>(buffer, pass, from, radix, tile);
}
void finishTileAny(const GBuffer& buffer, const HierarchicalPass& pass, const Extent& tile)
{
    pass.hann ? finishTile<true>(buffer, pass, tile) : finishTile<false>(buffer, pass, tile);
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(walkDirectTile);
HWY_EXPORT(joinJumpsTile);
HWY_EXPORT(finishTileAny);

namespace {

constexpr int kTileWidth = 128, kTileHeight = 16;

void prepareLevel(JumpLevel& level, int stride, const GBuffer& buffer, bool hann)
{
    level.jumps.resize(buffer.valid());
    if (hann) level.waves.resize(buffer.valid());
    level.stride = stride;
    // flowUnitPx is the longest step over 2048: a jump of `stride` of them just fits 16 bits, and so do the others.
    level.displacementUnitPx = buffer.flowUnitPx * float(stride) / 16.0f;
    const float longestPx = buffer.flowUnitPx * 2048.0f * float(stride);
    level.sumUnit = longestPx / 256.0f;
    level.lengthUnitPx = longestPx / 16383.0f;
}

// The Hann kernel's waves in one direction.
void prepareRotations(const LicOptions& lic, int direction, Hierarchy& memory)
{
    memory.rotations.resize(std::size_t(lic.steps) + 1);
    for (int i = 0; i <= lic.steps; ++i) {
        const double angle = hannFrequency(lic) * i;
        memory.rotations[std::size_t(i)] = {float(std::cos(angle)), float(direction * std::sin(angle))};
    }
}

}  // namespace

void convolveHierarchical(const GBuffer& buffer, const FlowCells& flow, const LicOptions& lic, const Extent& compute, Hierarchy& memory,
                          LicImage& out)
{
    const JumpPlan plan = planJumps(lic.steps);
    const bool hann = lic.kernel == Kernel::hann;
    while (memory.levels.size() < plan.digits.size()) memory.levels.push_back(std::make_unique<JumpLevel>());
    for (std::size_t i = 0; i < plan.digits.size(); ++i) prepareLevel(*memory.levels[i], plan.stride(i), buffer, hann);
    if (plan.remainder) prepareLevel(memory.remainder, plan.remainder, buffer, hann);
    memory.lengths.resize(compute);

    for (const int direction : {1, -1}) {
        prepareRotations(lic, direction, memory);
        const HierarchicalPass pass{&memory, &plan, plan.remainder ? &memory.remainder : nullptr, float(direction), hann,
                                    float(std::cos(lic.phaseRad)), float(std::sin(lic.phaseRad)), makeKernelWeights(lic).forward[0],
                                    makeContrastModel(lic), &out};
        forEachTile(buffer.valid(), kTileWidth, kTileHeight,
                    [&](const Extent& tile) { HWY_DYNAMIC_DISPATCH(walkDirectTile)(buffer, flow, pass, tile); });
        for (std::size_t i = 0; i < plan.radix.size(); ++i)
            forEachTile(buffer.valid(), kTileWidth, kTileHeight,
                        [&](const Extent& tile) { HWY_DYNAMIC_DISPATCH(joinJumpsTile)(buffer, pass, i, plan.radix[i], tile); });
        forEachTile(compute, kTileWidth, kTileHeight, [&](const Extent& tile) { HWY_DYNAMIC_DISPATCH(finishTileAny)(buffer, pass, tile); });
    }
}

}  // namespace aeolic::cpu
#endif
