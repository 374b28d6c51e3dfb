// Per-target include (Highway compiles it once per target): from data at a pixel's place to its texel of flow.

#if defined(AEOLIC_RENDER_CPU_FLOW_VECTORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_FLOW_VECTORS_INL_H
#undef AEOLIC_RENDER_CPU_FLOW_VECTORS_INL_H
#else
#define AEOLIC_RENDER_CPU_FLOW_VECTORS_INL_H
#endif

#include <hwy/highway.h>

#include "render/cpu/project/field_sampling-inl.h"
#include "render/cpu/project/surface_hit-inl.h"
#include "render/cpu/simd/simd-inl.h"
#include "render/surface_mark.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using V3 = Vec3v<VF>;

/// What pixels are drawn from.
struct Sampled {
    V3 vector;
    VF scalar;
    MF hasVector;
};

/// Pixels of surfaces without streaks.
HWY_INLINE MF withoutStreaks(const Hit& hit)
{
    return hn::Ge(hit.mark, hn::Set(DF(), float(surface_mark::kNoStreaks)));
}

/// Pixels whose mark has this bit.
HWY_INLINE MF isMarked(const Hit& hit, int bit)
{
    const DI di;
    return hn::RebindMask(DF(), hn::TestBit(hn::ConvertTo(di, hit.mark), hn::Set(di, bit)));
}

/// The point's or triangle's scalar; NaN where the field has the colours' array.
HWY_INLINE VF surfaceScalar(const Hit& hit, const Scene& scene)
{
    const DF d;
    if (!scene.surface.cellScalars.empty()) return hn::GatherIndex(d, scene.surface.cellScalars.data(), hit.triangle);
    return scene.surface.pointScalars.empty() ? hn::NaN(d) : hit.scalar;
}

/// The point's or triangle's vector.
HWY_INLINE V3 surfaceVector(const Hit& hit, const SceneArrays& arrays)
{
    const Scene& scene = *arrays.scene;
    const VI cellIndex = hn::Add(hn::Add(hit.triangle, hit.triangle), hit.triangle);
    if (!scene.surface.cellVectors.empty()) return gather3(&scene.surface.cellVectors[0].x, cellIndex);
    const CornerBlocks vectors = loadCorners(arrays, hit.vertex, 2);
    const auto blend = [&](auto member) { return interpolate(member(0), member(1), member(2), hit.u, hit.v); };
    return {blend([&](int k) { return vectors.corner[k].a; }), blend([&](int k) { return vectors.corner[k].b; }),
            blend([&](int k) { return vectors.corner[k].c; })};
}

/// In the view's unit, where `known` and not masked.
HWY_INLINE void takeVector(const V3& vector, MF known, const View& view, Sampled& s)
{
    s.vector = scale(vector, hn::Set(DF(), view.vectorFactor));
    // NaN marks a masked sample; it differs from itself.
    const VF sum = hn::Add(s.vector.x, hn::Add(s.vector.y, s.vector.z));
    s.hasVector = hn::And(known, hn::Eq(sum, sum));
}

/// Puts what surfaces carry themselves in the place of what the field has there.
HWY_INLINE void takeOwn(const Hit& hit, const SceneArrays& arrays, const View& view, Sampled& s)
{
    const MF vectors = isMarked(hit, surface_mark::kOwnVectors);
    Sampled own;
    takeVector(surfaceVector(hit, arrays), hit.covered, view, own);
    s.vector = {hn::IfThenElse(vectors, own.vector.x, s.vector.x), hn::IfThenElse(vectors, own.vector.y, s.vector.y),
                hn::IfThenElse(vectors, own.vector.z, s.vector.z)};
    s.hasVector = hn::Or(hn::And(vectors, own.hasVector), hn::AndNot(vectors, s.hasVector));
    s.scalar = hn::IfThenElse(isMarked(hit, surface_mark::kOwnScalar), surfaceScalar(hit, *arrays.scene), s.scalar);
}

/// The part of the vectors that needs the surface's unit normal; NaN where there is none.
HWY_INLINE VF partByNormal(const Sampled& s, const V3& normal, ArrayPart part, const View& view)
{
    const DF d;
    VF value = dot(normal, s.vector);
    if (part == ArrayPart::tangential) {
        const V3 tangent = mulAdd(normal, hn::Neg(value), s.vector);
        value = hn::Sqrt(dot(tangent, tangent));
    }
    return hn::IfThenElse(s.hasVector, hn::Mul(value, hn::Set(d, view.vectorUnit)), hn::NaN(d));
}

