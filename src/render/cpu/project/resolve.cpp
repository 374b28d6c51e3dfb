#include "render/cpu/project/resolve.h"

#include <limits>

#include "render/cpu/project/field_lookup.h"
#include "render/cpu/simd/prefetch.h"

#ifndef AEOLIC_RENDER_CPU_RESOLVE_PARTS
#define AEOLIC_RENDER_CPU_RESOLVE_PARTS
namespace aeolic::cpu {
namespace {

/// The images that a pass over the pixels fills in; null for those that another pass fills.
struct ResolveParts {
    GBuffer* surface;
    Image<std::uint32_t>* flow;
    Image<float>* scalar;
    Image<std::uint32_t>* masked;            ///< Where there is a mask, of a brick's pixels.
    Image<std::uint8_t>* colors;             ///< Where the scene has several kinds.
    bool sampled;                            ///< Vectors, and scalars of the field; else no flow.
    bool field = true;                       ///< What the field has; else only what surfaces carry.
    bool mixed = false;                      ///< Some of several surfaces carry what others are sampled for.
    const std::uint32_t* inBrick = nullptr;  ///< [triangles], 0 for those whose pixels all are other bricks'.

    /// The images lie where a frame ago they were written, in no cache that is near; stores would wait for each line.
    AEOLIC_PREFETCH void prefetchRow(int x0, int x1, int y) const
    {
        prefetchRowToWrite(*flow, x0, x1, y);
        if (scalar) prefetchRowToWrite(*scalar, x0, x1, y);
        if (!surface) return;
        for (const Image<float>* image : {&surface->invDepth, &surface->gradX, &surface->gradY, &surface->light})
            prefetchRowToWrite(*image, x0, x1, y);
    }
};

}  // namespace
}  // namespace aeolic::cpu
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/project/resolve.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/project/flow_vectors-inl.h"
#include "render/cpu/project/lines_ahead-inl.h"
#include "render/cpu/project/noise_sampling-inl.h"
#include "render/cpu/project/surface_hit-inl.h"
#include "render/cpu/simd/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE void storeNothing(const ResolveParts& parts, int x, int y)
{
    const DF d;
    if (parts.surface) hn::StoreU(hn::Zero(d), d, &parts.surface->invDepth.at(x, y));
    if (!parts.surface && parts.scalar) hn::StoreU(hn::NaN(d), d, &parts.scalar->at(x, y));
    if (parts.masked) hn::StoreU(hn::Zero(DU()), DU(), &parts.masked->at(x, y));
    hn::StoreU(hn::Zero(DU()), DU(), &parts.flow->at(x, y));
}

// Whether no streaks show: the vector is shorter than the user's mask.
HWY_INLINE MF isMasked(const Sampled& sampled, const View& view)
{
    const VF length = hn::Sqrt(dot(sampled.vector, sampled.vector));
    return hn::And(sampled.hasVector, hn::Lt(length, hn::Set(DF(), view.maskBelow)));
}

// Which colours the pixels have: their mark without what it tells of streaks.
HWY_INLINE void storeColors(const Hit& hit, std::uint8_t* out)
{
    const DI di;
    const hn::Rebind<std::uint8_t, DI> d8;
    const VI mark = hn::And(hn::ConvertTo(di, hit.mark), hn::Set(di, surface_mark::kMostKinds - 1));
    hn::StoreU(hn::DemoteTo(d8, mark), d8, out);
}

// A vector of pixels on its way: where its rays meet the surface, and the field's cells there.
struct Found {
    Hit hit;
    V3 local;
    Cell<DF> cell;
    VF xs, ys;
    bool any;  // A pixel of these parts is among them.
};

// While one row of a tile is finished the next is found, and the field's samples there are asked for: those of a large
// field come from memory. find(x, y, Found&), finish(x, y, Found).
template <class Find, class Finish>
HWY_INLINE void resolveInTurn(const Extent& tile, const ResolveParts& parts, LinesAhead& ahead, const Find& find,
                              const Finish& finish)
{
    constexpr int kLanes = int(hn::MaxLanes(DF()));
    static_assert(TileKeys::kSize <= int(LinesAhead::kMostCells));
    Found rows[2][TileKeys::kSize / kLanes];
    for (int y = tile.y0 - 1; y < tile.y1; ++y) {
        const bool hasNow = y >= tile.y0, hasNext = y + 1 < tile.y1;
        Found* const now = rows[y & 1];
        Found* const next = rows[(y + 1) & 1];
        if (hasNext) parts.prefetchRow(tile.x0, tile.x1, y + 1);
        for (int x = tile.x0, i = 0; x < tile.x1; x += kLanes, ++i) {
            if (hasNext) find(x, y + 1, next[i]);
            ahead.askForSome();
            if (hasNow) finish(x, y, now[i]);
        }
        ahead.askForAll();
    }
}

