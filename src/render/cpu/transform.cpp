#include "render/cpu/transform.h"

#include <algorithm>

#include "base/parallel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/transform.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

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
    const auto nearDepth = hn::Set(d, float(view.camera.nearDepth));
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
        hn::StoreU(hn::IfThenElse(hn::RebindMask(di, safe), fx, hn::Set(di, kUnsafe)), di, &out.x[i]);
        hn::StoreU(fy, di, &out.y[i]);
        hn::StoreU(invDepth, d, &out.invDepth[i]);
    }
}

void setUpRange(const SceneArrays& arrays, const ScreenVertices& screen, std::size_t begin, std::size_t end,
                const Extent& scissor, std::vector<TriangleBox>& boxes, std::vector<std::uint32_t>& unsafe)
{
    const hn::ScalableTag<std::int32_t> d;
    const hn::RebindToUnsigned<decltype(d)> du;
    const hn::RebindToFloat<decltype(d)> df;
    constexpr std::size_t kMaxLanes = hn::MaxLanes(d);
    HWY_ALIGN std::int32_t lo[4][kMaxLanes], ids[kMaxLanes], raw[kMaxLanes], faces[kMaxLanes];
    const auto* triangles = reinterpret_cast<const std::uint32_t*>(arrays.scene->surface.triangles.data());
    const std::size_t lanes = hn::Lanes(d);
    const auto half = hn::Set(d, kSubpixels / 2);
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
        const auto ia = hn::BitCast(d, a), ib = hn::BitCast(d, b), ic = hn::BitCast(d, c);
        const auto xa = hn::GatherIndex(d, screen.x.data(), ia), ya = hn::GatherIndex(d, screen.y.data(), ia);
        const auto xb = hn::GatherIndex(d, screen.x.data(), ib), yb = hn::GatherIndex(d, screen.y.data(), ib);
        const auto xc = hn::GatherIndex(d, screen.x.data(), ic), yc = hn::GatherIndex(d, screen.y.data(), ic);
        const auto xmin = hn::Min(xa, hn::Min(xb, xc)), ymin = hn::Min(ya, hn::Min(yb, yc));
        // A pixel centre lies at 256 x + 128: the first at or after min, and one past the last at or before max.
        const auto first = [&](auto v) {
            return hn::ShiftRight<kSubpixelBits>(hn::Add(v, hn::Set(d, kSubpixels / 2 - 1)));
        };
        const auto last = [&](auto v) {
            return hn::Add(hn::ShiftRight<kSubpixelBits>(hn::Sub(v, half)), hn::Set(d, 1));
        };
        const auto x0 = hn::Max(first(xmin), hn::Set(d, scissor.x0)), y0 = hn::Max(first(ymin), hn::Set(d, scissor.y0));
        const auto x1 = hn::Min(last(hn::Max(xa, hn::Max(xb, xc))), hn::Set(d, scissor.x1));
        const auto y1 = hn::Min(last(hn::Max(ya, hn::Max(yb, yc))), hn::Set(d, scissor.y1));
        const auto isSafe = hn::Ne(xmin, hn::Set(d, kUnsafe));
        // Lanes seen in the previous vector (after stepping back) or past a short range do not count again.
        const auto lane = hn::Add(hn::Iota(d, 0), hn::Set(d, std::int32_t(at) - std::int32_t(i)));
        const auto fresh = hn::AndNot(hn::Lt(lane, hn::Zero(d)), hn::Lt(lane, hn::Set(d, std::int32_t(end - i))));
        const auto difference = [&](auto p, auto q) { return hn::ConvertTo(df, hn::Sub(p, q)); };
        const auto clockwise =
            hn::Gt(hn::Mul(difference(xb, xa), difference(yc, ya)), hn::Mul(difference(yb, ya), difference(xc, xa)));
        const auto facing = hn::IfThenElseZero(hn::RebindMask(d, clockwise), hn::Set(d, 1));
        const auto keep = hn::And(hn::And(fresh, isSafe), hn::And(hn::Lt(x0, x1), hn::Lt(y0, y1)));
        if (HWY_UNLIKELY(!hn::AllTrue(d, hn::Or(isSafe, hn::Not(fresh))))) {
            hn::Store(hn::IfThenElse(hn::And(fresh, hn::Not(isSafe)), hn::Set(d, 1), hn::Zero(d)), d, raw);
            for (std::size_t k = 0; k < lanes; ++k)
                if (raw[k]) unsafe.push_back(std::uint32_t(at + k));
        }
        const std::size_t kept = hn::CompressStore(hn::Iota(d, 0), keep, d, ids);
        if (kept == 0) continue;
        hn::CompressStore(x0, keep, d, lo[0]);
        hn::CompressStore(y0, keep, d, lo[1]);
        hn::CompressStore(x1, keep, d, lo[2]);
        hn::CompressStore(y1, keep, d, lo[3]);
        hn::CompressStore(facing, keep, d, faces);
        for (std::size_t k = 0; k < kept; ++k)
            boxes.push_back(
                {std::uint32_t(at) + std::uint32_t(ids[k]), lo[0][k], lo[1][k], lo[2][k], lo[3][k], faces[k]});
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(transformRange);
HWY_EXPORT(setUpRange);

void transformVertices(const SceneArrays& arrays, const View& view, const VisibleGroups& visible, ScreenVertices& out)
{
    out.x.resize(arrays.x.size());
    out.y.resize(arrays.x.size());
    out.invDepth.resize(arrays.x.size());
    // Blocks are whole vectors of every target; the arrays' padding takes the last one's overhang.
    const std::size_t count = arrays.vertices.size();
    parallelRanges(visible.blocks(), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b)
            if (visible.seesBlock(b)) HWY_DYNAMIC_DISPATCH(transformRange)
        (arrays, view, b * kBlockPoints, std::min((b + 1) * kBlockPoints, count), out);
    });
}

void setUpTriangles(const SceneArrays& arrays, const ScreenVertices& screen, std::size_t begin, std::size_t end,
                    const Extent& scissor, std::vector<TriangleBox>& boxes, std::vector<std::uint32_t>& unsafe)
{
    HWY_DYNAMIC_DISPATCH(setUpRange)(arrays, screen, begin, end, scissor, boxes, unsafe);
}

}  // namespace aeolic::cpu
#endif
