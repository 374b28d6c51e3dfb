#include "render/cpu/project/sample_triangles.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "render/cpu/project/raster/triangle_rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/project/sample_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/project/raster/triangle_batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DS = hn::CappedTag<double, antialias::kSamples>;  // Some of a pixel's samples.

using DE = hn::CappedTag<std::int32_t, antialias::kSamples>;

// What a triangle's samples have beside the pixel's centre; the same at every pixel.
struct SampleOffsets {
    HWY_ALIGN std::int32_t edge[3][antialias::kSamples];
};

// An edge function per part of a pixel, of one per pixel.
template <class D>
HWY_INLINE hn::Vec<D> perPart(D d, const std::int32_t* perPixel)
{
    return hn::Mul(hn::ShiftRight<kSubpixelBits>(hn::Load(d, perPixel)), hn::Set(d, kSubpixelsPerPart));
}

// How much more than at the pixel's centre a batch's edge functions are at the sample where they are largest.
struct SampleReach {
    HWY_ALIGN std::int32_t edge[3][Batch::kMost];

    HWY_INLINE explicit SampleReach(const Batch& batch)
    {
        const DI d;
        for (int k = 0; k < 3; ++k) {
            const VI perRight = perPart(d, batch.edgeX[k]), perDown = perPart(d, batch.edgeY[k]);
            VI most = hn::Set(d, INT32_MIN);
            for (int s = 0; s < antialias::kSamples; ++s) {
                most = hn::Max(most, hn::Add(hn::Mul(perRight, hn::Set(d, antialias::kRight[s])),
                                             hn::Mul(perDown, hn::Set(d, antialias::kDown[s]))));
            }
            hn::Store(most, d, edge[k]);
        }
    }
};

HWY_INLINE void offsetsOf(const Batch& batch, std::size_t lane, SampleOffsets& out)
{
    const DE d;
    for (int k = 0; k < 3; ++k) {
        // Per sub-pixel; what is given is per pixel.
        const auto perRight = hn::Set(d, (batch.edgeX[k][lane] >> kSubpixelBits) * kSubpixelsPerPart),
                   perDown = hn::Set(d, (batch.edgeY[k][lane] >> kSubpixelBits) * kSubpixelsPerPart);
        for (int s = 0; s < antialias::kSamples; s += int(hn::Lanes(d)))
            hn::Store(hn::Add(hn::Mul(perRight, hn::LoadU(d, antialias::kRight + s)),
                              hn::Mul(perDown, hn::LoadU(d, antialias::kDown + s))),
                      d, out.edge[k] + s);
    }
}

// In which pixels of a row one of a batch may cover a sample. Few that are asked for do, because most triangles at a
// silhouette are thin.
class RowsNear {
public:
    HWY_INLINE RowsNear(const Batch& batch, const SampleReach& reach, std::size_t lane)
        : width_(batch.x1[lane] - batch.x0[lane]), y0_(batch.y0[lane])
    {
        for (int k = 0; k < 3; ++k) {
            perColumn_[k] = batch.edgeX[k][lane];
            perRow_[k] = batch.edgeY[k][lane];
            first_[k] = batch.edge[k][lane] + reach.edge[k][lane];
        }
    }

    // A bit for each pixel of row y from the triangle's x0 on.
    HWY_INLINE std::uint64_t near(int y) const
    {
        const DI d;
        const int lanes = int(hn::Lanes(d));
        std::uint64_t bits = 0;
        for (int x = 0; x < width_; x += lanes) {
            const auto edgeAt = [&](int k) AEOLIC_INLINE {
                const std::int32_t begin = first_[k] + (y - y0_) * perRow_[k] + x * perColumn_[k];
                return hn::Add(hn::Set(d, begin), hn::Mul(hn::Iota(d, 0), hn::Set(d, perColumn_[k])));
            };
            const VI signs = hn::Or(edgeAt(0), hn::Or(edgeAt(1), edgeAt(2)));
            bits |= bitsOf(hn::Gt(signs, hn::Set(d, -1))) << x;
        }
        return bits;
    }

private:
    static HWY_INLINE std::uint64_t bitsOf(hn::Mask<DI> mask)
    {
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(DI(), mask, bytes);
        std::uint64_t bits = 0;
        std::memcpy(&bits, bytes, sizeof bits);
        return bits;
    }

