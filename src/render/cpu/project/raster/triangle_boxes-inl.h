// Per-target include (Highway compiles it once per target): where triangles are on the image, a triangle a lane.

#if defined(AEOLIC_RENDER_CPU_TRIANGLE_BOXES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_TRIANGLE_BOXES_INL_H
#undef AEOLIC_RENDER_CPU_TRIANGLE_BOXES_INL_H
#else
#define AEOLIC_RENDER_CPU_TRIANGLE_BOXES_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "render/cpu/project/raster/transform.h"
#include "render/cpu/simd/compress-inl.h"
#include "render/cpu/simd/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Sub-pixels of a pixel's centre.
HWY_INLINE VI centreOf(VI pixel)
{
    return hn::Add(hn::ShiftLeft<kSubpixelBits>(pixel), hn::Set(DI(), kSubpixels / 2));
}

/// The first pixel whose centre lies at or after `v` sub-pixels.
HWY_INLINE VI firstPixel(VI v)
{
    return hn::ShiftRight<kSubpixelBits>(hn::Add(v, hn::Set(DI(), kSubpixels / 2 - 1)));
}

/// The pixel after the last whose centre lies at or before `v` sub-pixels.
HWY_INLINE VI pastLastPixel(VI v)
{
    return hn::Add(hn::ShiftRight<kSubpixelBits>(hn::Sub(v, hn::Set(DI(), kSubpixels / 2))), hn::Set(DI(), 1));
}

/// A corner of each triangle.
struct Corners {
    VI x, y;
    VF invDepth;
};

HWY_INLINE Corners cornersAt(const ScreenVertices& screen, VI point)
{
    static_assert(sizeof(ScreenVertex) == 4 * sizeof(std::int32_t));
    const auto blocks = loadBlocks<4>(DU(), reinterpret_cast<const std::uint32_t*>(screen.data()), point);
    return {hn::BitCast(DI(), blocks.a), hn::BitCast(DI(), blocks.b), hn::BitCast(DF(), blocks.c)};
}

/// Triangles that follow each other in a mesh.
struct TriangleLanes {
    std::uint32_t first;    ///< Id of lane 0.
    VI x[3], y[3];          ///< Corners, sub-pixels.
    VI x0, y0, x1, y1;      ///< Pixel bounds, see TriangleBox.
    VI beside;              ///< As TriangleBox has it.
    hn::Mask<DI> mayCover;  ///< Others need clipping, cover no pixel centre of the scissor, or came before.
    hn::Mask<DI> between;   ///< They cover no centre, but may cover something within the margin of one.
};