void resolveRows(const TileKeys& keys, const Extent& tile, const SceneArrays& arrays, const View& view,
                 const NoisePyramid& noise, const FieldLookup* field, const FieldLookup* scalarField,
                 const ResolveParts& parts)
{
    const DF d;
    const DI di;
    const DU du;
    const VF inverseFocal = hn::Set(d, 1.0f / view.focalPx), one = hn::Set(d, 1.0f);
    const V3 forward = broadcast(d, view.forward), eye = broadcast(d, view.eyeLocal),
             softLight = broadcast(d, view.softLight);
    const auto none = [&](hn::Vec<DU> some) { return hn::AllFalse(du, hn::Ne(some, hn::Zero(du))); };
    LinesAhead ahead(field);
    const auto find = [&](int x, int y, Found& found) AEOLIC_INLINE {
        const auto* words = reinterpret_cast<const std::uint32_t*>(&keys.key[y - tile.y0][x - tile.x0]);
        hn::Vec<DU> complement, depthBits;
        hn::LoadInterleaved2(du, words, complement, depthBits);
        found.any = !none(depthBits);
        if (!found.any) return;
        const auto hasKey = hn::Ne(depthBits, hn::Zero(du));
        const MF covered = hn::RebindMask(d, hasKey);
        const VI triangle = hn::BitCast(di, hn::IfThenElseZero(hasKey, hn::Not(complement)));
        if (parts.inBrick) {
            found.any = !none(hn::IfThenElseZero(hasKey, hn::GatherIndex(du, parts.inBrick, triangle)));
            if (!found.any) return;
        }
        found.xs = hn::Mul(
            hn::Sub(hn::ConvertTo(d, hn::Add(hn::Iota(di, 0), hn::Set(di, x))), hn::Set(d, view.centerX - 0.5f)),
            inverseFocal);
        found.ys = hn::Mul(hn::Set(d, float(y) + 0.5f - view.centerY), inverseFocal);
        ahead.askForSome();
        found.hit = intersect(triangle, covered, found.xs, found.ys, arrays, view);
        const V3& fromEye = found.hit.fromEye;
        found.local = {hn::Add(fromEye.x, eye.x), hn::Add(fromEye.y, eye.y), hn::Add(fromEye.z, eye.z)};
        if (!field) return;
        found.cell = findCell(d, *field, found.local, covered);
        if (!parts.surface) found.any = !hn::AllFalse(d, found.cell.inside);  // Else all in other ranks' bricks.
        if (parts.sampled && found.any) ahead.add(*field, found.cell);
    };
    const auto finish = [&](int x, int y, const Found& found) AEOLIC_INLINE {
        if (!found.any) {
            storeNothing(parts, x, y);
            return;
        }
        const Hit& hit = found.hit;
        const VF depth = hn::Max(dot(hit.fromEye, forward), hn::Set(d, float(view.nearDepth)));
        const VF invDepth = hn::Div(one, depth);
        const V3 normal = shadingNormal(hit);
        ahead.askForSome();
        const VF facing = facingOf(normal, hit);
        const VF faces = hn::Abs(facing);
        const auto keep = [&](VF v) { return hn::IfThenElseZero(hit.covered, v); };

        MF masked = hn::MaskFromVec(hn::Zero(d));
        if (parts.sampled) {
            Sampled sampled =
                sampleData(hit, normal, found.local, found.cell, arrays, field, scalarField, parts.mixed, view);
            ahead.askForSome();
            if (!parts.surface) sampled.hasVector = hn::And(sampled.hasVector, found.cell.inside);
            if (view.maskBelow > 0) masked = isMasked(sampled, view);
            if (!parts.surface && parts.mixed)  // Pixels of own vectors were masked in the surface's pass.
                masked = hn::AndNot(isMarked(hit, surface_mark::kOwnVectors), masked);
            if (parts.masked)
                hn::StoreU(hn::IfThenElseZero(hn::RebindMask(du, masked), hn::Set(du, 1u)), du,
                           &parts.masked->at(x, y));
            const V3 tangent = tangentOf(sampled, normal), step = tangentialStep(tangent, view);
            // The footprint grows with foreshortening, by the geometric mean of its two sides; beyond 16:1 no further.
            const VF footprint = hn::Div(hn::Mul(depth, inverseFocal), hn::Sqrt(hn::Max(faces, hn::Set(d, 1.0f / 16))));
            VF grain = sampleNoise(d, noise, view.noise, found.local, footprint);
            if (view.fadePerVector > 0) grain = faded(grain, tangent, view);
            hn::StoreU(packFlow(step, found.xs, found.ys, invDepth, grain, sampled.hasVector, view), du,
                       &parts.flow->at(x, y));
            if (parts.scalar)
                hn::StoreU(parts.surface ? keep(sampled.scalar)
                                         : hn::IfThenElse(found.cell.inside, sampled.scalar, hn::NaN(d)),
                           d, &parts.scalar->at(x, y));
        } else {
            hn::StoreU(hn::Zero(du), du, &parts.flow->at(x, y));
            if (parts.scalar) hn::StoreU(keep(surfaceScalar(hit, *arrays.scene)), d, &parts.scalar->at(x, y));
        }
        if (!parts.surface) return;
        GBuffer& out = *parts.surface;
        if (parts.colors) storeColors(hit, &parts.colors->at(x, y));
        const DepthGradient gradient = depthGradient(hit, view);
        hn::StoreU(keep(invDepth), d, &out.invDepth.at(x, y));
        hn::StoreU(keep(gradient.x), d, &out.gradX.at(x, y));
        hn::StoreU(keep(gradient.y), d, &out.gradY.at(x, y));
        masked = hn::Or(masked, withoutStreaks(hit));
        const VF light = lightOn(normal, facing, softLight);
        hn::StoreU(keep(hn::IfThenElse(masked, hn::Neg(light), light)), d, &out.light.at(x, y));
    };
    resolveInTurn(tile, parts, ahead, find, finish);
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
    const bool hasField = scene.field && parts.field, hasScalarField = scene.scalarField && parts.field;
    FieldLookup field, scalarField;
    if (hasField) field = makeFieldLookup(*scene.field, scene.surface.originWorld, view.unitWorld);
    if (hasScalarField) scalarField = makeFieldLookup(*scene.scalarField, scene.surface.originWorld, view.unitWorld);
    HWY_DYNAMIC_DISPATCH(resolveRows)
    (keys, tile, arrays, view, noise, hasField ? &field : nullptr, hasScalarField ? &scalarField : nullptr, parts);
}

}  // namespace

