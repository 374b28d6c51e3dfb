// Per-target include (Highway compiles it once per target): stepping along streamlines of the G-buffer's flow.

#if defined(AEOLIC_RENDER_CPU_TRACE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_TRACE_INL_H
#undef AEOLIC_RENDER_CPU_TRACE_INL_H
#else
#define AEOLIC_RENDER_CPU_TRACE_INL_H
#endif

#include <hwy/highway.h>

#include "render/cpu/flow_cells.h"
#include "render/cpu/links-inl.h"
#include "render/cpu/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct FlowSample {
    VF vx, vy;  ///< Displacement per step, in flow units.
    VF noise;   ///< -127 … 127.
};

HWY_INLINE VF flowX(VU texel) { return hn::ConvertTo(DF(), hn::ShiftRight<20>(hn::BitCast(DI(), texel))); }
HWY_INLINE VF flowY(VU texel) { return hn::ConvertTo(DF(), hn::ShiftRight<20>(hn::BitCast(DI(), hn::ShiftLeft<12>(texel)))); }
/// Bit 0 is the link flag: what is left is centred half a level lower.
HWY_INLINE VF flowNoise(VU texel)
{
    const VF level = hn::ConvertTo(DF(), hn::BitCast(DI(), hn::And(texel, hn::Set(DU(), 0xFEu))));
    return hn::Sub(level, hn::Set(DF(), float(flow_texel::kNoiseZero) - 0.5f));
}

/// The flow at (dx, dy) from the traces' pixels. Moves the traces there, along links; positions of traces that die stay.
HWY_INLINE FlowSample sampleFlow(const FlowCells& flow, const LinkImage& links, VF dx, VF dy, Traces& t)
{
    const DU du;
    Taps taps = findTaps(dx, dy);
    const VI at = links.clampIndex(links.index(t, taps.x, taps.y));
    const Block4<VU> cell = loadBlocks<4>(du, reinterpret_cast<const std::uint32_t*>(flow.cells.row(links.firstRow)), at);
    const VU nearest = taps.pick(cell.a, cell.b, cell.c, cell.d);
    moveAlongLinks(links, dx, dy, hn::Ne(hn::And(nearest, hn::Set(du, 1u)), hn::Zero(du)), taps, t);
    const auto blend = [&](auto field) { return blendTaps(taps, field(cell.a), field(cell.b), field(cell.c), field(cell.d)); };
    const auto x = [](VU v) { return flowX(v); };
    const auto y = [](VU v) { return flowY(v); };
    const auto noise = [](VU v) { return flowNoise(v); };
    FlowSample s{blend(x), blend(y), blend(noise)};
    if (HWY_UNLIKELY(taps.anyPartial)) {
        const auto repair = [&](VF& value, auto field) {
            value = hn::IfThenElse(taps.partial, blendPartial(taps, field(cell.a), field(cell.b), field(cell.c), field(cell.d)), value);
        };
        repair(s.vx, x);
        repair(s.vy, y);
        repair(s.noise, noise);
    }
    return s;
}

/// Where a streamline goes on from one sample to the next. It ends where the vector vanishes, and where it turns by more than
/// a right angle within a step: at a sink or source a trace would bounce to and fro and gather one pixel's noise.
HWY_INLINE MF flowsOn(const FlowSample& from, const FlowSample& to)
{
    const VF vanishing = hn::Set(DF(), 2.0f);  // Squared flow units: below that a vector is only its rounding.
    return hn::Gt(hn::MulAdd(from.vx, to.vx, hn::Mul(from.vy, to.vy)), vanishing);
}

/// The flow at the starting pixels themselves.
HWY_INLINE FlowSample flowAtPixel(const GBuffer& buffer, std::ptrdiff_t start)
{
    const VU texel = hn::LoadU(DU(), buffer.flow.origin() + start);
    const VF level = hn::ConvertTo(DF(), hn::BitCast(DI(), hn::And(texel, hn::Set(DU(), 0xFFu))));
    return {flowX(texel), flowY(texel), hn::Sub(level, hn::Set(DF(), float(flow_texel::kNoiseZero)))};
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