/// Calls visit(TriangleLanes) for triangles [begin, end), a vector of them after the other, and appends the ids of
/// those that need clipping first. `margin`: sub-pixels.
template <class Visit>
HWY_INLINE void forEachTriangleLanes(const SceneArrays& arrays, const ScreenVertices& screen, std::size_t begin,
                                     std::size_t end, const Extent& scissor, int margin,
                                     std::vector<std::uint32_t>& unsafe, const Visit& visit)
{
    const DI d;
    const DU du;
    constexpr std::size_t kMaxLanes = hn::MaxLanes(d);
    const auto* triangles = reinterpret_cast<const std::uint32_t*>(arrays.scene->surface.triangles.data());
    const std::size_t lanes = hn::Lanes(d);
    for (std::size_t i = begin; i < end; i += lanes) {
        // The last vector of a range steps back rather than past the end: no scalar tail, no padding of the mesh.
        const std::size_t at = (i + lanes <= end || end < lanes) ? i : end - lanes;
        const std::size_t count = std::min(lanes, end - at);
        auto a = hn::Zero(du), b = hn::Zero(du), c = hn::Zero(du);
        if (count == lanes) {
            hn::LoadInterleaved3(du, triangles + 3 * at, a, b, c);
        } else {
            HWY_ALIGN std::uint32_t tail[3 * kMaxLanes] = {};
            std::copy_n(triangles + 3 * at, 3 * count, tail);
            hn::LoadInterleaved3(du, tail, a, b, c);
        }
        TriangleLanes t;
        t.first = std::uint32_t(at);
        const VI corner[3] = {hn::BitCast(d, a), hn::BitCast(d, b), hn::BitCast(d, c)};
        for (int k = 0; k < 3; ++k) {
            const Corners place = cornersAt(screen, corner[k]);
            t.x[k] = place.x;
            t.y[k] = place.y;
        }
        const VI left = hn::Min(t.x[0], hn::Min(t.x[1], t.x[2])), top = hn::Min(t.y[0], hn::Min(t.y[1], t.y[2]));
        const VI right = hn::Max(t.x[0], hn::Max(t.x[1], t.x[2])), bottom = hn::Max(t.y[0], hn::Max(t.y[1], t.y[2]));
        const auto first = [&](VI v, int edge) { return hn::Max(firstPixel(v), hn::Set(d, edge)); };
        const auto past = [&](VI v, int edge) { return hn::Min(pastLastPixel(v), hn::Set(d, edge)); };
        t.x0 = first(left, scissor.x0), t.y0 = first(top, scissor.y0);
        t.x1 = past(right, scissor.x1), t.y1 = past(bottom, scissor.y1);
        const VI beside = hn::Set(d, margin);
        const VI widerX0 = first(hn::Sub(left, beside), scissor.x0), widerY0 = first(hn::Sub(top, beside), scissor.y0);
        const VI widerX1 = past(hn::Add(right, beside), scissor.x1),
                 widerY1 = past(hn::Add(bottom, beside), scissor.y1);
        const auto overColumns = hn::Lt(widerX0, widerX1), overRows = hn::Lt(widerY0, widerY1);
        const auto side = [&](VI more, VI less, int bit) {
            return hn::IfThenElseZero(hn::Gt(more, less), hn::Set(d, bit));
        };
        t.beside = hn::Or(hn::Or(side(t.x0, widerX0, TriangleBox::kLeft), side(t.y0, widerY0, TriangleBox::kTop)),
                          hn::Or(side(widerX1, t.x1, TriangleBox::kRight), side(widerY1, t.y1, TriangleBox::kBottom)));
        const auto isSafe = hn::Ne(left, hn::Set(d, kUnsafe));
        // Lanes seen in the previous vector (after stepping back) or past a short range do not count again.
        const VI lane = hn::Add(hn::Iota(d, 0), hn::Set(d, std::int32_t(at) - std::int32_t(i)));
        const auto fresh = hn::AndNot(hn::Lt(lane, hn::Zero(d)), hn::Lt(lane, hn::Set(d, std::int32_t(end - i))));
        const auto counts = hn::And(fresh, isSafe);
        const auto covers = hn::And(hn::Lt(t.x0, t.x1), hn::Lt(t.y0, t.y1));
        t.mayCover = hn::And(counts, covers);
        t.between = hn::And(counts, hn::AndNot(covers, hn::And(overColumns, overRows)));
        if (HWY_UNLIKELY(!hn::AllTrue(d, hn::Or(isSafe, hn::Not(fresh))))) {
            HWY_ALIGN std::int32_t raw[kMaxLanes];
            hn::Store(hn::IfThenElseZero(hn::AndNot(isSafe, fresh), hn::Set(d, 1)), d, raw);
            for (std::size_t k = 0; k < lanes; ++k)
                if (raw[k]) unsafe.push_back(std::uint32_t(at + k));
        }
        visit(t);
    }
}

/// Appends the boxes of the `chosen` ones, in ascending order of id.
HWY_INLINE void appendBoxes(const TriangleLanes& t, hn::Mask<DI> chosen, VI facing, std::vector<TriangleBox>& boxes)
{
    const DI d;
    constexpr std::size_t kMaxLanes = hn::MaxLanes(d);
    HWY_ALIGN std::int32_t lane[kMaxLanes], x0[kMaxLanes], y0[kMaxLanes], x1[kMaxLanes], y1[kMaxLanes],
        faces[kMaxLanes], beside[kMaxLanes];
    const std::size_t count = compressStore(hn::Iota(d, 0), chosen, d, lane);
    if (count == 0) return;
    compressStore(t.x0, chosen, d, x0);
    compressStore(t.y0, chosen, d, y0);
    compressStore(t.x1, chosen, d, x1);
    compressStore(t.y1, chosen, d, y1);
    compressStore(facing, chosen, d, faces);
    compressStore(t.beside, chosen, d, beside);
    for (std::size_t k = 0; k < count; ++k)
        boxes.push_back({t.first + std::uint32_t(lane[k]), x0[k], y0[k], x1[k], y1[k], std::int16_t(faces[k]),
                         std::int16_t(beside[k])});
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