void resolveTile(const TileKeys& keys, const Extent& tile, const SceneArrays& arrays, const View& view,
                 const NoisePyramid& noise, GBuffer& out)
{
    const Scene& scene = *arrays.scene;
    const bool field = !scene.bricked() || scene.inPieces, mixed = scene.mixed();
    resolve(keys, tile, arrays, view, noise,
            ResolveParts{&out, &out.flow, scene.hasScalar ? &out.scalar : nullptr, nullptr,
                         scene.surfaces.empty() ? nullptr : &out.colors, field || mixed, field, mixed});
}

void resolveBrickTile(const TileKeys& keys, const Extent& tile, const SceneArrays& arrays,
                      const std::vector<std::uint32_t>& inBrick, const View& view, const NoisePyramid& noise,
                      FieldPixels& out)
{
    resolve(keys, tile, arrays, view, noise,
            ResolveParts{nullptr, &out.flow, arrays.scene->scalarFromField() ? &out.scalar : nullptr,
                         view.maskBelow > 0 ? &out.masked : nullptr, nullptr, true, true, arrays.scene->mixed(),
                         inBrick.data()});
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

void clearBrickTile(const Extent& tile, FieldPixels& out)
{
    const bool withScalar = out.scalar.valid() == out.flow.valid(), withMask = out.masked.valid() == out.flow.valid();
    out.flow.fill(tile, 0);
    if (withMask) out.masked.fill(tile, 0);
    if (withScalar) out.scalar.fill(tile, std::numeric_limits<float>::quiet_NaN());
}

}  // namespace aeolic::cpu
#endif
