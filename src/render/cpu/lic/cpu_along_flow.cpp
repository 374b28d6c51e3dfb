#include "render/cpu/lic/cpu_along_flow.h"

#include <algorithm>

#include "base/parallel.h"
#include "render/cpu/lic/fine_cells.h"
#include "render/lic/along_flow.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/lic/cpu_along_flow.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/simd/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The bit of the link to the neighbour (x, y), each -1 to 1 (linkBit).
HWY_INLINE VI linkBitTo(VI x, VI y)
{
    const DI di;
    const VI one = hn::Set(di, 1);
    const VI k = hn::Add(hn::Add(hn::Add(y, y), hn::Add(y, x)), hn::Set(di, 4));
    return hn::Sub(k, hn::IfThenElseZero(hn::Gt(k, hn::Set(di, 4)), one));
}

// Where a pixel's taps lie on one side of it, counted in words of the image, and over which links. Those of the other
// side are opposite.
struct Taps {
    VI offset[limits::kAlongRows], bit[limits::kAlongRows];
};

HWY_INLINE Taps tapsAlong(VI dx, VI dy, int stride)
{
    const DI di;
    const VI zero = hn::Zero(di), one = hn::Set(di, 1), row = hn::Set(di, stride);
    const VI alongX = hn::Abs(dx), alongY = hn::Abs(dy);
    const VI sx = hn::IfThenElse(hn::Lt(dx, zero), hn::Set(di, -1), one),
             sy = hn::IfThenElse(hn::Lt(dy, zero), hn::Set(di, -1), one);
    const auto wide = hn::Not(hn::Lt(alongX, alongY));
    const VI longer = hn::Max(alongX, alongY), shorter = hn::Min(alongX, alongY);
    const VI down = hn::Mul(sy, row);
    const VI straight = hn::IfThenElse(wide, sx, down), aside = hn::IfThenElse(wide, down, sx);
    const VI straightBit = linkBitTo(hn::IfThenElseZero(wide, sx), hn::IfThenZeroElse(wide, sy));
    const VI diagonalBit = linkBitTo(sx, sy);
    Taps taps;
    VI asideBefore = zero, at = zero;
    for (int k = 1; k <= limits::kAlongRows; ++k) {
        // k * shorter / longer, rounded: so many pixels aside.
        const VI slope = hn::Mul(hn::Set(di, 2 * k), shorter);
        VI pixelsAside = zero, bound = longer;
        for (int n = 1; n <= k; ++n) {
            pixelsAside = hn::Add(pixelsAside, hn::IfThenElseZero(hn::Not(hn::Lt(slope, bound)), one));
            bound = hn::Add(bound, hn::Add(longer, longer));
        }
        const auto turns = hn::Gt(pixelsAside, asideBefore);
        asideBefore = pixelsAside;
        at = hn::Add(at, hn::Add(straight, hn::IfThenElseZero(turns, aside)));
        taps.offset[k - 1] = at;
        taps.bit[k - 1] = hn::IfThenElse(turns, diagonalBit, straightBit);
    }
    return taps;
}

void packRow(const float* values, const std::uint8_t* links, int x0, int x1, std::uint32_t* words)
{
    const DF d;
    const DU du;
    const hn::Rebind<std::uint8_t, DU> d8;
    for (int x = x0; x < x1; x += int(hn::Lanes(d))) {
        const VU value = hn::BitCast(du, hn::LoadU(d, values + x));
        const VU word = hn::Or(hn::AndNot(hn::Set(du, 0xFFu), value), hn::PromoteTo(du, hn::LoadU(d8, links + x)));
        storeUpTo(x1, word, x, du, words);
    }
}

