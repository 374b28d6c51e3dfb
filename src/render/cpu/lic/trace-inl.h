// Per-target include (Highway compiles it once per target): stepping along streamlines of the G-buffer's flow.

#if defined(AEOLIC_RENDER_CPU_TRACE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_TRACE_INL_H
#undef AEOLIC_RENDER_CPU_TRACE_INL_H
#else
#define AEOLIC_RENDER_CPU_TRACE_INL_H
#endif

#include <hwy/highway.h>

#include <type_traits>

#include "render/cpu/lic/fine_cells.h"
#include "render/cpu/lic/sheets-inl.h"
#include "render/cpu/simd/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Displacements per step, in flow units times 2^20, as cells give them; 0 where the trace has ended.
struct FlowVector {
    VF x, y;
};

struct FlowSample {
    FlowVector vector;
    VF noise;  ///< In bytes of the image it came from, 0 on average.
};

/// Pixels per unit of a FlowVector.
inline float vectorUnitPx(const GBuffer& buffer)
{
    return buffer.flowUnitPx * kFlowCellUnit;
}

// A cell's texels as numbers: see FlowCell and FineFlow.
HWY_INLINE VF cellX(VU texel)
{
    return hn::ConvertTo(DF(), hn::BitCast(DI(), texel));
}
template <class Cells>
HWY_INLINE VF cellY(VU texel)
{
    return hn::ConvertTo(DF(), hn::ShiftLeft<Cells::kYShift>(hn::BitCast(DI(), texel)));
}
HWY_INLINE VF cellNoise(VU texel)
{
    return hn::ConvertTo(DF(), hn::BitCast(DI(), hn::And(texel, hn::Set(DU(), 0xFFu))));
}

/// The flow around (dx, dy), on its way from memory.
template <class Cells>
struct LookupOf {
    VF dx, dy;
    Taps taps;
    Block4<VU> cell;
};
using FlowLookup = LookupOf<FlowCells>;
template <>
struct LookupOf<FineCells> : FlowLookup {
    VU upperNoise, lowerNoise;  // Two a word.
};

/// Asks for the flow at (dx, dy).
template <class Cells>
HWY_INLINE LookupOf<Cells> lookUpFlow(const Cells& flow, const LinkImage& links, VF dx, VF dy, const Traces& t)
{
    LookupOf<Cells> look;
    look.dx = dx;
    look.dy = dy;
    look.taps = findTaps(dx, dy);
    const VI at = links.index(t, look.taps);
    look.cell = loadBlocks<4>(DU(), links.base(flow.cells)->texel, at);
    if constexpr (std::is_same_v<Cells, FineCells>) {
        const auto* words = reinterpret_cast<const std::uint32_t*>(links.base(flow.noises));
        const Block4<VU> noise = loadBlocks<2>(DU(), words, at);
        look.upperNoise = noise.a;
        look.lowerNoise = noise.b;
    }
    weigh(look.taps);
    return look;
}

/// Moves the traces to where `look` is, along links; one that cannot get there ends, and stays put for good.
template <class Cells>
HWY_INLINE void moveTo(LookupOf<Cells>& look, const LinkImage& links, Traces& t)
{
    const DU du;
    VU& first = look.cell.a;
    const MU open = hn::TestBit(first, hn::Set(du, 1u));
    first = hn::And(first, hn::Set(du, ~1u));
    moveAlongLinks(links, look.dx, look.dy, open, float(limits::kOpenReachPx), hn::MaskFromVec(hn::Zero(DF())),
                   look.taps, t);
}

template <class Cells, class Field>
HWY_INLINE VF blendFlow(const LookupOf<Cells>& look, const Field& field)
{
    const Block4<VU>& cell = look.cell;
    return blendTaps(look.taps.weight, field(cell.a), field(cell.b), field(cell.c), field(cell.d));
}

/// Where the traces have moved to.
template <class Cells>
HWY_INLINE FlowVector vectorAt(const LookupOf<Cells>& look, const Traces& t)
{
    const VF x = blendFlow(look, [](VU v) AEOLIC_INLINE { return cellX(v); }),
             y = blendFlow(look, [](VU v) AEOLIC_INLINE { return cellY<Cells>(v); });
    return {hn::IfThenElseZero(t.alive, x), hn::IfThenElseZero(t.alive, y)};
}

/// In bytes, 0 on average.
HWY_INLINE VF noiseAt(const FlowLookup& look)
{
    return hn::Sub(blendFlow(look, [](VU v) AEOLIC_INLINE { return cellNoise(v); }),
                   hn::Set(DF(), float(flow_texel::kNoiseZero)));
}

HWY_INLINE VF noiseAt(const LookupOf<FineCells>& look)
{
    const DF d;
    const auto first = [](VU two) AEOLIC_INLINE {
        return hn::ConvertTo(DF(), hn::BitCast(DI(), hn::And(two, hn::Set(DU(), 0xFFFFu))));
    };
    const auto second = [](VU two)
                            AEOLIC_INLINE { return hn::ConvertTo(DF(), hn::BitCast(DI(), hn::ShiftRight<16>(two))); };
    const VF sum = blendTaps(look.taps.weight, first(look.upperNoise), second(look.upperNoise), first(look.lowerNoise),
                             second(look.lowerNoise));
    return hn::Mul(hn::Sub(sum, hn::Set(d, float(FineFlow::kNoiseZero))), hn::Set(d, 1.0f / FineFlow::kNoisePerByte));
}

