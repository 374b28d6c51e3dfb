#include "render/cpu/project/sample_triangles.h"

#include <algorithm>
#include <tuple>

#include "render/cpu/project/raster/triangle_rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/project/sample_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/project/raster/triangle_batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Prefetches the data of the triangles that come next. A file's triangles need not be near each other in memory.
HWY_INLINE void prefetchCorners(const SurfaceMesh& mesh, const ScreenVertices& screen,
                                std::span<const std::uint32_t> ids, std::size_t lanes)
{
    for (std::size_t i = lanes; i < std::min(2 * lanes, ids.size()); ++i) __builtin_prefetch(&mesh.triangles[ids[i]]);
    for (std::size_t i = 0; i < std::min(lanes, ids.size()); ++i)
        for (const std::uint32_t point : mesh.triangles[ids[i]]) __builtin_prefetch(&screen[point]);
}

// An edge function per part of a pixel, of one per pixel.
template <class D>
HWY_INLINE hn::Vec<D> perPart(D d, hn::Vec<D> perPixel)
{
    return hn::Mul(hn::ShiftRight<kSubpixelBits>(perPixel), hn::Set(d, kSubpixelsPerPart));
}

// A batch's edge functions on the pixels of a tile.
struct SampleReach {
    HWY_ALIGN std::int32_t atFirst[3][Batch::kMost];  // At the centre of the tile's first pixel.
    // Where they are largest among a pixel's samples, in multiples of kSubpixels: at the first pixel, and per pixel to
    // the right and downwards. The values differ from pixel to pixel by such multiples, so rounding down keeps their
    // sign. All on the tile are whole numbers below 2^23, which floats hold exactly.
    HWY_ALIGN float most[3][Batch::kMost], perRight[3][Batch::kMost], perDown[3][Batch::kMost];

    HWY_INLINE SampleReach(const Batch& batch, const Extent& tile)
    {
        const DI d;
        const DF df;
        const VI right = hn::Sub(hn::Load(d, batch.x0), hn::Set(d, tile.x0)),
                 down = hn::Sub(hn::Load(d, batch.y0), hn::Set(d, tile.y0));
        const auto inPixels = [&](VI edge) { return hn::ConvertTo(df, hn::ShiftRight<kSubpixelBits>(edge)); };
        for (int k = 0; k < 3; ++k) {
            const VI edgeX = hn::Load(d, batch.edgeX[k]), edgeY = hn::Load(d, batch.edgeY[k]);
            const VF partX = hn::ConvertTo(df, perPart(d, edgeX)), partY = hn::ConvertTo(df, perPart(d, edgeY));
            VF largest = hn::Set(df, -hwy::HighestValue<float>());
            for (int s = 0; s < antialias::kSamples; ++s) {
                largest = hn::Max(largest, hn::MulAdd(partX, hn::Set(df, float(antialias::kRight[s])),
                                                      hn::Mul(partY, hn::Set(df, float(antialias::kDown[s])))));
            }
            const VI toFirst = hn::Add(hn::Mul(right, edgeX), hn::Mul(down, edgeY));
            const VI first = hn::Sub(hn::Load(d, batch.edge[k]), toFirst);
            hn::Store(first, d, atFirst[k]);
            hn::Store(inPixels(hn::Add(first, hn::ConvertTo(d, largest))), df, most[k]);
            hn::Store(inPixels(edgeX), df, perRight[k]);
            hn::Store(inPixels(edgeY), df, perDown[k]);
        }
    }
};

