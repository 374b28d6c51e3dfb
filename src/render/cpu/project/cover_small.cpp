#include "render/cpu/project/cover_small.h"

#include <bit>
#include <cstring>

#include "render/cpu/simd/shared_bits.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/project/cover_small.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/project/triangle_boxes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// With two corners so near the third in x and y, edge functions fit 32 bits, and a row of pixels a lane.
constexpr std::int32_t kNear = 8 * kSubpixels;

HWY_INLINE hn::Mask<DI> isSmall(const TriangleLanes& t)
{
    const DI d;
    auto far = hn::Zero(d);
    for (int k = 1; k < 3; ++k)
        far = hn::Max(far, hn::Max(hn::Abs(hn::Sub(t.x[k], t.x[0])), hn::Abs(hn::Sub(t.y[k], t.y[0]))));
    return hn::Lt(far, hn::Set(d, kNear));
}

// An edge function: at least 0 inside.
struct Edge {
    VI rowStart, perPixel, perRow;

    // Of the edge from p to q at the centre of pixel (x, y), of a triangle that runs the other way round where
    // `turned`.
    HWY_INLINE Edge(VI px, VI py, VI qx, VI qy, VI x, VI y, hn::Mask<DI> turned)
    {
        const auto turn = [&](VI v) { return hn::IfThenElse(turned, hn::Neg(v), v); };
        const VI dx = turn(hn::Sub(qx, px)), dy = turn(hn::Sub(qy, py));
        rowStart = hn::Sub(hn::Mul(dx, hn::Sub(centreOf(y), py)), hn::Mul(dy, hn::Sub(centreOf(x), px)));
        perPixel = hn::Neg(hn::ShiftLeft<kSubpixelBits>(dy));
        perRow = hn::ShiftLeft<kSubpixelBits>(dx);
    }
};

// Adds the pixels of one row of each triangle.
HWY_INLINE void addRow(VI pixels, VI word, VI shift, BitsToSet& bits)
{
    const DI d;
    HWY_ALIGN std::uint32_t inside[hn::MaxLanes(d)], words[hn::MaxLanes(d)], shifts[hn::MaxLanes(d)];
    const DU du;
    hn::Store(hn::BitCast(du, pixels), du, inside);
    hn::Store(hn::BitCast(du, word), du, words);
    hn::Store(hn::BitCast(du, shift), du, shifts);
    std::uint8_t maskBytes[8] = {};
    hn::StoreMaskBits(d, hn::Ne(pixels, hn::Zero(d)), maskBytes);
    std::uint64_t some = 0;
    std::memcpy(&some, maskBytes, sizeof some);
    for (; some != 0; some &= some - 1) {
        const int k = std::countr_zero(some);
        bits.add(words[k], std::uint64_t(inside[k]) << shifts[k]);
        const std::uint64_t beyond = (std::uint64_t(inside[k]) >> (63 - shifts[k])) >> 1;
        if (HWY_UNLIKELY(beyond != 0)) bits.add(words[k] + 1, beyond);
    }
}

HWY_INLINE void coverLanes(const TriangleLanes& t, hn::Mask<DI> chosen, std::int32_t wordsPerRow, BitsToSet& bits)
{
    const DI d;
    const VI zero = hn::Zero(d), one = hn::Set(d, 1);
    const VI doubleArea = hn::Sub(hn::Mul(hn::Sub(t.x[1], t.x[0]), hn::Sub(t.y[2], t.y[0])),
                                  hn::Mul(hn::Sub(t.y[1], t.y[0]), hn::Sub(t.x[2], t.x[0])));
    chosen = hn::And(chosen, hn::Ne(doubleArea, zero));
    const auto turned = hn::Lt(doubleArea, zero);
    Edge e(t.x[0], t.y[0], t.x[1], t.y[1], t.x0, t.y0, turned), f(t.x[1], t.y[1], t.x[2], t.y[2], t.x0, t.y0, turned),
        g(t.x[2], t.y[2], t.x[0], t.y[0], t.x0, t.y0, turned);
    const VI width = hn::IfThenElseZero(chosen, hn::Sub(t.x1, t.x0)),
             height = hn::IfThenElseZero(chosen, hn::Sub(t.y1, t.y0));
    const VI inWidth = hn::Sub(hn::Shl(one, width), one);
    const VI shift = hn::And(t.x0, hn::Set(d, 63));
    VI word = hn::Add(hn::Mul(t.y0, hn::Set(d, wordsPerRow)), hn::ShiftRight<6>(t.x0));
    const int widest = hn::GetLane(hn::MaxOfLanes(d, width)), highest = hn::GetLane(hn::MaxOfLanes(d, height));
    for (int row = 0; row < highest; ++row) {
        VI pixels = zero, bit = one, a = e.rowStart, b = f.rowStart, c = g.rowStart;
        for (int i = 0; i < widest; ++i, bit = hn::Add(bit, bit)) {
            pixels = hn::Or(pixels, hn::AndNot(hn::BroadcastSignBit(hn::Or(a, hn::Or(b, c))), bit));
            a = hn::Add(a, e.perPixel);
            b = hn::Add(b, f.perPixel);
            c = hn::Add(c, g.perPixel);
        }
        const auto inHeight = hn::Gt(height, hn::Set(d, row));
        addRow(hn::IfThenElseZero(inHeight, hn::And(pixels, inWidth)), word, shift, bits);
        word = hn::Add(word, hn::Set(d, wordsPerRow));
        for (Edge* edge : {&e, &f, &g}) edge->rowStart = hn::Add(edge->rowStart, edge->perRow);
    }
}

void coverRange(const SceneArrays& arrays, const ScreenVertices& screen, std::size_t begin, std::size_t end,
                const Extent& whole, CoverageBits& bits, std::vector<TriangleBox>& large,
                std::vector<std::uint32_t>& unsafe)
{
    const DI d;
    BitsToSet toSet(bits.words.data());
    forEachTriangleLanes(arrays, screen, begin, end, whole, unsafe, [&](const TriangleLanes& t) AEOLIC_INLINE {
        const auto small = isSmall(t), smallOnes = hn::And(t.mayCover, small), others = hn::AndNot(small, t.mayCover);
        if (!hn::AllFalse(d, smallOnes)) coverLanes(t, smallOnes, std::int32_t(bits.wordsPerRow), toSet);
        if (HWY_UNLIKELY(!hn::AllFalse(d, others))) appendBoxes(t, others, hn::Zero(d), large);
    });
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(coverRange);

void coverSmall(const SceneArrays& arrays, const ScreenVertices& screen, std::size_t begin, std::size_t end,
                const Extent& whole, CoverageBits& bits, std::vector<TriangleBox>& large,
                std::vector<std::uint32_t>& unsafe)
{
    HWY_DYNAMIC_DISPATCH(coverRange)(arrays, screen, begin, end, whole, bits, large, unsafe);
}

}  // namespace aeolic::cpu
#endif
