#include "render/cpu/resolve.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "render/cpu/field_lookup.h"
#include "render/shading_model.h"

#ifndef AEOLIC_RENDER_CPU_RESOLVE_PARTS
#define AEOLIC_RENDER_CPU_RESOLVE_PARTS
namespace aeolic::cpu {
namespace {

/// What a pass over the pixels fills in: images, or null for what is not its part.
struct ResolveParts {
    GBuffer* surface;
    Image<std::uint32_t>* flow;
    Image<float>* scalar;
    bool sampled;  ///< Vectors, and scalars of the field; else no flow.
};

}  // namespace
}  // namespace aeolic::cpu
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/resolve.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/field_sampling-inl.h"
#include "render/cpu/noise_sampling-inl.h"
#include "render/cpu/simd-inl.h"
#include "render/cpu/surface_hit-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using V3 = Vec3v<VF>;

struct Sampled {
    V3 vector;
    VF scalar;
    MF hasVector;
};

// The point's or triangle's scalar; NaN where what is coloured by is in the field.
HWY_INLINE VF surfaceScalar(const Hit& hit, const Scene& scene)
{
    const DF d;
    if (!scene.surface.cellScalars.empty()) return hn::GatherIndex(d, scene.surface.cellScalars.data(), hit.triangle);
    return scene.surface.pointScalars.empty() ? hn::NaN(d) : hit.scalar;
}

// Vector and scalar of each pixel, from the 3D field at its position (in `cell`) or from the surface's own arrays.
HWY_INLINE Sampled sampleData(const Hit& hit, const V3& local, const Cell<DF>& cell, const SceneArrays& arrays,
                              const FieldLookup* field, const FieldLookup* scalarField)
{
    const DF d;
    const Scene& scene = *arrays.scene;
    Sampled s;
    s.hasVector = hit.covered;
    const VI cellIndex = hn::Add(hn::Add(hit.triangle, hit.triangle), hit.triangle);
    if (field) {
        s.vector = sampleVector(d, *field, cell);
        s.hasVector = cell.inside;
    } else if (!scene.surface.cellVectors.empty()) {
        s.vector = gather3(&scene.surface.cellVectors[0].x, cellIndex);
    } else {
        const CornerBlocks vectors = loadCorners(arrays, hit.vertex, 2);
        const auto blend = [&](auto member) { return interpolate(member(0), member(1), member(2), hit.u, hit.v); };
        s.vector = {blend([&](int k) { return vectors.corner[k].a; }),
                    blend([&](int k) { return vectors.corner[k].b; }),
                    blend([&](int k) { return vectors.corner[k].c; })};
    }
    // NaN marks a masked sample; it differs from itself.
    const VF sum = hn::Add(s.vector.x, hn::Add(s.vector.y, s.vector.z));
    s.hasVector = hn::And(s.hasVector, hn::Eq(sum, sum));

    if (scene.colorByFieldMagnitude) {
        s.scalar = hn::IfThenElse(s.hasVector, hn::Sqrt(dot(s.vector, s.vector)), hn::NaN(d));
    } else if (scalarField) {
        const auto scalarCell = findCell(d, *scalarField, local, hit.covered);
        s.scalar = hn::IfThenElse(scalarCell.inside, sampleScalar(d, *scalarField, scalarCell), hn::NaN(d));
    } else {
        s.scalar = surfaceScalar(hit, scene);
    }
    return s;
}

// Removes the normal component and gives the vector its length in P-space (paper, section 3: "it has to be made
// tangential").
HWY_INLINE V3 tangentialStep(const Sampled& s, const V3& normal, const View& view)
{
    const DF d;
    const VF zero = hn::Zero(d);
    const V3 v{hn::IfThenElse(s.hasVector, s.vector.x, zero), hn::IfThenElse(s.hasVector, s.vector.y, zero),
               hn::IfThenElse(s.hasVector, s.vector.z, zero)};
    const V3 tangent = mulAdd(normal, hn::Neg(dot(normal, v)), v);
    if (!view.normalize) return scale(tangent, hn::Set(d, view.vectorScale));
    const VF length = hn::Sqrt(dot(tangent, tangent));
    const auto usable = hn::Gt(length, hn::Set(d, view.tinyVector));
    return scale(tangent, hn::IfThenElseZero(usable, hn::Div(hn::Set(d, view.stepWorld), length)));
}

