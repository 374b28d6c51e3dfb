// Per-target include (Highway compiles it once per target): small triangles made ready for drawing, a triangle a lane.

#if defined(AEOLIC_RENDER_CPU_TRIANGLE_BATCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_TRIANGLE_BATCH_INL_H
#undef AEOLIC_RENDER_CPU_TRIANGLE_BATCH_INL_H
#else
#define AEOLIC_RENDER_CPU_TRIANGLE_BATCH_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>
#include <span>

#include "data/mesh/surface_mesh.h"
#include "render/cpu/project/raster/corners-inl.h"
#include "render/cpu/project/raster/raster.h"
#include "render/cpu/simd/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Edge functions of triangles narrower and lower than this many sub-pixels fit 32 bits: twice 2^14 (2^14 + 2^8).
constexpr std::int32_t kSmallSpan = 1 << 14;

/// A vector of triangles made ready for their rows, lane by lane.
struct Batch {
    static constexpr std::size_t kMost = hn::MaxLanes(DI());
    HWY_ALIGN std::uint32_t id[kMost];
    HWY_ALIGN std::int32_t x0[kMost], x1[kMost], y0[kMost], y1[kMost];
    HWY_ALIGN std::int32_t edge[3][kMost], edgeX[3][kMost], edgeY[3][kMost], fromAX[kMost], fromAY[kMost];
    HWY_ALIGN double depthX[kMost], depthY[kMost];
    HWY_ALIGN float depth[kMost], lowest[kMost], highest[kMost], bias[kMost];
    HWY_ALIGN std::uint8_t isReady[kMost], isLarge[kMost];  // Neither: nothing of it shows.

    /// For these, at least one and at most a vector of them. Lanes without a triangle hold anything.
    void take(std::span<const std::uint32_t> ids)
    {
        std::copy(ids.begin(), ids.end(), id);
        std::fill(id + ids.size(), id + hn::Lanes(DI()), ids[0]);
    }
};

// Whether p is the corner from which depths are computed, not q (drawTriangle()).
HWY_INLINE hn::Mask<DI> comesFirst(const Corners& p, const Corners& q)
{
    return hn::Or(hn::Lt(p.x, q.x), hn::And(hn::Eq(p.x, q.x), hn::Lt(p.y, q.y)));
}

HWY_INLINE Corners select(hn::Mask<DI> mask, const Corners& yes, const Corners& no)
{
    return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
            hn::IfThenElse(hn::RebindMask(DF(), mask), yes.invDepth, no.invDepth)};
}

// The cross product of two edges from one corner, or of an edge and the way to a point.
HWY_INLINE VI cross(VI ax, VI ay, VI bx, VI by)
{
    return hn::Sub(hn::Mul(ax, by), hn::Mul(ay, bx));
}

// The plane of 1/depth, and frontBias() of front faces, as drawTriangle() computes them, operation by operation.
HWY_INLINE void setUpDepth(const Corners& a, const Corners& b, const Corners& c, VI doubleArea, hn::Mask<DI> isFront,
                           Batch& batch)
{
    const hn::ScalableTag<double> d;
    const hn::Rebind<float, decltype(d)> df;
    const hn::Rebind<std::int32_t, decltype(d)> di;
    constexpr std::size_t kMost = Batch::kMost;
    HWY_ALIGN std::int32_t bx[kMost], by[kMost], cx[kMost], cy[kMost], area[kMost];
    HWY_ALIGN float za[kMost], zb[kMost], zc[kMost];
    hn::Store(hn::Sub(b.x, a.x), DI(), bx);
    hn::Store(hn::Sub(b.y, a.y), DI(), by);
    hn::Store(hn::Sub(c.x, a.x), DI(), cx);
    hn::Store(hn::Sub(c.y, a.y), DI(), cy);
    hn::Store(doubleArea, DI(), area);
    hn::Store(a.invDepth, DF(), za);
    hn::Store(b.invDepth, DF(), zb);
    hn::Store(c.invDepth, DF(), zc);
    for (std::size_t i = 0; i < hn::Lanes(DI()); i += hn::Lanes(d)) {
        const auto whole = [&](const std::int32_t* from) { return hn::PromoteTo(d, hn::Load(di, from + i)); };
        const auto real = [&](const float* from) { return hn::PromoteTo(d, hn::Load(df, from + i)); };
        const auto inverseArea = hn::Div(hn::Set(d, 1.0), whole(area)), first = real(za);
        const auto riseB = hn::Sub(real(zb), first), riseC = hn::Sub(real(zc), first);
        const auto depthX = hn::Mul(hn::Sub(hn::Mul(riseB, whole(cy)), hn::Mul(riseC, whole(by))), inverseArea),
                   depthY = hn::Mul(hn::Sub(hn::Mul(riseC, whole(bx)), hn::Mul(riseB, whole(cx))), inverseArea);
        hn::Store(depthX, d, batch.depthX + i);
        hn::Store(depthY, d, batch.depthY + i);
        const auto lowest = real(batch.lowest), highest = real(batch.highest);
        const auto snapped = hn::Min(hn::Add(hn::Abs(depthX), hn::Abs(depthY)), hn::Sub(highest, lowest));
        const auto bias = hn::Add(hn::Min(snapped, hn::Mul(hn::Set(d, kMostFrontBias), highest)),
                                  hn::Mul(hn::Set(d, kFrontRounding), highest));
        hn::Store(hn::DemoteTo(df, bias), df, batch.bias + i);
    }
    hn::Store(hn::IfThenElseZero(hn::RebindMask(DF(), isFront), hn::Load(DF(), batch.bias)), DF(), batch.bias);
    hn::Store(a.invDepth, DF(), batch.depth);
}

