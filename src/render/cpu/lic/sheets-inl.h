// Per-target include (Highway compiles it once per target): positions of traces, and how they move from pixel to pixel
// without leaving their sheet of the surface.

#if defined(AEOLIC_RENDER_CPU_SHEETS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_SHEETS_INL_H
#undef AEOLIC_RENDER_CPU_SHEETS_INL_H
#else
#define AEOLIC_RENDER_CPU_SHEETS_INL_H
#endif

#include <hwy/highway.h>

#include "render/cpu/simd/simd-inl.h"
#include "render/gbuffer.h"
#include "render/limits.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Where the traces of a vector of pixels are. Positions are relative to the pixel they started from, so a trace's
/// arithmetic is the same wherever in the image it runs.
struct Traces {
    VI startBits;       ///< Linear index of the starting pixel, less LinkImage::bitsOfZero().
    VF dx, dy;          ///< Pixels from the starting pixel's centre.
    VF sheetX, sheetY;  ///< A position near by whose nearest pixel is on the trace's sheet for certain.
    MF alive;
};

/// The bits of v + 1.5 * 2^23, a float whose unit is 1: those of 0 and the whole number nearest to v, ties to even.
/// |v| < 2^22.
HWY_INLINE VI wholeBits(VF v)
{
    return hn::BitCast(DI(), hn::Add(v, hn::Set(DF(), 12582912.0f)));
}
inline constexpr std::int32_t kWholeBitsOfZero = 0x4B400000;

/// Whole numbers to integers: two operations where a checked conversion takes seven. Numbers that are not whole are
/// rounded to the nearest, ties to even. |v| < 2^22.
HWY_INLINE VI wholeNumber(VF v)
{
    return hn::Sub(wholeBits(v), hn::Set(DI(), kWholeBitsOfZero));
}

/// The pixels around a position, with their bilinear weights.
struct Taps {
    VI xBits, yBits;    ///< The upper left pixel, as wholeBits().
    VF wx, wy;          ///< Position within the cell, [0, 1).
    Block4<VF> weight;  ///< Order (0,0) (1,0) (0,1) (1,1).
    bool anyPartial = false;
    MF partial;  ///< Some tap is on another sheet than the nearest, and weighs nothing. Valid if anyPartial.

    VI nearestX() const { return pastHalf(xBits, wx); }
    VI nearestY() const { return pastHalf(yBits, wy); }
    VI nearestIsRight() const { return isPastHalf(wx); }  ///< 1 or 0.
    VI nearestIsLower() const { return isPastHalf(wy); }

    template <class V>
    V pick(V v00, V v10, V v01, V v11) const  ///< The nearest pixel's.
    {
        const VF half = hn::Set(DF(), 0.5f);
        const auto right = hn::RebindMask(hn::DFromV<V>(), hn::Ge(wx, half)),
                   lower = hn::RebindMask(hn::DFromV<V>(), hn::Ge(wy, half));
        return hn::IfThenElse(lower, hn::IfThenElse(right, v11, v01), hn::IfThenElse(right, v10, v00));
    }

private:
    static VI isPastHalf(VF weight)
    {
        const DI di;
        return hn::IfThenElseZero(hn::RebindMask(di, hn::Ge(weight, hn::Set(DF(), 0.5f))), hn::Set(di, 1));
    }
    static VI pastHalf(VI bits, VF weight)
    {
        return hn::Add(hn::Sub(bits, hn::Set(DI(), kWholeBitsOfZero)), isPastHalf(weight));
    }
};

HWY_INLINE Taps findTaps(VF dx, VF dy)
{
    Taps t;
    const VF floorX = hn::Floor(dx), floorY = hn::Floor(dy);
    t.wx = hn::Sub(dx, floorX);
    t.wy = hn::Sub(dy, floorY);
    t.xBits = wholeBits(floorX);
    t.yBits = wholeBits(floorY);
    return t;
}

/// Bilinear weights: computed while what they weigh is on its way.
HWY_INLINE void weigh(Taps& t)
{
    t.weight.d = hn::Mul(t.wx, t.wy);
    t.weight.b = hn::Sub(t.wx, t.weight.d);
    t.weight.c = hn::Sub(t.wy, t.weight.d);
    t.weight.a = hn::Sub(hn::Sub(hn::Set(DF(), 1.0f), t.wx), t.weight.c);
}

HWY_INLINE VF blendTaps(const Block4<VF>& weight, VF v00, VF v10, VF v01, VF v11)
{
    const VF upper = hn::MulAdd(weight.b, v10, hn::Mul(weight.a, v00));
    return hn::Add(upper, hn::MulAdd(weight.d, v11, hn::Mul(weight.c, v01)));
}