// Of a range of pixels those in which one of a batch may show at a sample. Returns how many. Few that are asked for
// do, because most triangles at a silhouette are thin, or hidden.
HWY_INLINE std::size_t pixelsNear(const Batch& batch, const SampleReach& reach, std::size_t lane,
                                  const EdgePixels::Range& range, SampleKeys& out, std::int32_t* numbers)
{
    const DI di;
    const DF d;
    const float *right = out.pixels().right(), *down = out.pixels().down();
    const VF nearest = hn::Set(d, batch.highest[lane] + batch.bias[lane]);
    VF most[3], perRight[3], perDown[3];
    for (int k = 0; k < 3; ++k) {
        most[k] = hn::Set(d, reach.most[k][lane]);
        perRight[k] = hn::Set(d, reach.perRight[k][lane]);
        perDown[k] = hn::Set(d, reach.perDown[k][lane]);
    }
    std::size_t count = 0;
    for (std::size_t i = range.begin; i < range.end; i += hn::Lanes(d)) {
        const VF px = hn::LoadU(d, right + i), py = hn::LoadU(d, down + i);
        const auto edgeAt = [&](int k) AEOLIC_INLINE {
            return hn::MulAdd(px, perRight[k], hn::MulAdd(py, perDown[k], most[k]));
        };
        const VF least = hn::Min(edgeAt(0), hn::Min(edgeAt(1), edgeAt(2)));
        const MF near = hn::And(hn::Ge(least, hn::Zero(d)), hn::Ge(nearest, hn::LoadU(d, out.farthest() + i)));
        const VI number = hn::Add(hn::Iota(di, 0), hn::Set(di, std::int32_t(i)));
        const auto chosen = hn::And(hn::RebindMask(di, near), hn::Lt(number, hn::Set(di, std::int32_t(range.end))));
        count += compressStore(number, chosen, di, numbers + count);
    }
    return count;
}

// Draws one of a batch into the samples of pixels. The same arithmetic as drawSmall().
HWY_INLINE void sampleSmall(const Batch& batch, const SampleReach& reach, std::size_t lane, float farthest,
                            const std::int32_t* numbers, std::size_t count, SampleKeys& out)
{
    const hn::CappedTag<float, antialias::kSamples> d;  // Some of a pixel's samples.
    const hn::RebindToSigned<decltype(d)> di;
    const hn::RebindToUnsigned<decltype(d)> du;
    const hn::Half<decltype(d)> half;
    const hn::Rebind<double, decltype(half)> d64;
    const hn::Rebind<std::int32_t, decltype(half)> halfInt;
    constexpr int kLanes = int(hn::MaxLanes(d)), kVectors = antialias::kSamples / kLanes;
    const auto complement = hn::Set(du, ~batch.id[lane]);
    const auto lowest = hn::Set(d, batch.lowest[lane]), highest = hn::Set(d, batch.highest[lane]),
               bias = hn::Set(d, batch.bias[lane]), farDepth = hn::Set(d, farthest);
    const auto depth = hn::Set(d64, double(batch.depth[lane])), depthX = hn::Set(d64, batch.depthX[lane]),
               depthY = hn::Set(d64, batch.depthY[lane]);
    hn::Vec<decltype(di)> beside[kVectors][3];  // What samples have beside the pixel's centre.
    for (int v = 0; v < kVectors; ++v) {
        const auto right = hn::LoadU(di, antialias::kRight + v * kLanes),
                   down = hn::LoadU(di, antialias::kDown + v * kLanes);
        for (int k = 0; k < 3; ++k)
            beside[v][k] = hn::Add(hn::Mul(perPart(di, hn::Set(di, batch.edgeX[k][lane])), right),
                                   hn::Mul(perPart(di, hn::Set(di, batch.edgeY[k][lane])), down));
    }
    const Extent& tile = out.pixels().tile();
    for (std::size_t i = 0; i < count; ++i) {
        const auto number = std::size_t(numbers[i]);
        const int x = out.pixels().x()[number], y = out.pixels().y()[number];
        const auto centre = [&](int k) AEOLIC_INLINE {
            return hn::Set(di, reach.atFirst[k][lane] + (x - tile.x0) * batch.edgeX[k][lane] +
                                   (y - tile.y0) * batch.edgeY[k][lane]);
        };
        const auto e0 = centre(0), e1 = centre(1), e2 = centre(2);
        const auto centreX = hn::Set(d64, double(batch.fromAX[lane] + (x - batch.x0[lane]) * kSubpixels)),
                   centreY = hn::Set(d64, double(batch.fromAY[lane] + (y - batch.y0[lane]) * kSubpixels));
        for (int v = 0; v < kVectors; ++v) {
            const auto signs =
                hn::Or(hn::Add(e0, beside[v][0]), hn::Or(hn::Add(e1, beside[v][1]), hn::Add(e2, beside[v][2])));
            const auto planeFrom = [&](int first) AEOLIC_INLINE {
                const auto whole = [&](const std::int32_t* parts) AEOLIC_INLINE {
                    return hn::Mul(hn::PromoteTo(d64, hn::LoadU(halfInt, parts + first)),
                                   hn::Set(d64, double(kSubpixelsPerPart)));
                };
                const auto fromAX = hn::Add(whole(antialias::kRight), centreX),
                           fromAY = hn::Add(whole(antialias::kDown), centreY);
                return hn::DemoteTo(half, hn::Add(hn::Mul(fromAX, depthX), hn::Add(depth, hn::Mul(depthY, fromAY))));
            };
            const auto plane = hn::Combine(d, planeFrom(v * kLanes + kLanes / 2), planeFrom(v * kLanes));
            const auto clamped = hn::Add(hn::Min(hn::Max(plane, lowest), highest), bias);
            const std::size_t at = number * antialias::kSamples + std::size_t(v * kLanes);
            const auto shown = hn::LoadU(d, out.depths() + at);
            const auto shownComplement = hn::LoadU(du, out.complements() + at);
            const auto first = hn::And(hn::Eq(clamped, shown), hn::RebindMask(d, hn::Gt(complement, shownComplement)));
            const auto hidden = hn::Or(hn::RebindMask(d, hn::Lt(signs, hn::Zero(di))), hn::Lt(clamped, farDepth));
            const auto nearer = hn::AndNot(hidden, hn::Or(hn::Gt(clamped, shown), first));
            hn::StoreU(hn::IfThenElse(nearer, clamped, shown), d, out.depths() + at);
            hn::StoreU(hn::IfThenElse(hn::RebindMask(du, nearer), complement, shownComplement), du,
                       out.complements() + at);
        }
    }
}

