// Per-target include (Highway compiles it once per target): positions of traces, and how they move from pixel to pixel
// without leaving their sheet of the surface.

#if defined(AEOLIC_RENDER_CPU_LINKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_LINKS_INL_H
#undef AEOLIC_RENDER_CPU_LINKS_INL_H
#else
#define AEOLIC_RENDER_CPU_LINKS_INL_H
#endif

#include <hwy/highway.h>

#include "render/cpu/simd-inl.h"
#include "render/gbuffer.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::ScalableTag<float>;
using DI = hn::RebindToSigned<DF>;
using DU = hn::RebindToUnsigned<DF>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;
using VU = hn::Vec<DU>;
using MF = hn::Mask<DF>;
using MU = hn::Mask<DU>;

/// Where the traces of a vector of pixels are. Positions are relative to the pixel they started from, so a trace's
/// arithmetic is the same wherever in the image it runs.
struct Traces {
    VI start;           ///< Linear index of the starting pixel.
    VF dx, dy;          ///< Pixels from the starting pixel's centre.
    VI pixelX, pixelY;  ///< A pixel near by that is on the trace's sheet; relative as well.
    MF alive;
};

/// The pixels around a position, with their bilinear weights.
struct Taps {
    VI x, y;       ///< The upper left pixel.
    VF wx, wy;     ///< Position within the cell, [0, 1).
    MF rightHalf, lowerHalf;
    VI nearestX, nearestY;
    bool anyPartial = false;
    MF partial;    ///< Some tap is on another sheet than the nearest: use `weight`.
    VF weight[4];  ///< Normalised; order (0,0) (1,0) (0,1) (1,1). Valid where partial.

    template <class V>
    V pick(V v00, V v10, V v01, V v11) const  ///< The nearest pixel's.
    {
        const auto right = hn::RebindMask(hn::DFromV<V>(), rightHalf), lower = hn::RebindMask(hn::DFromV<V>(), lowerHalf);
        return hn::IfThenElse(lower, hn::IfThenElse(right, v11, v01), hn::IfThenElse(right, v10, v00));
    }
};

HWY_INLINE Taps findTaps(VF dx, VF dy)
{
    const DF d;
    const DI di;
    Taps t;
    const VF half = hn::Set(d, 0.5f), floorX = hn::Floor(dx), floorY = hn::Floor(dy);
    t.wx = hn::Sub(dx, floorX);
    t.wy = hn::Sub(dy, floorY);
    t.x = hn::ConvertTo(di, floorX);
    t.y = hn::ConvertTo(di, floorY);
    t.rightHalf = hn::Ge(t.wx, half);
    t.lowerHalf = hn::Ge(t.wy, half);
    t.nearestX = hn::Sub(t.x, hn::VecFromMask(di, hn::RebindMask(di, t.rightHalf)));
    t.nearestY = hn::Sub(t.y, hn::VecFromMask(di, hn::RebindMask(di, t.lowerHalf)));
    t.partial = hn::MaskFromVec(hn::Zero(d));
    return t;
}

HWY_INLINE VF blendTaps(const Taps& t, VF v00, VF v10, VF v01, VF v11)
{
    return lerp(lerp(v00, v10, t.wx), lerp(v01, v11, t.wx), t.wy);
}
HWY_INLINE VF blendPartial(const Taps& t, VF v00, VF v10, VF v01, VF v11)
{
    return hn::MulAdd(t.weight[0], v00, hn::MulAdd(t.weight[1], v10, hn::MulAdd(t.weight[2], v01, hn::Mul(t.weight[3], v11))));
}

/// The link masks, and linear indices of pixels: the same for all images of a G-buffer.
struct LinkImage {
    const std::uint8_t* links;
    std::int32_t stride;
    std::int32_t lowest, highest;  ///< Indices that may be read: a row more than the valid ones on either side.
    int firstRow;                  ///< Global row of index 0.

    explicit LinkImage(const GBuffer& buffer)
        : links(buffer.links.origin()), stride(std::int32_t(buffer.links.stride())), lowest(-stride),
          highest(std::int32_t(buffer.links.stride() * buffer.valid().height()) - 1), firstRow(buffer.valid().y0)
    {
    }
    VI index(const Traces& t, VI x, VI y) const { return hn::Add(t.start, hn::Add(hn::Mul(y, hn::Set(DI(), stride)), x)); }
    /// Keeps addresses of traces that left the image in memory; all that far out reads as background.
    VI clampIndex(VI at) const { return hn::Min(hn::Max(at, hn::Set(DI(), lowest)), hn::Set(DI(), highest)); }

    /// Nine bits, the pixel itself in the middle: bit (sy + 1) * 3 + (sx + 1).
    VI nineBits(const Traces& t) const
    {
        const DI di;
        const VI at = clampIndex(index(t, t.pixelX, t.pixelY));
        const VI mask = hn::GatherOffset(di, reinterpret_cast<const std::int32_t*>(links), at);
        return hn::Or(hn::Or(hn::And(mask, hn::Set(di, 0x0F)), hn::Set(di, 0x10)), hn::ShiftLeft<1>(hn::And(mask, hn::Set(di, 0xF0))));
    }
};