/// Vector and scalar of each pixel, from the 3D field at its position (in `cell`) or from the surface's own arrays.
/// Without a field, `mixed`: only the surface's own values. `normal`: the surface's, unit length.
HWY_INLINE Sampled sampleData(const Hit& hit, const V3& normal, const V3& local, const Cell<DF>& cell,
                              const SceneArrays& arrays, const FieldLookup* field, const FieldLookup* scalarField,
                              bool mixed, const View& view)
{
    const DF d;
    const Scene& scene = *arrays.scene;
    Sampled s;
    if (field)
        takeVector(sampleVector(d, *field, cell), cell.inside, view, s);
    else
        takeVector(surfaceVector(hit, arrays),
                   mixed ? hn::And(hit.covered, isMarked(hit, surface_mark::kOwnVectors)) : hit.covered, view, s);
    if (field && scene.ofVectors == ArrayPart::length) {
        s.scalar = hn::IfThenElse(s.hasVector, hn::Mul(hn::Sqrt(dot(s.vector, s.vector)), hn::Set(d, view.vectorUnit)),
                                  hn::NaN(d));
    } else if (scalarField) {
        const auto scalarCell = findCell(d, *scalarField, local, hit.covered);
        s.scalar = hn::IfThenElse(scalarCell.inside, sampleScalar(d, *scalarField, scalarCell), hn::NaN(d));
    } else {
        s.scalar = surfaceScalar(hit, scene);
    }
    if (field && mixed) takeOwn(hit, arrays, view, s);
    if (needsNormal(scene.ofVectors)) {
        const VF value = partByNormal(s, normal, scene.ofVectors, view);
        s.scalar = mixed ? hn::IfThenElse(isMarked(hit, surface_mark::kOwnScalar), s.scalar, value) : value;
    }
    s.hasVector = hn::AndNot(withoutStreaks(hit), s.hasVector);
    return s;
}

/// The vector without its normal component (paper, section 3: "it has to be made tangential").
HWY_INLINE V3 tangentOf(const Sampled& s, const V3& normal)
{
    const VF zero = hn::Zero(DF());
    const V3 v{hn::IfThenElse(s.hasVector, s.vector.x, zero), hn::IfThenElse(s.hasVector, s.vector.y, zero),
               hn::IfThenElse(s.hasVector, s.vector.z, zero)};
    return mulAdd(normal, hn::Neg(dot(normal, v)), v);
}

/// The noise of a pixel, less where the flow along the surface is slow.
HWY_INLINE VF faded(VF noise, const V3& tangent, const View& view)
{
    const DF d;
    const VF part = hn::Mul(hn::Sqrt(dot(tangent, tangent)), hn::Set(d, view.fadePerVector));
    return hn::Mul(noise, hn::Sqrt(hn::Min(part, hn::Set(d, 1.0f))));
}

/// The vector along the surface at its length in P-space.
HWY_INLINE V3 tangentialStep(const V3& tangent, const View& view)
{
    const DF d;
    if (!view.normalize) return scale(tangent, hn::Set(d, view.vectorScale));
    const VF length = hn::Sqrt(dot(tangent, tangent));
    const auto usable = hn::Gt(length, hn::Set(d, view.tinyVector));
    return scale(tangent, hn::IfThenElseZero(usable, hn::Div(hn::Set(d, view.stepLocal), length)));
}

/// Packs displacement (exact perspective projection of the tangent vector, in pixels per step) and noise into a texel.
HWY_INLINE hn::Vec<DU> packFlow(const V3& step, VF xs, VF ys, VF invDepth, VF noise, MF hasVector, const View& view)
{
    const DF d;
    const DI di;
    const DU du;
    const VF pixels = hn::Mul(hn::Set(d, view.focalPx), invDepth);
    const VF along = dot(step, broadcast(d, view.forward));
    VF dx = hn::Mul(pixels, hn::NegMulAdd(xs, along, dot(step, broadcast(d, view.right))));
    VF dy = hn::Neg(hn::Mul(pixels, hn::MulAdd(ys, along, dot(step, broadcast(d, view.up)))));
    const VF length2 = hn::MulAdd(dx, dx, hn::Mul(dy, dy)), limit = hn::Set(d, view.maxStepPx);
    VF toUnits = hn::Set(d, 1.0f / view.flowUnitPx);
    const auto tooLong = hn::Gt(length2, hn::Mul(limit, limit));
    if (HWY_UNLIKELY(!hn::AllFalse(d, tooLong)))
        toUnits =
            hn::Mul(hn::IfThenElse(tooLong, hn::Mul(limit, inverseLength(d, hn::Max(length2, hn::Set(d, 1e-30f)))),
                                   hn::Set(d, 1.0f)),
                    toUnits);
    const auto quantise = [&](VF v) {
        const VI q = hn::NearestInt(hn::Mul(v, toUnits));
        return hn::Min(hn::Max(q, hn::Set(di, -flow_texel::kDisplacementMax)),
                       hn::Set(di, flow_texel::kDisplacementMax));
    };
    const VI level = hn::Add(hn::NearestInt(hn::Mul(noise, hn::Set(d, float(flow_texel::kNoiseMost)))),
                             hn::Set(di, flow_texel::kNoiseZero));
    const VI noiseByte = hn::Min(hn::Max(level, hn::Set(di, 1)), hn::Set(di, 255));
    const VI packed =
        hn::Or(hn::ShiftLeft<flow_texel::kDxShift>(quantise(dx)),
               hn::Or(hn::ShiftLeft<flow_texel::kDyShift>(hn::And(quantise(dy), hn::Set(di, 0xFFF))), noiseByte));
    return hn::IfThenElseZero(hn::RebindMask(du, hasVector), hn::BitCast(du, packed));
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
