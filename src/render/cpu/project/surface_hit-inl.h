// Per-target include (Highway compiles it once per target): where pixels' rays meet their triangles.

#if defined(AEOLIC_RENDER_CPU_SURFACE_HIT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_SURFACE_HIT_INL_H
#undef AEOLIC_RENDER_CPU_SURFACE_HIT_INL_H
#else
#define AEOLIC_RENDER_CPU_SURFACE_HIT_INL_H
#endif

#include <hwy/highway.h>

#include "render/cpu/project/scene_arrays.h"
#include "render/cpu/simd/simd-inl.h"
#include "render/shading_model.h"
#include "render/view.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Where in its triangle each lane's pixel lies.
struct Hit {
    VI triangle, vertex[3];  ///< Indices, all 0 in uncovered lanes; those of vertices in 128-bit blocks.
    VF u, v;                 ///< Weights of corners 1 and 2.
    Vec3v<VF> fromEye;       ///< P-space position relative to the eye.
    Vec3v<VF> facetNormal;   ///< Not normalised.
    VF facetOffset;          ///< facetNormal . (corner 0 - eye)
    Vec3v<VF> smoothNormal;  ///< Interpolated, not normalised.
    VF scalar;               ///< The points' scalar.
    VF mark;                 ///< surface_mark.h
    MF covered;
};

HWY_INLINE Vec3v<VF> gather3(const float* base, VI index)
{
    const DF d;
    return {hn::GatherIndex(d, base, index), hn::GatherIndex(d, base + 1, index), hn::GatherIndex(d, base + 2, index)};
}

/// Block `block` of each corner's VertexRecord.
struct CornerBlocks {
    Block4<VF> corner[3];
};
HWY_INLINE CornerBlocks loadCorners(const SceneArrays& arrays, const VI (&vertex)[3], int block)
{
    const DF d;
    const float* base = arrays.vertices[0].position + 4 * block;
    return {{loadBlocks<4>(d, base, vertex[0]), loadBlocks<4>(d, base, vertex[1]), loadBlocks<4>(d, base, vertex[2])}};
}
HWY_INLINE VF interpolate(VF a, VF b, VF c, VF u, VF v)
{
    return hn::MulAdd(hn::Sub(c, a), v, hn::MulAdd(hn::Sub(b, a), u, a));
}

/// The ray through the pixel's centre against its triangle's plane (Möller & Trumbore 1997), kept inside the triangle.
HWY_INLINE Hit intersect(VI triangle, MF covered, VF xs, VF ys, const SceneArrays& arrays, const View& view)
{
    const DF d;
    const DI di;
    Hit hit;
    hit.covered = covered;
    hit.triangle = triangle;
    const auto corners = loadBlocks<4>(DU(), arrays.corners[0].data(), triangle);
    hit.vertex[0] = hn::BitCast(di, corners.a);
    hit.vertex[1] = hn::BitCast(di, corners.b);
    hit.vertex[2] = hn::BitCast(di, corners.c);
    const CornerBlocks place = loadCorners(arrays, hit.vertex, 0), rest = loadCorners(arrays, hit.vertex, 1);
    const auto position = [&](int k) { return Vec3v<VF>{place.corner[k].a, place.corner[k].b, place.corner[k].c}; };
    const Vec3v<VF> p0 = position(0), e1 = sub(position(1), p0), e2 = sub(position(2), p0);
    const Vec3v<VF> ray =
        mulAdd(broadcast(d, view.right), xs, mulAdd(broadcast(d, -view.up), ys, broadcast(d, view.forward)));
    const Vec3v<VF> toEye = sub(broadcast(d, view.eyeLocal), p0);
    const Vec3v<VF> p = cross(ray, e2), q = cross(toEye, e1);
    const VF determinant = dot(e1, p);
    const VF zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const auto edgeOn = hn::Eq(determinant, zero);
    const VF inverse = hn::Div(one, hn::IfThenElse(edgeOn, one, determinant));
    // Pixels of clamped or edge-on triangles land on the nearest point of the triangle rather than anywhere on its
    // plane.
    hit.u = hn::Min(hn::Max(hn::Mul(dot(toEye, p), inverse), zero), one);
    hit.v = hn::Min(hn::Max(hn::Mul(dot(ray, q), inverse), zero), hn::Sub(one, hit.u));
    hit.fromEye = sub(mulAdd(e2, hit.v, mulAdd(e1, hit.u, p0)), broadcast(d, view.eyeLocal));
    hit.facetNormal = cross(e1, e2);
    hit.facetOffset = hn::Neg(dot(hit.facetNormal, toEye));
    const auto smooth = [&](auto member) { return interpolate(member(0), member(1), member(2), hit.u, hit.v); };
    hit.smoothNormal = {smooth([&](int k) { return place.corner[k].d; }),
                        smooth([&](int k) { return rest.corner[k].a; }),
                        smooth([&](int k) { return rest.corner[k].b; })};
    hit.scalar = smooth([&](int k) { return rest.corner[k].c; });
    hit.mark = rest.corner[0].d;
    return hit;
}