/// Makes the triangles `batch.id` ready for the pixels of `tile`. `margin`: so many sub-pixels beside a pixel's centre
/// a triangle counts as over it.
HWY_INLINE void setUp(const SurfaceMesh& mesh, const ScreenVertices& screen, const Extent& tile, int margin,
                      const DrawRule& rule, Batch& batch)
{
    const DF d;
    const DI di;
    const DU du;
    const auto* points = reinterpret_cast<const std::int32_t*>(mesh.triangles.data());
    const VI place = hn::Mul(hn::BitCast(di, hn::Load(du, batch.id)), hn::Set(di, 3));
    const Corners first = cornersAt(screen, hn::GatherIndex(di, points, place)),
                  second = cornersAt(screen, hn::GatherIndex(di, points + 1, place)),
                  third = cornersAt(screen, hn::GatherIndex(di, points + 2, place));
    const VI left = hn::Min(first.x, hn::Min(second.x, third.x)), right = hn::Max(first.x, hn::Max(second.x, third.x));
    const VI top = hn::Min(first.y, hn::Min(second.y, third.y)), bottom = hn::Max(first.y, hn::Max(second.y, third.y));
    const VI small = hn::Set(di, kSmallSpan);
    const auto isSmall = hn::And(hn::Lt(hn::Sub(right, left), small), hn::Lt(hn::Sub(bottom, top), small));
    const VI signedArea = cross(hn::Sub(second.x, first.x), hn::Sub(second.y, first.y), hn::Sub(third.x, first.x),
                                hn::Sub(third.y, first.y));
    const auto isFront = hn::Lt(signedArea, hn::Zero(di));
    const Corners next = select(isFront, third, second), last = select(isFront, second, third);
    const auto fromNext = hn::AndNot(comesFirst(last, next), comesFirst(next, first)),
               fromLast = hn::AndNot(fromNext, comesFirst(last, first));
    const Corners a = select(fromNext, next, select(fromLast, last, first)),
                  b = select(fromNext, last, select(fromLast, first, next)),
                  c = select(fromNext, first, select(fromLast, next, last));
    const VI doubleArea = hn::Abs(signedArea);

    const VI beside = hn::Set(di, margin);
    const VI x0 = hn::Max(firstPixel(hn::Sub(left, beside)), hn::Set(di, tile.x0)),
             x1 = hn::Min(pastLastPixel(hn::Add(right, beside)), hn::Set(di, tile.x1));
    const VI y0 = hn::Max(firstPixel(hn::Sub(top, beside)), hn::Set(di, tile.y0)),
             y1 = hn::Min(pastLastPixel(hn::Add(bottom, beside)), hn::Set(di, tile.y1));
    const VF highest = hn::Max(a.invDepth, hn::Max(b.invDepth, c.invDepth));
    const auto mayShow = hn::And(hn::And(hn::Lt(x0, x1), hn::Lt(y0, y1)),
                                 hn::RebindMask(di, hn::Ge(highest, hn::Set(d, rule.farInvDepth))));
    auto hasArea = hn::Gt(doubleArea, hn::Zero(di));
    if (rule.frontOnly) hasArea = hn::And(hasArea, isFront);
    const hn::Rebind<std::uint8_t, DI> d8;
    const auto flags = [&](hn::Mask<DI> mask) { return hn::DemoteTo(d8, hn::IfThenElseZero(mask, hn::Set(di, 1))); };
    hn::Store(flags(hn::And(mayShow, hn::And(isSmall, hasArea))), d8, batch.isReady);
    hn::Store(flags(hn::AndNot(isSmall, mayShow)), d8, batch.isLarge);
    hn::Store(x0, di, batch.x0);
    hn::Store(x1, di, batch.x1);
    hn::Store(y0, di, batch.y0);
    hn::Store(y1, di, batch.y1);
    hn::Store(highest, d, batch.highest);
    hn::Store(hn::Min(a.invDepth, hn::Min(b.invDepth, c.invDepth)), d, batch.lowest);

    const VI px = centreOf(x0), py = centreOf(y0);
    const Corners* corners[4] = {&a, &b, &c, &a};
    for (int k = 0; k < 3; ++k) {
        const Corners &p = *corners[k], &q = *corners[k + 1];
        const VI dx = hn::Sub(q.x, p.x), dy = hn::Sub(q.y, p.y);
        hn::Store(cross(dx, dy, hn::Sub(px, p.x), hn::Sub(py, p.y)), di, batch.edge[k]);
        hn::Store(hn::Neg(hn::ShiftLeft<kSubpixelBits>(dy)), di, batch.edgeX[k]);
        hn::Store(hn::ShiftLeft<kSubpixelBits>(dx), di, batch.edgeY[k]);
    }
    hn::Store(hn::Sub(px, a.x), di, batch.fromAX);
    hn::Store(hn::Sub(py, a.y), di, batch.fromAY);
    setUpDepth(a, b, c, doubleArea, isFront, batch);
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