/// The link masks, and linear indices of pixels: the same for all images of a G-buffer. Indices count from the start of
/// the apron, so none is negative; its rows are as many as a step can leave the image by, so none is out of bounds.
struct LinkImage {
    const std::uint8_t* links;
    std::int32_t stride;
    std::int32_t originIndex;  ///< The index of the first valid pixel.

    explicit LinkImage(const GBuffer& buffer)
        : stride(std::int32_t(buffer.links.stride())),
          originIndex(buffer.links.kApronRows * stride + buffer.links.kApron)
    {
        links = base(buffer.links);
    }
    /// Address of index 0 in an image of the same extent.
    template <class T>
    const T* base(const Image<T>& image) const
    {
        return image.origin() - originIndex;
    }
    /// Where the upper left tap is.
    VI index(const Traces& t, const Taps& taps) const
    {
        return hn::Add(hn::Add(t.startBits, taps.xBits), hn::Mul(taps.yBits, hn::Set(DI(), stride)));
    }
    VI index(const Traces& t, VI x, VI y) const
    {
        const DI di;
        const VI start = hn::Add(t.startBits, hn::Set(di, bitsOfZero()));
        return hn::Add(hn::Add(start, x), hn::Mul(y, hn::Set(di, stride)));
    }
    /// What wholeBits() of 0 for both coordinates add to an index. It wraps around, and so do the sums that it is in.
    std::int32_t bitsOfZero() const
    {
        return std::int32_t(std::uint32_t(kWholeBitsOfZero) * (std::uint32_t(stride) + 1u));
    }

    /// Link masks with the pixel itself in the middle: bit (sy + 1) * 3 + (sx + 1).
    VI nineBits(const Traces& t, VI x, VI y) const
    {
        const DI di;
        const VI mask = hn::GatherOffset(di, reinterpret_cast<const std::int32_t*>(links), index(t, x, y));
        return hn::Or(hn::Or(hn::And(mask, hn::Set(di, 0x0F)), hn::Set(di, 0x10)),
                      hn::ShiftLeft<1>(hn::And(mask, hn::Set(di, 0xF0))));
    }
};

/// Where nine bits of links say that there is one to the pixel `x`, `y` further.
HWY_INLINE MF hasLink(VI links, VI x, VI y)
{
    const DI di;
    const VI bit = hn::Add(hn::Add(hn::Mul(y, hn::Set(di, 3)), x), hn::Set(di, 4));
    return hn::RebindMask(DF(), hn::Ne(hn::And(hn::Shr(links, bit), hn::Set(di, 1)), hn::Zero(di)));
}

/// Walks from the traces' pixels to the taps' nearest, hop by hop; a trace dies where a hop has no link: at a
/// silhouette, at the image's border, where the flow ends. Returns the links of where live ones got to.
HWY_INLINE VI followLinks(const LinkImage& image, const Taps& taps, Traces& t)
{
    const DI di;
    const VI one = hn::Set(di, 1), minusOne = hn::Set(di, -1);
    const auto startAlive = hn::RebindMask(di, t.alive);
    const auto whereAlive = [&](VI v) { return hn::IfThenElseZero(startAlive, v); };
    const Taps sheet = findTaps(t.sheetX, t.sheetY);  // Rounds halves as the taps do.
    const VI toX = whereAlive(taps.nearestX()), toY = whereAlive(taps.nearestY());
    VI x = whereAlive(sheet.nearestX()), y = whereAlive(sheet.nearestY());
    const VI backX = hn::Sub(x, toX), backY = hn::Sub(y, toY);
    if (HWY_LIKELY(hn::AllFalse(di, hn::Gt(hn::Max(hn::Abs(backX), hn::Abs(backY)), one)))) {
        // A hop at most, and what links one pixel to another links that one to it: one look-up does for the hop and for
        // the weights.
        const VI links = image.nineBits(t, toX, toY);
        t.alive = hn::And(t.alive, hasLink(links, backX, backY));
        return links;
    }
    VI links = image.nineBits(t, x, y);
    for (;;) {
        const VI hopX = hn::Max(minusOne, hn::Min(one, hn::Sub(toX, x)));
        const VI hopY = hn::Max(minusOne, hn::Min(one, hn::Sub(toY, y)));
        t.alive = hn::And(t.alive, hasLink(links, hopX, hopY));
        const auto alive = hn::RebindMask(di, t.alive);
        x = hn::Add(x, hn::IfThenElseZero(alive, hopX));
        y = hn::Add(y, hn::IfThenElseZero(alive, hopY));
        links = image.nineBits(t, x, y);
        const auto arrived = hn::And(hn::Eq(x, toX), hn::Eq(y, toY));
        if (HWY_LIKELY(hn::AllTrue(di, hn::Or(arrived, hn::Not(alive))))) return links;
    }
}