// Packs displacement (exact perspective projection of the tangent vector, in pixels per step) and noise into a texel.
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
    const VI level = hn::Add(hn::NearestInt(hn::Mul(noise, hn::Set(d, 127.0f))), hn::Set(di, flow_texel::kNoiseZero));
    const VI noiseByte = hn::Min(hn::Max(level, hn::Set(di, 1)), hn::Set(di, 255));
    const VI packed = hn::Or(hn::ShiftLeft<20>(quantise(dx)),
                             hn::Or(hn::ShiftLeft<8>(hn::And(quantise(dy), hn::Set(di, 0xFFF))), noiseByte));
    return hn::IfThenElseZero(hn::RebindMask(du, hasVector), hn::BitCast(du, packed));
}

HWY_INLINE void storeNothing(const ResolveParts& parts, int x, int y)
{
    const DF d;
    if (parts.surface) hn::StoreU(hn::Zero(d), d, &parts.surface->invDepth.at(x, y));
    if (!parts.surface && parts.scalar) hn::StoreU(hn::NaN(d), d, &parts.scalar->at(x, y));
    hn::StoreU(hn::Zero(DU()), DU(), &parts.flow->at(x, y));
}

void resolveRows(const TileKeys& keys, const Extent& tile, const SceneArrays& arrays, const View& view,
                 const NoisePyramid& noise, const FieldLookup* field, const FieldLookup* scalarField,
                 const ResolveParts& parts)
{
    const DF d;
    const DI di;
    const DU du;
    const VF inverseFocal = hn::Set(d, 1.0f / view.focalPx), one = hn::Set(d, 1.0f);
    const V3 right = broadcast(d, view.right), up = broadcast(d, view.up), forward = broadcast(d, view.forward),
             eye = broadcast(d, view.eyeLocal);
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; x += int(hn::Lanes(d))) {
            const auto* words = reinterpret_cast<const std::uint32_t*>(&keys.key[y - tile.y0][x - tile.x0]);
            hn::Vec<DU> complement, depthBits;
            hn::LoadInterleaved2(du, words, complement, depthBits);
            const auto hasKey = hn::Ne(depthBits, hn::Zero(du));
            const MF covered = hn::RebindMask(d, hasKey);
            if (hn::AllFalse(du, hasKey)) {
                storeNothing(parts, x, y);
                continue;
            }
            const VI triangle = hn::BitCast(di, hn::IfThenElseZero(hasKey, hn::Not(complement)));
            const VF xs = hn::Mul(
                hn::Sub(hn::ConvertTo(d, hn::Add(hn::Iota(di, 0), hn::Set(di, x))), hn::Set(d, view.centerX - 0.5f)),
                inverseFocal);
            const VF ys = hn::Mul(hn::Set(d, float(y) + 0.5f - view.centerY), inverseFocal);

            const Hit hit = intersect(triangle, covered, xs, ys, arrays, view);
            const V3 local{hn::Add(hit.fromEye.x, eye.x), hn::Add(hit.fromEye.y, eye.y), hn::Add(hit.fromEye.z, eye.z)};
            Cell<DF> cell{};
            if (field) cell = findCell(d, *field, local, covered);
            if (!parts.surface && hn::AllFalse(d, cell.inside)) {  // All in other ranks' bricks.
                storeNothing(parts, x, y);
                continue;
            }
            const VF depth = hn::Max(dot(hit.fromEye, forward), hn::Set(d, float(view.camera.nearDepth)));
            const VF invDepth = hn::Div(one, depth);
            const V3 normal = shadingNormal(hit);
            const VF facing =
                hn::Abs(hn::Mul(dot(normal, hit.fromEye), inverseLength(d, dot(hit.fromEye, hit.fromEye))));
            const auto keep = [&](VF v) { return hn::IfThenElseZero(covered, v); };

            if (parts.sampled) {
                const Sampled sampled = sampleData(hit, local, cell, arrays, field, scalarField);
                const V3 step = tangentialStep(sampled, normal, view);
                // The footprint grows with foreshortening, by the geometric mean of its two sides; beyond 16:1 no
                // further.
                const VF footprint =
                    hn::Div(hn::Mul(depth, inverseFocal), hn::Sqrt(hn::Max(facing, hn::Set(d, 1.0f / 16))));
                const VF grain = sampleNoise(d, noise, view.noise, local, footprint);
                hn::StoreU(packFlow(step, xs, ys, invDepth, grain, sampled.hasVector, view), du, &parts.flow->at(x, y));
                if (parts.scalar)
                    hn::StoreU(
                        parts.surface ? keep(sampled.scalar) : hn::IfThenElse(cell.inside, sampled.scalar, hn::NaN(d)),
                        d, &parts.scalar->at(x, y));
            } else {
                hn::StoreU(hn::Zero(du), du, &parts.flow->at(x, y));
                if (parts.scalar) hn::StoreU(keep(surfaceScalar(hit, *arrays.scene)), d, &parts.scalar->at(x, y));
            }
            if (!parts.surface) continue;
            GBuffer& out = *parts.surface;
            const VF perPixel = hn::Mul(inverseFocal, hn::Div(one, hn::IfThenElse(hn::Eq(hit.facetOffset, hn::Zero(d)),
                                                                                  hn::Inf(d), hit.facetOffset)));
            hn::StoreU(keep(invDepth), d, &out.invDepth.at(x, y));
            hn::StoreU(keep(hn::Mul(dot(hit.facetNormal, right), perPixel)), d, &out.gradX.at(x, y));
            hn::StoreU(keep(hn::Neg(hn::Mul(dot(hit.facetNormal, up), perPixel))), d, &out.gradY.at(x, y));
            hn::StoreU(keep(hn::MulAdd(hn::Set(d, shading::kDiffuse), facing, hn::Set(d, shading::kAmbient))), d,
                       &out.light.at(x, y));
        }
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(resolveRows);