/// Moves each live trace's pixel to the taps' nearest, hop by hop; a trace dies where a hop has no link: at a silhouette, at
/// the image's border, where the flow ends. Returns the links of where it got to.
HWY_INLINE VI followLinks(const LinkImage& image, const Taps& taps, Traces& t)
{
    const DI di;
    const VI one = hn::Set(di, 1), minusOne = hn::Set(di, -1), three = hn::Set(di, 3), four = hn::Set(di, 4);
    VI links = image.nineBits(t);
    for (;;) {
        const VI hopX = hn::Max(minusOne, hn::Min(one, hn::Sub(taps.nearestX, t.pixelX)));
        const VI hopY = hn::Max(minusOne, hn::Min(one, hn::Sub(taps.nearestY, t.pixelY)));
        const VI bit = hn::Add(hn::Add(hn::Mul(hopY, three), hopX), four);
        const auto linked = hn::Ne(hn::And(hn::Shr(links, bit), one), hn::Zero(di));
        t.alive = hn::And(t.alive, hn::RebindMask(DF(), linked));
        const auto alive = hn::RebindMask(di, t.alive);
        t.pixelX = hn::Add(t.pixelX, hn::IfThenElseZero(alive, hopX));
        t.pixelY = hn::Add(t.pixelY, hn::IfThenElseZero(alive, hopY));
        links = image.nineBits(t);
        const auto arrived = hn::And(hn::Eq(t.pixelX, taps.nearestX), hn::Eq(t.pixelY, taps.nearestY));
        if (HWY_LIKELY(hn::AllTrue(di, hn::Or(arrived, hn::Not(alive))))) return links;
    }
}

/// Weights of the taps that are linked to the nearest pixel, whose nine bits are `links`.
HWY_INLINE void weighLinkedTaps(VI links, Taps& taps)
{
    const DF d;
    const DI di;
    // Seen from the nearest pixel the four taps are bits shift + {0, 1, 3, 4} of its nine.
    const VI right = hn::Sub(taps.nearestX, taps.x), lower = hn::Sub(taps.nearestY, taps.y);
    const VI shift = hn::Sub(hn::Sub(hn::Set(di, 4), right), hn::Mul(lower, hn::Set(di, 3)));
    const VI bits = hn::Shr(links, shift);
    const auto has = [&](int k) { return hn::RebindMask(d, hn::Ne(hn::And(bits, hn::Set(di, 1 << k)), hn::Zero(di))); };
    const VF one = hn::Set(d, 1.0f), ux = hn::Sub(one, taps.wx), uy = hn::Sub(one, taps.wy);
    taps.weight[0] = hn::IfThenElseZero(has(0), hn::Mul(ux, uy));
    taps.weight[1] = hn::IfThenElseZero(has(1), hn::Mul(taps.wx, uy));
    taps.weight[2] = hn::IfThenElseZero(has(3), hn::Mul(ux, taps.wy));
    taps.weight[3] = hn::IfThenElseZero(has(4), hn::Mul(taps.wx, taps.wy));
    // The nearest pixel always counts, so the sum is at least a quarter.
    const VF inverse = hn::Div(one, hn::Add(hn::Add(taps.weight[0], taps.weight[1]), hn::Add(taps.weight[2], taps.weight[3])));
    for (VF& w : taps.weight) w = hn::Mul(w, inverse);
}

/// Takes live traces to (dx, dy), whose taps are `taps`. `open`: the nearest pixel is linked to all its neighbours; then a hop
/// from any of them is allowed and all taps count, and nothing needs to be looked up. That is so for nearly all steps.
HWY_INLINE void moveAlongLinks(const LinkImage& image, VF dx, VF dy, MU open, Taps& taps, Traces& t)
{
    const DI di;
    const VI one = hn::Set(di, 1);
    const VI farthest = hn::Max(hn::Abs(hn::Sub(taps.nearestX, t.pixelX)), hn::Abs(hn::Sub(taps.nearestY, t.pixelY)));
    const auto easy = hn::AndNot(hn::Gt(farthest, one), hn::RebindMask(di, open));
    const auto alive = hn::RebindMask(di, t.alive);
    if (HWY_LIKELY(hn::AllTrue(di, hn::Or(easy, hn::Not(alive))))) {
        t.pixelX = hn::IfThenElse(alive, taps.nearestX, t.pixelX);
        t.pixelY = hn::IfThenElse(alive, taps.nearestY, t.pixelY);
    } else {
        const VI links = followLinks(image, taps, t);
        taps.anyPartial = true;
        taps.partial = hn::And(t.alive, hn::RebindMask(DF(), hn::Ne(links, hn::Set(di, 0x1FF))));
        weighLinkedTaps(links, taps);
    }
    t.dx = hn::IfThenElse(t.alive, dx, t.dx);
    t.dy = hn::IfThenElse(t.alive, dy, t.dy);
}

/// Traces at rest on the centres of the pixels from `start` on.
HWY_INLINE Traces startTraces(const GBuffer& buffer, std::ptrdiff_t start)
{
    const DF d;
    const DI di;
    Traces t;
    t.start = hn::Add(hn::Set(di, std::int32_t(start)), hn::Iota(di, 0));
    t.dx = t.dy = hn::Zero(d);
    t.pixelX = t.pixelY = hn::Zero(di);
    t.alive = hn::RebindMask(d, hn::Ne(hn::LoadU(DU(), buffer.flow.origin() + start), hn::Zero(DU())));
    return t;
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