    int width_, y0_;
    std::int32_t first_[3], perColumn_[3], perRow_[3];
};

// One of a batch. The same arithmetic as drawSmall().
HWY_INLINE void sampleSmall(const Batch& batch, const SampleReach& reach, std::size_t lane, const EdgePixels& pixels,
                            std::uint64_t farKey, std::uint64_t* keys)
{
    const DS d;
    const hn::RebindToUnsigned<DS> du;
    const hn::RebindToSigned<DS> di;
    const hn::Rebind<float, DS> df;
    const hn::Rebind<std::int32_t, DS> di32;
    const hn::Rebind<std::uint32_t, DS> du32;
    const auto notId = hn::Set(du, std::uint64_t(~batch.id[lane])), farthest = hn::Set(du, farKey);
    const auto lowest = hn::Set(df, batch.lowest[lane]), highest = hn::Set(df, batch.highest[lane]),
               bias = hn::Set(df, batch.bias[lane]);
    const auto depth = hn::Set(d, double(batch.depth[lane])), depthX = hn::Set(d, batch.depthX[lane]),
               depthY = hn::Set(d, batch.depthY[lane]);
    SampleOffsets offsets;
    offsetsOf(batch, lane, offsets);
    const auto sample = [&](std::uint32_t number, int x, int y) AEOLIC_INLINE {
        const int right = x - batch.x0[lane], down = y - batch.y0[lane];
        HWY_ALIGN std::int32_t outside[antialias::kSamples];  // Negative: yes.
        bool any = false;
        for (int s = 0; s < antialias::kSamples; s += int(hn::Lanes(DE()))) {
            const auto edgeAt = [&](int k) AEOLIC_INLINE {
                const std::int32_t centre =
                    batch.edge[k][lane] + right * batch.edgeX[k][lane] + down * batch.edgeY[k][lane];
                return hn::Add(hn::Set(DE(), centre), hn::Load(DE(), offsets.edge[k] + s));
            };
            const auto signs = hn::Or(edgeAt(0), hn::Or(edgeAt(1), edgeAt(2)));
            any = any || !hn::AllTrue(DE(), hn::Lt(signs, hn::Zero(DE())));
            hn::Store(signs, DE(), outside + s);
        }
        if (!any) return;
        const auto whole = [&](const std::int32_t* parts) AEOLIC_INLINE {
            return hn::Mul(hn::PromoteTo(d, hn::LoadU(di32, parts)), hn::Set(d, double(kSubpixelsPerPart)));
        };
        for (int s = 0; s < antialias::kSamples; s += int(hn::Lanes(d))) {
            const auto inside = hn::Gt(hn::PromoteTo(di, hn::Load(di32, outside + s)), hn::Set(di, -1));
            if (hn::AllFalse(di, inside)) continue;
            const auto fromAX = hn::Add(whole(antialias::kRight + s),
                                        hn::Set(d, double(batch.fromAX[lane] + right * kSubpixels))),
                       fromAY = hn::Add(whole(antialias::kDown + s),
                                        hn::Set(d, double(batch.fromAY[lane] + down * kSubpixels)));
            const auto plane = hn::Add(hn::Mul(fromAX, depthX), hn::Add(depth, hn::Mul(depthY, fromAY)));
            const auto clamped = hn::Add(hn::Min(hn::Max(hn::DemoteTo(df, plane), lowest), highest), bias);
            const auto key = hn::Or(hn::ShiftLeft<32>(hn::PromoteTo(du, hn::BitCast(du32, clamped))), notId);
            std::uint64_t* at = keys + std::size_t(number) * antialias::kSamples + s;
            const auto before = hn::LoadU(du, at);
            const auto shows = hn::AndNot(hn::Lt(key, farthest), hn::RebindMask(du, inside));
            hn::StoreU(hn::IfThenElse(hn::And(hn::Gt(key, before), shows), key, before), du, at);
        }
    };
    const RowsNear rows(batch, reach, lane);
    for (int y = batch.y0[lane]; y < batch.y1[lane]; ++y) {
        std::uint64_t left = pixels.some(batch.x0[lane], batch.x1[lane], y);
        if (left == 0) continue;
        left &= rows.near(y) << (batch.x0[lane] - pixels.tile.x0);
        for (; left != 0; left &= left - 1) {
            const EdgePixels::Pixel pixel = pixels.first(left, y);
            sample(pixel.number, pixel.x, y);
        }
    }
}

