#include "render/cpu/project/raster/transform.h"

#include <algorithm>

#include "base/parallel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/project/raster/transform.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/project/raster/corners-inl.h"

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
    const std::uint64_t bits = bitsOf(DI(), chosen);
    constexpr std::size_t kWord = 64;
    const std::uint64_t low = bits << (at % kWord), high = at % kWord == 0 ? 0 : bits >> (kWord - at % kWord);
    if (low != 0) words[at / kWord] |= low;
    if (high != 0) words[at / kWord + 1] |= high;
}

// The members of TriangleBox for triangles that follow each other, a triangle a lane.
struct Boxes {
    VI x0, y0, x1, y1, facing, beside;
};

// Appends the boxes of the `chosen` ones, in ascending order of id. `first`: id of lane 0.
HWY_INLINE void appendBoxes(const Boxes& some, std::size_t first, hn::Mask<DI> chosen, std::vector<TriangleBox>& boxes)
{
    const DI d;
    constexpr std::size_t kMaxLanes = hn::MaxLanes(d);
    HWY_ALIGN std::int32_t lane[kMaxLanes], x0[kMaxLanes], y0[kMaxLanes], x1[kMaxLanes], y1[kMaxLanes],
        faces[kMaxLanes], beside[kMaxLanes];
    const std::size_t count = compressStore(hn::Iota(d, 0), chosen, d, lane);
    if (count == 0) return;
    compressStore(some.x0, chosen, d, x0);
    compressStore(some.y0, chosen, d, y0);
    compressStore(some.x1, chosen, d, x1);
    compressStore(some.y1, chosen, d, y1);
    compressStore(some.facing, chosen, d, faces);
    compressStore(some.beside, chosen, d, beside);
    for (std::size_t k = 0; k < count; ++k)
        boxes.push_back({std::uint32_t(first) + std::uint32_t(lane[k]), x0[k], y0[k], x1[k], y1[k],
                         std::int16_t(faces[k]), std::int16_t(beside[k])});
}

void setUpRange(const SceneArrays& arrays, const ScreenVertices& screen, std::size_t begin, std::size_t end,
                const Extent& scissor, int margin, const TriangleFinds& out)
{
    const DI d;
    const DF df;
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
        const Corners corner[3] = {cornersAt(screen, hn::BitCast(d, a)), cornersAt(screen, hn::BitCast(d, b)),
                                   cornersAt(screen, hn::BitCast(d, c))};
        const VI left = hn::Min(corner[0].x, hn::Min(corner[1].x, corner[2].x)),
                 top = hn::Min(corner[0].y, hn::Min(corner[1].y, corner[2].y)),
                 right = hn::Max(corner[0].x, hn::Max(corner[1].x, corner[2].x)),
                 bottom = hn::Max(corner[0].y, hn::Max(corner[1].y, corner[2].y));
        const auto first = [&](VI v, int edge) { return hn::Max(firstPixel(v), hn::Set(d, edge)); };
        const auto past = [&](VI v, int edge) { return hn::Min(pastLastPixel(v), hn::Set(d, edge)); };
        Boxes boxes;
        boxes.x0 = first(left, scissor.x0), boxes.y0 = first(top, scissor.y0);
        boxes.x1 = past(right, scissor.x1), boxes.y1 = past(bottom, scissor.y1);
        const VI beside = hn::Set(d, margin);
        const VI widerX0 = first(hn::Sub(left, beside), scissor.x0), widerY0 = first(hn::Sub(top, beside), scissor.y0);
        const VI widerX1 = past(hn::Add(right, beside), scissor.x1),
                 widerY1 = past(hn::Add(bottom, beside), scissor.y1);
        const auto isSafe = hn::Ne(left, hn::Set(d, kUnsafe));
        // Lanes seen in the previous vector (after stepping back) or past a short range do not count again.
        const VI lane = hn::Add(hn::Iota(d, 0), hn::Set(d, std::int32_t(at) - std::int32_t(i)));
        const auto fresh = hn::AndNot(hn::Lt(lane, hn::Zero(d)), hn::Lt(lane, hn::Set(d, std::int32_t(end - i))));
        const auto counts = hn::And(fresh, isSafe);
        if (HWY_UNLIKELY(!hn::AllTrue(d, hn::Or(isSafe, hn::Not(fresh))))) {
            HWY_ALIGN std::int32_t raw[kMaxLanes];
            hn::Store(hn::IfThenElseZero(hn::AndNot(isSafe, fresh), hn::Set(d, 1)), d, raw);
            for (std::size_t k = 0; k < lanes; ++k)
                if (raw[k]) out.unsafe.push_back(std::uint32_t(at + k));
        }
        const auto covers = hn::And(hn::Lt(boxes.x0, boxes.x1), hn::Lt(boxes.y0, boxes.y1));
        const auto mayCover = hn::And(counts, covers);
        const auto coversWider = hn::And(hn::Lt(widerX0, widerX1), hn::Lt(widerY0, widerY1));
        const auto between = hn::And(counts, hn::AndNot(covers, coversWider));
        if (!hn::AllFalse(d, between)) markBits(between, at, out.between);
        if (hn::AllFalse(d, mayCover)) continue;
        const auto difference = [&](VI p, VI q) { return hn::ConvertTo(df, hn::Sub(p, q)); };
        const auto clockwise =
            hn::Gt(hn::Mul(difference(corner[1].x, corner[0].x), difference(corner[2].y, corner[0].y)),
                   hn::Mul(difference(corner[1].y, corner[0].y), difference(corner[2].x, corner[0].x)));
        boxes.facing = hn::IfThenElseZero(hn::RebindMask(d, clockwise), hn::Set(d, 1));
        const auto side = [&](VI more, VI less, int bit) {
            return hn::IfThenElseZero(hn::Gt(more, less), hn::Set(d, bit));
        };
        boxes.beside =
            hn::Or(hn::Or(side(boxes.x0, widerX0, TriangleBox::kLeft), side(boxes.y0, widerY0, TriangleBox::kTop)),
                   hn::Or(side(widerX1, boxes.x1, TriangleBox::kRight), side(widerY1, boxes.y1, TriangleBox::kBottom)));
        appendBoxes(boxes, at, mayCover, out.boxes);
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
