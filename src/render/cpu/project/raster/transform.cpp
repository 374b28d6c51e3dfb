#include "render/cpu/project/raster/transform.h"

#include <algorithm>
#include <cstring>

#include "base/parallel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/project/raster/transform.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/project/raster/triangle_boxes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void transformRange(const SceneArrays& arrays, const View& view, std::size_t begin, std::size_t end,
                    ScreenVertices& out)
{
    const hn::ScalableTag<float> d;
    const hn::RebindToSigned<decltype(d)> di;
    const auto dot = [&](auto x, auto y, auto z, const glm::vec3& axis) {
        return hn::MulAdd(x, hn::Set(d, axis.x), hn::MulAdd(y, hn::Set(d, axis.y), hn::Mul(z, hn::Set(d, axis.z))));
    };
    const auto nearDepth = hn::Set(d, float(view.nearDepth));
    const auto focal = hn::Set(d, view.focalPx);
    const auto guard = hn::Set(d, kGuardBandPx), scale = hn::Set(d, float(kSubpixels));
    for (std::size_t i = begin; i < end; i += hn::Lanes(d)) {
        const auto px = hn::Sub(hn::LoadU(d, &arrays.x[i]), hn::Set(d, view.eyeLocal.x));
        const auto py = hn::Sub(hn::LoadU(d, &arrays.y[i]), hn::Set(d, view.eyeLocal.y));
        const auto pz = hn::Sub(hn::LoadU(d, &arrays.z[i]), hn::Set(d, view.eyeLocal.z));
        const auto depth = dot(px, py, pz, view.forward);
        const auto inFront = hn::Ge(depth, nearDepth);
        const auto invDepth = hn::Div(hn::Set(d, 1.0f), hn::IfThenElse(inFront, depth, nearDepth));
        const auto focalInv = hn::Mul(focal, invDepth);
        const auto sx = hn::MulAdd(dot(px, py, pz, view.right), focalInv, hn::Set(d, view.centerX));
        const auto sy = hn::NegMulAdd(dot(px, py, pz, view.up), focalInv, hn::Set(d, view.centerY));
        const auto safe = hn::And(inFront, hn::And(hn::Lt(hn::Abs(sx), guard), hn::Lt(hn::Abs(sy), guard)));
        const auto zero = hn::Zero(d);
        const auto fx = hn::NearestInt(hn::Mul(hn::IfThenElse(safe, sx, zero), scale));
        const auto fy = hn::NearestInt(hn::Mul(hn::IfThenElse(safe, sy, zero), scale));
        const auto x = hn::IfThenElse(hn::RebindMask(di, safe), fx, hn::Set(di, kUnsafe));
        hn::StoreInterleaved4(x, fy, hn::BitCast(di, invDepth), hn::Zero(di), di, &out[i].x);
    }
}

// Sets the bits of the lanes chosen, of which the first is bit `at`. Words without such a bit may be another thread's.
HWY_INLINE void markBits(hn::Mask<DI> chosen, std::size_t at, std::uint64_t* words)
{
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(DI(), chosen, bytes);
    std::uint64_t bits = 0;
    std::memcpy(&bits, bytes, sizeof bits);
    constexpr std::size_t kWord = 64;
    const std::uint64_t low = bits << (at % kWord), high = at % kWord == 0 ? 0 : bits >> (kWord - at % kWord);
    if (low != 0) words[at / kWord] |= low;
    if (high != 0) words[at / kWord + 1] |= high;
}

void setUpRange(const SceneArrays& arrays, const ScreenVertices& screen, std::size_t begin, std::size_t end,
                const Extent& scissor, int margin, const TriangleFinds& out)
{
    const DI d;
    const DF df;
    forEachTriangleLanes(
        arrays, screen, begin, end, scissor, margin, out.unsafe, [&](const TriangleLanes& t) AEOLIC_INLINE {
            if (!hn::AllFalse(d, t.between)) markBits(t.between, t.first, out.between);
            if (hn::AllFalse(d, t.mayCover)) return;
            const auto difference = [&](VI p, VI q) { return hn::ConvertTo(df, hn::Sub(p, q)); };
            const auto clockwise = hn::Gt(hn::Mul(difference(t.x[1], t.x[0]), difference(t.y[2], t.y[0])),
                                          hn::Mul(difference(t.y[1], t.y[0]), difference(t.x[2], t.x[0])));
            const VI facing = hn::IfThenElseZero(hn::RebindMask(d, clockwise), hn::Set(d, 1));
            appendBoxes(t, t.mayCover, facing, out.boxes);
        });
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(transformRange);
HWY_EXPORT(setUpRange);

void transformVertices(const SceneArrays& arrays, const View& view, const VisibleGroups& visible, ScreenVertices& out)
{
    out.resize(arrays.x.size());
    // Blocks are whole vectors of every target; the arrays' padding takes the last one's overhang.
    const std::size_t count = arrays.vertices.size();
    parallelRanges(visible.blocks(), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b)
            if (visible.seesBlock(b)) HWY_DYNAMIC_DISPATCH(transformRange)
        (arrays, view, b * kBlockPoints, std::min((b + 1) * kBlockPoints, count), out);
    });
}

void setUpTriangles(const SceneArrays& arrays, const ScreenVertices& screen, std::size_t begin, std::size_t end,
                    const Extent& scissor, int margin, const TriangleFinds& out)
{
    HWY_DYNAMIC_DISPATCH(setUpRange)(arrays, screen, begin, end, scissor, margin, out);
}

}  // namespace aeolic::cpu
#endif
