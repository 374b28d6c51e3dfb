#include "render/cpu/edges/edge_samples.h"

#include "base/parallel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/edges/edge_samples.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/project/surface_hit-inl.h"
#include "render/cpu/simd/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Samples from `at` on, of which pixels lie at `x` and `y`: a place between pixels is found as their centres are.
HWY_INLINE void resolveSome(std::size_t at, VF x, VF y, const SceneArrays& arrays, const View& view,
                            EdgeSamples& samples)
{
    const DF d;
    const DI di;
    const DU du;
    const auto hasKey = hn::Ne(hn::LoadU(d, samples.drawn.depths() + at), hn::Zero(d));
    if (hn::AllFalse(d, hasKey)) {
        hn::StoreU(hn::Zero(d), d, &samples.invDepth[at]);
        return;
    }
    const VF inverseFocal = hn::Set(d, 1.0f / view.focalPx);
    const VF xs = hn::Mul(hn::Sub(x, hn::Set(d, view.centerX)), inverseFocal),
             ys = hn::Mul(hn::Sub(y, hn::Set(d, view.centerY)), inverseFocal);
    const VI complement = hn::BitCast(di, hn::LoadU(du, samples.drawn.complements() + at));
    const VI triangle = hn::IfThenElseZero(hn::RebindMask(di, hasKey), hn::Not(complement));
    const Hit hit = intersect(triangle, hasKey, xs, ys, arrays, view);
    const VF depth = hn::Max(dot(hit.fromEye, broadcast(d, view.forward)), hn::Set(d, float(view.nearDepth)));
    const Vec3v<VF> normal = shadingNormal(hit);
    const DepthGradient gradient = depthGradient(hit, view);
    const VF invDepth = hn::IfThenElseZero(hit.covered, hn::Div(hn::Set(d, 1.0f), depth));
    hn::StoreU(invDepth, d, &samples.invDepth[at]);
    hn::StoreU(gradient.x, d, &samples.gradX[at]);
    hn::StoreU(gradient.y, d, &samples.gradY[at]);
    hn::StoreU(lightOn(normal, facingOf(normal, hit), broadcast(d, view.softLight)), d, &samples.light[at]);
}

// Prefetches the data of the triangles that every other sample from `at` on shows, as far as there are samples: those
// beside mostly show the same ones. Without branches, which would be foreseen badly: samples of nothing ask for the
// first triangle.
HWY_INLINE void prefetchShown(const SampleKeys& drawn, std::size_t at, std::size_t count, const SceneArrays& arrays)
{
    const std::size_t lanes = hn::Lanes(DF());
    const auto forEach = [&](std::size_t begin, const auto& ask) AEOLIC_INLINE {
        for (std::size_t i = begin; i < std::min(begin + lanes, count); i += 2) {
            ask(drawn.depths()[i] == 0 ? 0 : ~drawn.complements()[i]);
        }
    };
    forEach(at + lanes, [&](std::uint32_t triangle) AEOLIC_INLINE { __builtin_prefetch(&arrays.corners[triangle]); });
    forEach(at, [&](std::uint32_t triangle) AEOLIC_INLINE {
        // Blocks of 128 bits. A record of three may lie in two lines.
        const float* base = arrays.vertices[0].position;
        for (int k = 0; k < 3; ++k) {
            __builtin_prefetch(base + 4 * std::size_t{arrays.corners[triangle][std::size_t(k)]});
        }
    });
}