void sampleAll(const SurfaceMesh& mesh, const ScreenVertices& screen, std::span<const std::uint32_t> ids,
               const EdgePixels& pixels, const DrawRule& rule, std::uint64_t* keys)
{
    const std::size_t lanes = hn::Lanes(DI());
    const std::uint64_t farKey = std::uint64_t(std::bit_cast<std::uint32_t>(rule.farInvDepth)) << 32;
    Batch batch;
    for (std::size_t begin = 0; begin < ids.size(); begin += lanes) {
        const std::size_t count = std::min(lanes, ids.size() - begin);
        batch.take(ids.subspan(begin, count));
        setUp(mesh, screen, pixels.tile, kSampleMargin, rule, batch);
        const SampleReach reach(batch);
        for (std::size_t i = 0; i < count; ++i) {
            if (batch.isReady[i]) {
                sampleSmall(batch, reach, i, pixels, farKey, keys);
            } else if (batch.isLarge[i]) {
                const auto& t = mesh.triangles[batch.id[i]];
                const auto corner = [&](std::size_t k) {
                    return Corner{screen.x[t[k]], screen.y[t[k]], screen.invDepth[t[k]]};
                };
                sampleTriangle(corner(0), corner(1), corner(2), batch.id[i], pixels, rule, keys);
            }
        }
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(sampleAll);

void sampleTriangles(const SurfaceMesh& mesh, const ScreenVertices& screen, std::span<const std::uint32_t> ids,
                     const EdgePixels& pixels, const DrawRule& rule, std::uint64_t* keys)
{
    HWY_DYNAMIC_DISPATCH(sampleAll)(mesh, screen, ids, pixels, rule, keys);
}

void sampleTriangle(const Corner& a, const Corner& b, const Corner& c, std::uint32_t id, const EdgePixels& pixels,
                    const DrawRule& rule, std::uint64_t* keys)
{
    const std::optional<TriangleRows> t = triangleRows(a, b, c, id, pixels.tile, kSampleMargin, rule);
    if (!t) return;
    const auto sample = [&](std::uint32_t number, int x, int y) {
        const std::int64_t right = x - t->x0, down = y - t->y0;
        for (int s = 0; s < antialias::kSamples; ++s) {
            const std::int64_t subRight = std::int64_t{antialias::kRight[s]} * kSubpixelsPerPart,
                               subDown = std::int64_t{antialias::kDown[s]} * kSubpixelsPerPart;
            const auto edgeAt = [&](int k) {
                return t->edge[k] + right * t->edgeX[k] + down * t->edgeY[k] + t->edgeX[k] / kSubpixels * subRight +
                       t->edgeY[k] / kSubpixels * subDown;
            };
            if ((edgeAt(0) | edgeAt(1) | edgeAt(2)) < 0) continue;
            const double fromAX = double(t->fromAX + right * kSubpixels + subRight),
                         fromAY = double(t->fromAY + down * kSubpixels + subDown);
            const double plane = fromAX * t->depthX + (t->depth + t->depthY * fromAY);
            const float depth = std::min(std::max(float(plane), t->lowest), t->highest) + t->bias;
            if (depth < t->farthest) continue;
            std::uint64_t& key = keys[std::size_t(number) * antialias::kSamples + std::size_t(s)];
            key = std::max(key, (std::uint64_t(std::bit_cast<std::uint32_t>(depth)) << 32) | t->notId);
        }
    };
    for (int y = t->y0; y < t->y1; ++y)
        for (std::uint64_t left = pixels.some(t->x0, t->x1, y); left != 0; left &= left - 1) {
            const EdgePixels::Pixel pixel = pixels.first(left, y);
            sample(pixel.number, pixel.x, y);
        }
}

}  // namespace aeolic::cpu
#endif