/// The shading normal: interpolated, unit length; the facet's own where the vertices' cancel.
HWY_INLINE Vec3v<VF> shadingNormal(const Hit& hit)
{
    const DF d;
    const Vec3v<VF>& smooth = hit.smoothNormal;
    const VF length2 = dot(smooth, smooth);
    const auto usable = hn::Gt(length2, hn::Set(d, 1e-8f));
    const Vec3v<VF> n{hn::IfThenElse(usable, smooth.x, hit.facetNormal.x),
                      hn::IfThenElse(usable, smooth.y, hit.facetNormal.y),
                      hn::IfThenElse(usable, smooth.z, hit.facetNormal.z)};
    const VF tiny = hn::Set(d, 1e-36f);
    return scale(n, inverseLength(d, hn::Max(dot(n, n), tiny)));
}

/// Change of 1/depth per pixel to the right and downwards on the hit's own facet.
struct DepthGradient {
    VF x, y;
};
HWY_INLINE DepthGradient depthGradient(const Hit& hit, const View& view)
{
    const DF d;
    const VF offset = hn::IfThenElse(hn::Eq(hit.facetOffset, hn::Zero(d)), hn::Inf(d), hit.facetOffset);
    const VF perPixel = hn::Mul(hn::Set(d, 1.0f / view.focalPx), hn::Div(hn::Set(d, 1.0f), offset));
    return {hn::Mul(dot(hit.facetNormal, broadcast(d, view.right)), perPixel),
            hn::Neg(hn::Mul(dot(hit.facetNormal, broadcast(d, view.up)), perPixel))};
}

/// The cosine between the shading normal and the way to the eye.
HWY_INLINE VF facingOf(const Vec3v<VF>& normal, const Hit& hit)
{
    return hn::Neg(hn::Mul(dot(normal, hit.fromEye), inverseLength(DF(), dot(hit.fromEye, hit.fromEye))));
}

/// shading_model.h's light.
HWY_INLINE VF lightOn(const Vec3v<VF>& normal, VF facing, const Vec3v<VF>& softLight)
{
    const DF d;
    const VF one = hn::Set(d, 1.0f);
    const VF side = hn::Min(hn::Max(hn::Mul(hn::Set(d, shading::kSoftTurn), facing), hn::Neg(one)), one);
    const VF even = hn::Set(d, shading::kAmbient + 0.5f * shading::kSoft);
    const VF headlight = hn::MulAdd(hn::Set(d, shading::kDiffuse), hn::Abs(facing), even);
    const VF soft = hn::Mul(hn::Mul(side, dot(normal, softLight)), hn::Set(d, 0.5f * shading::kSoft));
    return hn::Add(headlight, soft);
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