namespace {

void resolve(const TileKeys& keys, const Extent& tile, const SceneArrays& arrays, const View& view,
             const NoisePyramid& noise, const ResolveParts& parts)
{
    const Scene& scene = *arrays.scene;
    FieldLookup field, scalarField;
    if (scene.field) field = makeFieldLookup(*scene.field, scene.surface.originWorld);
    if (scene.scalarField) scalarField = makeFieldLookup(*scene.scalarField, scene.surface.originWorld);
    HWY_DYNAMIC_DISPATCH(resolveRows)
    (keys, tile, arrays, view, noise, scene.field ? &field : nullptr, scene.scalarField ? &scalarField : nullptr,
     parts);
}

}  // namespace

void resolveTile(const TileKeys& keys, const Extent& tile, const SceneArrays& arrays, const View& view,
                 const NoisePyramid& noise, GBuffer& out)
{
    const Scene& scene = *arrays.scene;
    resolve(keys, tile, arrays, view, noise,
            ResolveParts{&out, &out.flow, scene.hasScalar ? &out.scalar : nullptr, !scene.bricked() || scene.inPieces});
}

void resolveBrickTile(const TileKeys& keys, const Extent& tile, const SceneArrays& arrays, const View& view,
                      const NoisePyramid& noise, FieldPixels& out)
{
    resolve(keys, tile, arrays, view, noise,
            ResolveParts{nullptr, &out.flow, arrays.scene->scalarFromField() ? &out.scalar : nullptr, true});
}

void copyKeys(const TileKeys& keys, const Extent& tile, const std::vector<std::uint64_t>& order, SurfacePixels& out)
{
    for (int y = tile.y0; y < tile.y1; ++y) {
        std::uint32_t* depth = out.depth.row(y);
        std::uint64_t* place = out.order.row(y);
        for (int x = tile.x0; x < tile.x1; ++x) {
            const std::uint64_t key = keys.key[y - tile.y0][x - tile.x0];
            depth[x] = std::uint32_t(key >> 32);
            if (key != 0) place[x] = order[TileKeys::triangle(key)];
        }
    }
}

void clearKeys(const Extent& tile, SurfacePixels& out)
{
    for (int y = tile.y0; y < tile.y1; ++y)
        std::memset(&out.depth.at(tile.x0, y), 0, std::size_t(tile.width()) * sizeof(std::uint32_t));
}

void clearTile(const Extent& tile, GBuffer& out)
{
    // Background needs only what the later stages test; the other images are never read there.
    for (int y = tile.y0; y < tile.y1; ++y) {
        std::memset(&out.invDepth.at(tile.x0, y), 0, std::size_t(tile.width()) * sizeof(float));
        std::memset(&out.flow.at(tile.x0, y), 0, std::size_t(tile.width()) * sizeof(std::uint32_t));
    }
}

void clearBrickTile(const Extent& tile, FieldPixels& out)
{
    const bool withScalar = out.scalar.valid() == out.flow.valid();
    for (int y = tile.y0; y < tile.y1; ++y) {
        std::memset(&out.flow.at(tile.x0, y), 0, std::size_t(tile.width()) * sizeof(std::uint32_t));
        if (withScalar) std::fill_n(&out.scalar.at(tile.x0, y), tile.width(), std::numeric_limits<float>::quiet_NaN());
    }
}

}  // namespace aeolic::cpu
#endif