// `vanishing`: limits::kVanishing in the squared units of `flow`.
template <class Cells>
void smoothRowOf(const std::uint32_t* flow, int vanishing, const Image<std::uint32_t>& image, float gain, int y, int x0,
                 int x1, float* out)
{
    const DF d;
    const DI di;
    const DU du;
    const int lanes = int(hn::Lanes(d));
    const std::uint32_t* words = image.row(y);
    const VF one = hn::Set(d, 1.0f);
    float most = along_flow::kWeights[0];
    for (int k = 1; k <= limits::kAlongRows; ++k) most += 2 * along_flow::kWeights[k];
    const VF perWeight = hn::Set(d, (gain - 1) / (most - along_flow::kWeights[0]));
    for (int x = x0; x < x1; x += lanes) {
        const VU texel = hn::LoadU(du, flow + x);
        if (hn::AllTrue(du, hn::Eq(texel, hn::Zero(du)))) {
            std::fill_n(out + x, std::min(lanes, x1 - x), 0.0f);
            continue;
        }
        constexpr int kXShift = 32 - Cells::kYShift;
        const VI dx = hn::ShiftRight<kXShift>(hn::BitCast(di, texel)),
                 dy = hn::ShiftRight<kXShift>(hn::BitCast(di, hn::ShiftLeft<Cells::kYShift>(texel)));
        const VI squared = hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy));
        const auto flows = hn::Gt(squared, hn::Set(di, vanishing));
        const Taps taps = tapsAlong(dx, dy, int(image.stride()));
        const VU own = hn::LoadU(du, words + x);
        const auto valueOf = [&](VU word)
                                 AEOLIC_INLINE { return hn::BitCast(d, hn::AndNot(hn::Set(du, 0xFFu), word)); };
        VF sum = hn::Mul(valueOf(own), hn::Set(d, along_flow::kWeights[0])), weight = hn::Zero(d);
        for (int side = 0; side < 2; ++side) {
            VU links = own;
            VU there = hn::IfThenElseZero(hn::RebindMask(du, flows), hn::Set(du, 1));
            for (int k = 0; k < limits::kAlongRows; ++k) {
                const VI offset = side == 0 ? taps.offset[k] : hn::Neg(taps.offset[k]);
                const VI bit = side == 0 ? taps.bit[k] : hn::Sub(hn::Set(di, 7), taps.bit[k]);
                there = hn::And(there, hn::Shr(links, hn::BitCast(du, bit)));
                links = hn::GatherIndex(du, words + x, hn::Add(hn::Iota(di, 0), offset));
                const auto counts = hn::RebindMask(d, hn::Ne(there, hn::Zero(du)));
                const VF share = hn::Set(d, along_flow::kWeights[k + 1]);
                sum = hn::MulAdd(share, hn::IfThenElseZero(counts, valueOf(links)), sum);
                weight = hn::Add(weight, hn::IfThenElseZero(counts, share));
            }
        }
        const VF raised = hn::MulAdd(weight, perWeight, one);
        const VF value = hn::Mul(hn::Div(sum, hn::Add(weight, hn::Set(d, along_flow::kWeights[0]))), raised);
        storeUpTo(x1, value, x, d, out);
    }
}

void smoothRow(const std::uint32_t* flow, bool isFine, const Image<std::uint32_t>& image, float gain, int y, int x0,
               int x1, float* out)
{
    constexpr float kSquared = float(FineFlow::kPerUnit) * float(FineFlow::kPerUnit);
    if (isFine)
        smoothRowOf<FineCells>(flow, int(limits::kVanishing * kSquared), image, gain, y, x0, x1, out);
    else
        smoothRowOf<FlowCells>(flow, int(limits::kVanishing), image, gain, y, x0, x1, out);
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(packRow);
HWY_EXPORT(smoothRow);

void packValues(const GBuffer& buffer, const LicImage& values, const Extent& compute, Image<std::uint32_t>& words)
{
    parallelRows(compute, 8, [&](int y) {
        const ColumnSpan& columns = buffer.surfaceColumns(y);
        const int x0 = std::max(columns.x0, compute.x0), x1 = std::min(columns.x1, compute.x1);
        words.clearBeside(y, {x0, x1});
        HWY_DYNAMIC_DISPATCH(packRow)(values.row(y), buffer.links.row(y), x0, x1, words.row(y));
    });
}

void smoothAlongFlow(const GBuffer& buffer, const FineFlow* fine, const Image<std::uint32_t>& words, float gain,
                     const Extent& compute, LicImage& out)
{
    parallelRows(compute, 8, [&](int y) {
        const ColumnSpan& columns = buffer.surfaceColumns(y);
        const std::uint32_t* flow = fine ? fine->vectors.row(y) : buffer.flow.row(y);
        HWY_DYNAMIC_DISPATCH(smoothRow)(flow, fine != nullptr, words, gain, y, columns.x0, columns.x1, out.row(y));
    });
}

}  // namespace aeolic::cpu
#endif