/// In partial lanes lets only taps weigh that are linked to the nearest pixel, whose nine bits are `links`.
HWY_INLINE void weighLinkedTaps(VI links, Taps& taps)
{
    const DF d;
    const DI di;
    // Seen from the nearest pixel the four taps are bits shift + {0, 1, 3, 4} of its nine.
    const VI shift =
        hn::Sub(hn::Sub(hn::Set(di, 4), taps.nearestIsRight()), hn::Mul(taps.nearestIsLower(), hn::Set(di, 3)));
    const VI bits = hn::Shr(links, shift);
    const auto linked = [&](VF weight, int bit) AEOLIC_INLINE {
        return hn::IfThenElseZero(hn::RebindMask(d, hn::TestBit(bits, hn::Set(di, 1 << bit))), weight);
    };
    const Block4<VF> all = taps.weight, some{linked(all.a, 0), linked(all.b, 1), linked(all.c, 3), linked(all.d, 4)};
    // The nearest pixel always counts, so the sum is at least a quarter.
    const VF sum = hn::Add(hn::Add(hn::Add(some.a, some.b), some.c), some.d);
    const VF inverse = hn::Div(hn::Set(d, 1.0f), sum);
    const auto weight = [&](VF part, VF whole)
                            AEOLIC_INLINE { return hn::IfThenElse(taps.partial, hn::Mul(part, inverse), whole); };
    taps.weight = {weight(some.a, all.a), weight(some.b, all.b), weight(some.c, all.c), weight(some.d, all.d)};
}

/// Takes live traces to (dx, dy), whose taps are `taps`; others stay where they ended, which is on their sheet. `open`:
/// the four taps and all their neighbours are linked to all of theirs, as far as `reachPx`: a step of at most that then
/// cannot leave the sheet, and nothing needs to be looked up. That is so for nearly all steps. Otherwise taps of other
/// sheets are weighed out where there are any, or where the taps are `uneven`.
HWY_INLINE void moveAlongLinks(const LinkImage& image, VF dx, VF dy, MU open, float reachPx, MF uneven, Taps& taps,
                               Traces& t)
{
    const DF d;
    const VF farthest = hn::Max(hn::Abs(hn::Sub(dx, t.sheetX)), hn::Abs(hn::Sub(dy, t.sheetY)));
    const MF easy = hn::And(hn::Le(farthest, hn::Set(d, reachPx)), hn::RebindMask(d, open));
    if (HWY_UNLIKELY(!hn::AllFalse(d, hn::AndNot(easy, t.alive)))) {
        const VI links = followLinks(image, taps, t);
        taps.partial = hn::And(t.alive, hn::RebindMask(d, hn::Ne(links, hn::Set(DI(), limits::kAllNine))));
        taps.anyPartial = !hn::AllFalse(d, hn::Or(taps.partial, hn::And(t.alive, uneven)));
        if (taps.anyPartial) weighLinkedTaps(links, taps);
    }
    t.dx = t.sheetX = hn::IfThenElse(t.alive, dx, t.dx);
    t.dy = t.sheetY = hn::IfThenElse(t.alive, dy, t.dy);
}

/// Ends traces whose interpolated position is not on the sheet their sheet position is on; after this it is.
HWY_INLINE void settle(const LinkImage& image, Traces& t)
{
    const DF d;
    const DI di;
    const Taps sheet = findTaps(t.sheetX, t.sheetY);
    const auto alive = hn::RebindMask(di, t.alive);
    const VI links =
        image.nineBits(t, hn::IfThenElseZero(alive, sheet.nearestX()), hn::IfThenElseZero(alive, sheet.nearestY()));
    const VF farthest = hn::Max(hn::Abs(hn::Sub(t.dx, t.sheetX)), hn::Abs(hn::Sub(t.dy, t.sheetY)));
    const MF easy = hn::And(hn::Le(farthest, hn::Set(d, float(limits::kSettledPx))),
                            hn::RebindMask(d, hn::Eq(links, hn::Set(di, limits::kAllNine))));
    if (HWY_UNLIKELY(!hn::AllFalse(d, hn::AndNot(easy, t.alive)))) followLinks(image, findTaps(t.dx, t.dy), t);
    t.sheetX = t.dx;
    t.sheetY = t.dy;
}

/// Traces at rest on the centres of the pixels from `start` on.
HWY_INLINE Traces startTraces(const GBuffer& buffer, const LinkImage& links, std::ptrdiff_t start)
{
    const DF d;
    const DI di;
    Traces t;
    const std::uint32_t first = std::uint32_t(start) + std::uint32_t(links.originIndex);
    const auto firstBits = std::int32_t(first - std::uint32_t(links.bitsOfZero()));
    t.startBits = hn::Add(hn::Set(di, firstBits), hn::Iota(di, 0));
    t.dx = t.dy = t.sheetX = t.sheetY = hn::Zero(d);
    t.alive = hn::RebindMask(d, hn::Ne(hn::LoadU(DU(), buffer.flow.origin() + start), hn::Zero(DU())));
    return t;
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