void resolveAll(const SceneArrays& arrays, const View& view, EdgeSamples& samples)
{
    const DF d;
    const EdgePixels& pixels = samples.drawn.pixels();
    constexpr std::size_t kSamples = antialias::kSamples;
    const std::size_t count = pixels.count() * kSamples;
    const std::size_t shown = arrays.corners.empty() ? 0 : count;  // A rank may have no triangles.
    for (std::size_t at = 0; at < count; at += hn::Lanes(d)) {
        const auto place = [&](const std::int32_t* pixel, const std::int32_t* parts) AEOLIC_INLINE {
            HWY_ALIGN std::int32_t part[hn::MaxLanes(d)];
            for (std::size_t i = 0; i < hn::Lanes(d); ++i) part[i] = parts[(at + i) % kSamples];
            // The widest vectors hold the samples of two pixels, the second of which may be one too many.
            VI both = hn::Set(DI(), pixel[at / kSamples]);
            if constexpr (hn::MaxLanes(d) > kSamples)
                both = hn::IfThenElse(hn::FirstN(DI(), kSamples), both, hn::Set(DI(), pixel[at / kSamples + 1]));
            return hn::Add(
                hn::Add(hn::ConvertTo(d, both), hn::Set(d, 0.5f)),
                hn::Mul(hn::ConvertTo(d, hn::Load(DI(), part)), hn::Set(d, 1.0f / float(antialias::kParts))));
        };
        prefetchShown(samples.drawn, at + hn::Lanes(d), shown, arrays);
        resolveSome(at, place(pixels.x(), antialias::kRight), place(pixels.y(), antialias::kDown), arrays, view,
                    samples);
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(resolveAll);

namespace {

EdgeSample sampleOf(const EdgeSamples& samples, std::size_t at, const std::vector<std::uint64_t>& order)
{
    EdgeSample sample;
    const std::uint64_t key = samples.drawn.key(at);
    if (key == 0) return sample;
    sample.order = order[TileKeys::triangle(key)];
    sample.depth = std::uint32_t(key >> 32);
    sample.invDepth = samples.invDepth[at];
    sample.gradX = samples.gradX[at];
    sample.gradY = samples.gradY[at];
    sample.light = samples.light[at];
    return sample;
}

}  // namespace

void EdgeSamples::resize(std::size_t pixels)
{
    for (std::vector<float>* values : {&invDepth, &gradX, &gradY, &light})
        values->resize(pixels * antialias::kSamples + EdgePixels::kPadding);
}

void resolveSamples(const SceneArrays& arrays, const View& view, EdgeSamples& samples)
{
    samples.resize(samples.drawn.pixels().count());
    HWY_DYNAMIC_DISPATCH(resolveAll)(arrays, view, samples);
}

void drawSamples(const Visibility& visibility, int tile, const EdgePixels& pixels, const SceneArrays& arrays,
                 const View& view, EdgeSamples& samples)
{
    samples.drawn.clear(pixels);
    visibility.drawEdges(tile, samples.drawn);
    resolveSamples(arrays, view, samples);
}

std::vector<EdgePixelSeen> seenInEdges(const Visibility& visibility, const EdgeMask& all, const SceneArrays& arrays,
                                       const View& view)
{
    std::vector<std::vector<EdgePixelSeen>> byTile(std::size_t(visibility.tiles()));
    parallelFor(byTile.size(), [&](std::size_t i) {
        thread_local EdgePixels pixels;
        pixels.find(all, visibility.tileExtent(int(i)));
        if (pixels.count() == 0) return;
        thread_local EdgeSamples samples;
        drawSamples(visibility, int(i), pixels, arrays, view, samples);
        for (std::size_t number = 0; number < pixels.count(); ++number) {
            EdgePixelSeen seen{pixels.x()[number], pixels.y()[number], {}};
            bool any = false;
            for (std::size_t s = 0; s < std::size_t(antialias::kSamples); ++s) {
                seen.samples[s] = sampleOf(samples, number * antialias::kSamples + s, arrays.scene->surface.order);
                any = any || seen.samples[s].depth != 0;
            }
            if (any) byTile[i].push_back(seen);
        }
    });
    std::vector<EdgePixelSeen> seen;
    for (const auto& tile : byTile) seen.insert(seen.end(), tile.begin(), tile.end());
    return seen;
}

}  // namespace aeolic::cpu
#endif