/// The flow at (dx, dy), to which the traces move. Calls meanwhile() once the look-up is on its way: what another one
/// still has to count is best counted there.
template <class Cells, class Meanwhile>
HWY_INLINE LookupOf<Cells> visitFlow(const Cells& flow, const LinkImage& links, VF dx, VF dy, Traces& t,
                                     const Meanwhile& meanwhile)
{
    LookupOf<Cells> look = lookUpFlow(flow, links, dx, dy, t);
    meanwhile();
    moveTo(look, links, t);
    return look;
}

/// Where a streamline goes on from one sample to the next. It ends where the vector vanishes, and where it turns by
/// more than a right angle within a step: at a sink or source a trace would bounce to and fro and gather one pixel's
/// noise.
HWY_INLINE MF flowsOn(const FlowVector& from, const FlowVector& to)
{
    const VF vanishing = hn::Set(DF(), limits::kVanishing / (kFlowCellUnit * kFlowCellUnit));
    return hn::Gt(hn::MulAdd(from.x, to.x, hn::Mul(from.y, to.y)), vanishing);
}

/// The width of the stream tube around a trace (lic_kernel.h) after half a step, in widths before it, at most 1. Where
/// streamlines run the way of the vectors v, the step of n . J n / |v|^2 is what it widens by, J the vectors'
/// derivative and n normal to v. `unitPx`: of the vectors, negative for a trace upstream. Between pixels of several
/// sheets there is no derivative, and the width stays.
template <class Cells = FlowCells>
HWY_INLINE VF halfNarrowing(const Block4<VU>& cell, const Taps& taps, const FlowVector& v, float unitPx)
{
    const DF d;
    const auto changes = [&](auto field, VF& right, VF& down) AEOLIC_INLINE {
        const VF v00 = field(cell.a);
        const VF upper = hn::Sub(field(cell.b), v00), left = hn::Sub(field(cell.c), v00);
        const VF both = hn::Sub(hn::Sub(field(cell.d), field(cell.c)), upper);
        right = hn::MulAdd(taps.wy, both, upper);
        down = hn::MulAdd(taps.wx, both, left);
    };
    VF xRight, xDown, yRight, yDown;
    changes([](VU t) AEOLIC_INLINE { return cellX(t); }, xRight, xDown);
    changes([](VU t) AEOLIC_INLINE { return cellY<Cells>(t); }, yRight, yDown);
    const VF unit = hn::Set(d, unitPx), x = hn::Mul(v.x, unit), y = hn::Mul(v.y, unit);
    const VF across = hn::MulAdd(y, hn::NegMulAdd(x, xDown, hn::Mul(y, xRight)),
                                 hn::Mul(x, hn::NegMulAdd(y, yRight, hn::Mul(x, yDown))));
    // e^-b is about 1 / (1 + b + b^2 / 2) for b >= 0, half of what it narrows by: never negative, never above 1.
    const VF squared = hn::Max(hn::MulAdd(x, x, hn::Mul(y, y)), hn::Set(d, 1e-12f));
    VF half =
        hn::NegMulAdd(across, hn::Set(d, 0.5f * unitPx), hn::Mul(squared, hn::Set(d, -0.5f * limits::kSteadyWidth)));
    half = hn::Max(half, hn::Zero(d));
    if (HWY_UNLIKELY(taps.anyPartial)) half = hn::IfThenZeroElse(taps.partial, half);
    const VF fourth = hn::Mul(squared, squared);
    return hn::Div(fourth, hn::MulAdd(half, hn::MulAdd(hn::Set(d, 0.5f), half, squared), fourth));
}

/// The flow at the starting pixels themselves.
HWY_INLINE FlowSample flowAtPixel(const GBuffer& buffer, std::ptrdiff_t start)
{
    const DI di;
    const VI texel = hn::BitCast(di, hn::LoadU(DU(), buffer.flow.origin() + start));
    const VI field = hn::Set(di, std::int32_t(0xFFF00000u));
    return {
        {hn::ConvertTo(DF(), hn::And(texel, field)), hn::ConvertTo(DF(), hn::And(hn::ShiftLeft<12>(texel), field))},
        hn::Sub(hn::ConvertTo(DF(), hn::And(texel, hn::Set(di, 0xFF))), hn::Set(DF(), float(flow_texel::kNoiseZero)))};
}

HWY_INLINE FlowSample flowAtPixel(const GBuffer& buffer, const FlowCells&, std::ptrdiff_t start)
{
    return flowAtPixel(buffer, start);
}
HWY_INLINE FlowSample flowAtPixel(const GBuffer&, const FineCells& cells, std::ptrdiff_t start)
{
    const DF d;
    const VU texel = hn::LoadU(DU(), cells.flow->vectors.origin() + start);
    const hn::Rebind<std::uint16_t, DF> d16;
    const VI noise = hn::PromoteTo(DI(), hn::LoadU(d16, cells.flow->noise.origin() + start));
    return {{cellX(texel), cellY<FineCells>(texel)},
            hn::Mul(hn::ConvertTo(d, hn::Sub(noise, hn::Set(DI(), FineFlow::kNoiseZero))),
                    hn::Set(d, 1.0f / FineFlow::kNoisePerByte))};
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