void sampleAll(const SurfaceMesh& mesh, const ScreenVertices& screen, std::span<const std::uint32_t> ids,
               const DrawRule& rule, SampleKeys& out)
{
    const std::size_t lanes = hn::Lanes(DI());
    const EdgePixels& pixels = out.pixels();
    // All of a strip and a vector more.
    HWY_ALIGN std::int32_t numbers[EdgePixels::kColumns * TileKeys::kSize + Batch::kMost];
    Batch batch;
    for (std::size_t begin = 0; begin < ids.size(); begin += lanes) {
        const std::size_t count = std::min(lanes, ids.size() - begin);
        batch.take(ids.subspan(begin, count));
        if (begin + lanes < ids.size()) prefetchCorners(mesh, screen, ids.subspan(begin + lanes), lanes);
        setUp(mesh, screen, pixels.tile(), kSampleMargin, rule, batch);
        const SampleReach reach(batch, pixels.tile());
        for (std::size_t i = 0; i < count; ++i) {
            if (batch.isReady[i]) {
                const int last = pixels.strip(batch.x1[i] - 1);
                for (int strip = pixels.strip(batch.x0[i]); strip <= last; ++strip) {
                    const EdgePixels::Range range = pixels.range(strip, batch.y0[i], batch.y1[i]);
                    const std::size_t near = pixelsNear(batch, reach, i, range, out, numbers);
                    if (near > 0) sampleSmall(batch, reach, i, rule.farInvDepth, numbers, near, out);
                }
            } else if (batch.isLarge[i]) {
                const auto [a, b, c] = mesh.triangles[batch.id[i]];
                sampleTriangle(cornerOf(screen[a]), cornerOf(screen[b]), cornerOf(screen[c]), batch.id[i], rule, out);
            }
        }
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(sampleAll);

void SampleKeys::clear(const EdgePixels& pixels)
{
    pixels_ = &pixels;
    const std::size_t samples = pixels.count() * std::size_t{antialias::kSamples} + EdgePixels::kPadding;
    depths_.assign(samples, 0);
    complements_.assign(samples, 0);
    farthest_.assign(pixels.count() + EdgePixels::kPadding, 0);
}

void SampleKeys::findFarthest()
{
    for (std::size_t i = 0; i < pixels_->count(); ++i) {
        const float* depth = depths() + i * antialias::kSamples;
        farthest_[i] = *std::min_element(depth, depth + antialias::kSamples);
    }
}

void sampleTriangles(const SurfaceMesh& mesh, const ScreenVertices& screen, std::span<const std::uint32_t> ids,
                     const DrawRule& rule, SampleKeys& out)
{
    HWY_DYNAMIC_DISPATCH(sampleAll)(mesh, screen, ids, rule, out);
}

void sampleTriangle(const Corner& a, const Corner& b, const Corner& c, std::uint32_t id, const DrawRule& rule,
                    SampleKeys& out)
{
    const EdgePixels& pixels = out.pixels();
    const std::optional<TriangleRows> t = triangleRows(a, b, c, id, pixels.tile(), kSampleMargin, rule);
    if (!t) return;
    // How much more than at a pixel's centre the edge functions are at a sample.
    std::int64_t beside[3][antialias::kSamples], most[3];
    for (int k = 0; k < 3; ++k) {
        const std::int64_t perRight = t->edgeX[k] / kSubpixels * kSubpixelsPerPart,
                           perDown = t->edgeY[k] / kSubpixels * kSubpixelsPerPart;
        for (int s = 0; s < antialias::kSamples; ++s)
            beside[k][s] = perRight * antialias::kRight[s] + perDown * antialias::kDown[s];
        most[k] = *std::max_element(beside[k], beside[k] + antialias::kSamples);
    }
    const float nearest = t->highest + t->bias;
    const auto sample = [&](std::size_t number) {
        const std::int64_t right = pixels.x()[number] - t->over.x0, down = pixels.y()[number] - t->over.y0;
        std::int64_t centre[3];
        for (int k = 0; k < 3; ++k) centre[k] = t->edge[k] + right * t->edgeX[k] + down * t->edgeY[k];
        // Most pixels of a large triangle's box have no sample of it, or show something nearer at all of them.
        if (((centre[0] + most[0]) | (centre[1] + most[1]) | (centre[2] + most[2])) < 0) return;
        if (nearest < out.farthest()[number]) return;
        for (int s = 0; s < antialias::kSamples; ++s) {
            if (((centre[0] + beside[0][s]) | (centre[1] + beside[1][s]) | (centre[2] + beside[2][s])) < 0) continue;
            const std::int64_t subRight = std::int64_t{antialias::kRight[s]} * kSubpixelsPerPart,
                               subDown = std::int64_t{antialias::kDown[s]} * kSubpixelsPerPart;
            const double fromAX = double(t->fromAX + right * kSubpixels + subRight),
                         fromAY = double(t->fromAY + down * kSubpixels + subDown);
            const double plane = fromAX * t->depthX + (t->depth + t->depthY * fromAY);
            const float depth = std::min(std::max(float(plane), t->lowest), t->highest) + t->bias;
            if (depth < t->farthest) continue;
            const std::size_t at = number * antialias::kSamples + std::size_t(s);
            if (std::tie(depth, t->notId) <= std::tie(out.depths()[at], out.complements()[at])) continue;
            out.depths()[at] = depth;
            out.complements()[at] = t->notId;
        }
    };
    for (int strip = pixels.strip(t->over.x0); strip <= pixels.strip(t->over.x1 - 1); ++strip) {
        const EdgePixels::Range range = pixels.range(strip, t->over.y0, t->over.y1);
        for (std::size_t number = range.begin; number < range.end; ++number) sample(number);
    }
}

}  // namespace aeolic::cpu
#endif
