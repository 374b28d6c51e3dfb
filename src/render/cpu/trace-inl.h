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
    VF vx, vy;  ///< Displacement per step, in flow units; 0 where the trace has ended.
    VF noise;   ///< In bytes of the image it came from, 0 on average.
};

// A cell's texels as numbers: see FlowCell.
HWY_INLINE VF cellX(VU texel)
{
    return hn::ConvertTo(DF(), hn::BitCast(DI(), texel));
}
HWY_INLINE VF cellY(VU texel)
{
    return hn::ConvertTo(DF(), hn::ShiftLeft<12>(hn::BitCast(DI(), texel)));
}
HWY_INLINE VF cellNoise(VU texel)
{
    return hn::ConvertTo(DF(), hn::BitCast(DI(), hn::And(texel, hn::Set(DU(), 0xFFu))));
}

/// The flow at (dx, dy). Moves the traces there, along links; one that cannot get there ends, and stays put for good.
HWY_INLINE FlowSample sampleFlow(const FlowCells& flow, const LinkImage& links, VF dx, VF dy, Traces& t)
{
    const DF d;
    const DU du;
    Taps taps = findTaps(dx, dy);
    Block4<VU> cell = loadBlocks<4>(du, links.base(flow.cells)->texel, links.index(t, taps.x, taps.y));
    const MU open = hn::Ne(hn::And(cell.a, hn::Set(du, 1u)), hn::Zero(du));
    cell.a = hn::And(cell.a, hn::Set(du, ~1u));
    moveAlongLinks(links, dx, dy, open, float(FlowCells::kReach), hn::MaskFromVec(hn::Zero(d)), taps, t);
    const auto blend = [&](auto field) AEOLIC_INLINE {
        return blendTaps(taps, field(cell.a), field(cell.b), field(cell.c), field(cell.d));
    };
    const auto x = [](VU v) AEOLIC_INLINE { return cellX(v); };
    const auto y = [](VU v) AEOLIC_INLINE { return cellY(v); };
    const auto noise = [](VU v) AEOLIC_INLINE { return cellNoise(v); };
    FlowSample s{blend(x), blend(y), blend(noise)};
    if (HWY_UNLIKELY(taps.anyPartial)) {
        const auto repair = [&](VF& value, auto field) AEOLIC_INLINE {
            value = hn::IfThenElse(
                taps.partial, blendPartial(taps, field(cell.a), field(cell.b), field(cell.c), field(cell.d)), value);
        };
        repair(s.vx, x);
        repair(s.vy, y);
        repair(s.noise, noise);
    }
    const VF unit = hn::IfThenElseZero(t.alive, hn::Set(d, kFlowCellUnit));
    return {hn::Mul(s.vx, unit), hn::Mul(s.vy, unit), hn::Sub(s.noise, hn::Set(d, float(flow_texel::kNoiseZero)))};
}

/// Where a streamline goes on from one sample to the next. It ends where the vector vanishes, and where it turns by
/// more than a right angle within a step: at a sink or source a trace would bounce to and fro and gather one pixel's
/// noise.
HWY_INLINE MF flowsOn(const FlowSample& from, const FlowSample& to)
{
    const VF vanishing = hn::Set(DF(), 2.0f);  // Squared flow units: below that a vector is only its rounding.
    return hn::Gt(hn::MulAdd(from.vx, to.vx, hn::Mul(from.vy, to.vy)), vanishing);
}

/// The flow at the starting pixels themselves.
HWY_INLINE FlowSample flowAtPixel(const GBuffer& buffer, std::ptrdiff_t start)
{
    const DI di;
    const VI texel = hn::BitCast(di, hn::LoadU(DU(), buffer.flow.origin() + start));
    return {
        hn::ConvertTo(DF(), hn::ShiftRight<20>(texel)),
        hn::ConvertTo(DF(), hn::ShiftRight<20>(hn::ShiftLeft<12>(texel))),
        hn::Sub(hn::ConvertTo(DF(), hn::And(texel, hn::Set(di, 0xFF))), hn::Set(DF(), float(flow_texel::kNoiseZero)))};
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
