#include "render/cpu/edges/edge_colors.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/edges/edge_colors.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/project/one_sheet-inl.h"
#include "render/cpu/shade/surface_color-inl.h"

#ifndef AEOLIC_RENDER_CPU_EDGE_COLORS_ONCE
#define AEOLIC_RENDER_CPU_EDGE_COLORS_ONCE
namespace aeolic::cpu {
namespace {

/// What a sample may take its colour from: a pixel and its neighbours, those with surface, nearest first. They are
/// looked at one by one, because most samples take one of the first.
class Candidates {
public:
    static constexpr int kMost = 9;
    std::int32_t right[kMost], down[kMost];  ///< From the pixel, in pixels.
    float invDepth[kMost], gradX[kMost], gradY[kMost], light[kMost];
    std::uint32_t color[kMost];

    Candidates(int x, int y, const EdgeScene& scene, const ShownRows& shown)
        : x_(x), y_(y), scene_(scene), shown_(shown)
    {
    }

    /// Whether there is candidate k, of which all before it have been asked for.
    bool has(int k)
    {
        while (k >= count_ && looked_ < kMost) look(looked_++);
        return k < count_;
    }
    float scalar(int k) const { return scene_.palette.useScalar ? scene_.buffer.scalar.at(column(k), row(k)) : 0; }
    /// Which of the palette's tables.
    std::int32_t kind(int k) const
    {
        return scene_.palette.tables.empty() ? 0 : scene_.buffer.colors.at(column(k), row(k));
    }
    float open(int k) const { return scene_.palette.occlusion ? scene_.open.at(column(k), row(k)) : 1; }

private:
    int column(int k) const { return x_ + right[k]; }
    int row(int k) const { return y_ + down[k]; }

    void look(int neighbour)
    {
        constexpr std::int32_t kRight[kMost] = {0, 0, -1, 1, 0, -1, 1, -1, 1},
                               kDown[kMost] = {0, -1, 0, 0, 1, -1, -1, 1, 1};
        const GBuffer& buffer = scene_.buffer;
        const int qx = x_ + kRight[neighbour], qy = y_ + kDown[neighbour];
        if (qx < 0 || qx >= scene_.view.camera.width || qy < 0 || qy >= scene_.view.camera.height) return;
        const float depth = buffer.invDepth.at(qx, qy);
        if (!(depth > 0)) return;
        right[count_] = kRight[neighbour], down[count_] = kDown[neighbour];
        invDepth[count_] = depth, gradX[count_] = buffer.gradX.at(qx, qy), gradY[count_] = buffer.gradY.at(qx, qy);
        light[count_] = std::abs(buffer.light.at(qx, qy));
        std::memcpy(&color[count_], shown_.pixel(qx, qy), sizeof color[count_]);
        ++count_;
    }

    int x_, y_, count_ = 0, looked_ = 0;
    const EdgeScene& scene_;
    const ShownRows& shown_;
};

/// The mean of a pixel's samples. Integers: in whichever order they are added, the sums are the same.
struct ColorSum {
    std::int32_t channel[3] = {}, alpha = 0;  ///< Colours times alpha.

    /// `background`: what shows where nothing else does.
    std::uint32_t mean(std::uint32_t background) const
    {
        if (alpha == 0) return background;
        std::uint32_t rgba = std::uint32_t((alpha + antialias::kSamples / 2) / antialias::kSamples) << 24;
        // The quotients of such small whole numbers are never rounded up to the next whole one.
        for (int c = 0; c < 3; ++c) rgba |= std::uint32_t(float(channel[c] + alpha / 2) / float(alpha)) << (8 * c);
        return rgba;
    }
};

constexpr std::int32_t kNone = -1;
constexpr std::uint8_t kAllSamples = (1u << antialias::kSamples) - 1;
/// So many pixels ahead their neighbours are prefetched.
constexpr std::uint32_t kAhead = 8;

/// A pixel's samples, of which some show what no pixel's centre does. They have the nearest candidate's colours.
struct UnseenSamples {
    static constexpr std::size_t kMost = EdgePixels::kPadding;  ///< kSamples, up to a whole vector.
    static_assert(kMost >= std::size_t(antialias::kSamples));

    std::uint8_t which = 0;  ///< A bit for each sample.
    alignas(64) float light[kMost] = {}, scalar[kMost] = {};
    alignas(64) std::int32_t kind[kMost] = {};
};

void lightUnseen(Candidates& candidates, const float* light, const std::int32_t* nearest, UnseenSamples& out)
{
    const bool any = candidates.has(0);
    for (int s = 0; s < antialias::kSamples; ++s) {
        if ((out.which >> s & 1) == 0) continue;
        out.scalar[s] = any ? candidates.scalar(nearest[s]) : std::numeric_limits<float>::quiet_NaN();
        out.light[s] = light[s] * (any ? candidates.open(nearest[s]) : 1);
        out.kind[s] = any ? candidates.kind(nearest[s]) : 0;
    }
}

}  // namespace
}  // namespace aeolic::cpu
#endif

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DP = hn::CappedTag<float, antialias::kSamples>;  // Some of a pixel's samples.
using VP = hn::Vec<DP>;

// Which of a pixel's samples show background, a bit each.
HWY_INLINE std::uint8_t emptySamples(const float* invDepth)
{
    const DP d;
    std::uint8_t bits = 0;
    for (int s = 0; s < antialias::kSamples; s += int(hn::Lanes(d)))
        bits = std::uint8_t(bits | bitsOf(d, hn::Eq(hn::LoadU(d, invDepth + s), hn::Zero(d))) << s);
    return bits;
}

// Which candidate each sample takes: that of its own sheet which fits best, or none; and the nearest in depth. Returns
// which of them show a surface, but take none, a bit each.
HWY_INLINE std::uint8_t chooseCandidates(Candidates& candidates, const EdgeSamples& samples, std::size_t at,
                                         float focalPx, std::int32_t* chosen, std::int32_t* nearest)
{
    const DP d;
    const hn::RebindToSigned<DP> di;
    const VP perDepth = slackPerDepth(d, focalPx);
    std::uint8_t without = 0;
    for (int s = 0; s < antialias::kSamples; s += int(hn::Lanes(d))) {
        const auto place = [&](const std::int32_t* parts) AEOLIC_INLINE {
            return hn::Mul(hn::ConvertTo(d, hn::LoadU(di, parts + s)), hn::Set(d, 1.0f / float(antialias::kParts)));
        };
        const std::size_t first = at + std::size_t(s);
        const VP right = place(antialias::kRight), down = place(antialias::kDown);
        const VP depth = hn::LoadU(d, &samples.invDepth[first]), gradX = hn::LoadU(d, &samples.gradX[first]),
                 gradY = hn::LoadU(d, &samples.gradY[first]);
        VP best = hn::Inf(d), closest = hn::Inf(d);
        auto chosenOf = hn::Set(di, kNone), nearestOf = hn::Zero(di);
        // Samples of background look for nobody.
        const auto empty = hn::Eq(depth, hn::Zero(d));
        auto done = empty;
        for (int k = 0; !hn::AllTrue(d, done) && candidates.has(k); ++k) {
            const VP dx = hn::Sub(right, hn::Set(d, float(candidates.right[k]))),
                     dy = hn::Sub(down, hn::Set(d, float(candidates.down[k])));
            const auto along = [&](VP gx, VP gy) AEOLIC_INLINE { return hn::MulAdd(gx, dx, hn::Mul(gy, dy)); };
            const VP theirs = hn::Set(d, candidates.invDepth[k]);
            const VP byPixel = along(hn::Set(d, candidates.gradX[k]), hn::Set(d, candidates.gradY[k]));
            const auto fit = predict(d, theirs, byPixel, depth, along(gradX, gradY), perDepth);
            const VP far = hn::Mul(hn::MulAdd(dx, dx, hn::Mul(dy, dy)), hn::Set(d, antialias::kDistanceShare));
            const VP error = hn::MulAdd(far, fit.slack, hn::Add(hn::Abs(fit.errorA), hn::Abs(fit.errorB)));
            const auto better = hn::AndNot(done, hn::And(onOneSheet(d, fit), hn::Lt(error, best)));
            best = hn::IfThenElse(better, error, best);
            chosenOf = hn::IfThenElse(hn::RebindMask(di, better), hn::Set(di, k), chosenOf);
            const VP off = hn::Abs(hn::Sub(depth, theirs));
            const auto closer = hn::Lt(off, closest);
            closest = hn::IfThenElse(closer, off, closest);
            nearestOf = hn::IfThenElse(hn::RebindMask(di, closer), hn::Set(di, k), nearestOf);
            done = hn::Or(done, hn::And(better, hn::Le(error, hn::Mul(fit.slack, hn::Set(d, antialias::kFits)))));
        }
        hn::StoreU(chosenOf, di, chosen + s);
        hn::StoreU(nearestOf, di, nearest + s);
        const auto none = hn::RebindMask(d, hn::Lt(chosenOf, hn::Zero(di)));
        without = std::uint8_t(without | bitsOf(d, hn::AndNot(empty, none)) << s);
    }
    return without;
}

// Adds the colours of samples that have taken a candidate's, with their own light.
HWY_INLINE void addTaken(const Candidates& candidates, const float* light, const std::int32_t* chosen, bool lighting,
                         ColorSum& sum)
{
    const DP d;
    const hn::RebindToSigned<DP> di;
    const hn::RebindToUnsigned<DP> du;
    static_assert(kNone == -1, "the taken are those not negative");
    // Two sums in a lane: none reaches 2^16.
    auto redGreen = hn::Zero(di), blueTaken = hn::Zero(di);
    for (int s = 0; s < antialias::kSamples; s += int(hn::Lanes(d))) {
        const auto index = hn::LoadU(di, chosen + s);
        const auto taken = hn::Gt(index, hn::Set(di, kNone));
        const auto from = hn::IfThenElseZero(taken, index);
        const auto color = hn::GatherIndex(du, candidates.color, from);
        VP brighter = hn::Set(d, 1.0f);
        if (lighting) brighter = hn::Div(hn::LoadU(d, light + s), hn::GatherIndex(d, candidates.light, from));
        const auto channel = [&](int c) AEOLIC_INLINE {
            const auto byte = hn::And(hn::ShiftRightSame(color, 8 * c), hn::Set(du, 0xFFu));
            const VP value = hn::MulAdd(hn::ConvertTo(d, hn::BitCast(di, byte)), brighter, hn::Set(d, 0.5f));
            return hn::ConvertTo(di, hn::Min(value, hn::Set(d, 255.0f)));
        };
        const auto counted = [&](auto low, auto high) AEOLIC_INLINE {
            return hn::IfThenElseZero(taken, hn::Or(low, hn::ShiftLeft<16>(high)));
        };
        redGreen = hn::Add(redGreen, counted(channel(0), channel(1)));
        blueTaken = hn::Add(blueTaken, counted(channel(2), hn::Set(di, 1)));
    }
    const std::int32_t sums[2] = {hn::GetLane(hn::SumOfLanes(di, redGreen)),
                                  hn::GetLane(hn::SumOfLanes(di, blueTaken))};
    sum.channel[0] += 255 * (sums[0] & 0xFFFF);
    sum.channel[1] += 255 * (sums[0] >> 16);
    sum.channel[2] += 255 * (sums[1] & 0xFFFF);
    sum.alpha += 255 * (sums[1] >> 16);
}

// Adds the colours of samples that none of the pixels' centres shows.
HWY_INLINE void addUnseen(const Palette& palette, const UnseenSamples& samples, ColorSum& sum)
{
    const DF d;
    static_assert(UnseenSamples::kMost >= hn::MaxLanes(DF()));
    HWY_ALIGN std::uint32_t colors[UnseenSamples::kMost];
    for (std::size_t i = 0; i < std::size_t(antialias::kSamples); i += hn::Lanes(d))
        hn::Store(surfaceColor(palette, hn::Zero(d), hn::Load(d, samples.light + i), hn::Load(d, samples.scalar + i),
                               hn::Load(DI(), samples.kind + i)),
                  DU(), colors + i);
    for (int s = 0; s < antialias::kSamples; ++s) {
        if ((samples.which >> s & 1) == 0) continue;
        for (int c = 0; c < 3; ++c) sum.channel[c] += 255 * std::int32_t((colors[s] >> (8 * c)) & 0xFFu);
        sum.alpha += 255;
    }
}

// Prefetches what candidates are looked up in, in the row below a pixel. The rows above were mostly prefetched
// already, for the pixel above.
HWY_INLINE void prefetchBelow(const EdgePixels& pixels, std::uint32_t number, const GBuffer& buffer,
                              const ShownRows& shown)
{
    if (number >= pixels.count()) return;
    const int x = pixels.x()[number], y = std::min(pixels.y()[number] + 1, buffer.valid().y1 - 1);
    for (const Image<float>* image : {&buffer.invDepth, &buffer.gradX, &buffer.gradY, &buffer.light})
        __builtin_prefetch(image->row(y) + x);
    __builtin_prefetch(shown.pixel(x, y));
}

void mixAll(const EdgePixels& pixels, const EdgeSamples& samples, std::size_t first, const EdgeScene& scene,
            const ShownRows& shown, std::uint32_t* out)
{
    const Palette& palette = scene.palette;
    const auto background = [&](int c) { return std::int32_t(palette.background[std::size_t(c)]); };
    const auto sumOfEmpty = [&](int count) {
        ColorSum sum;
        for (int c = 0; c < 3; ++c) sum.channel[c] = count * background(c) * background(3);
        sum.alpha = count * background(3);
        return sum;
    };
    const auto backgroundShown = std::bit_cast<std::uint32_t>(palette.background);
    const std::uint32_t nothing = sumOfEmpty(antialias::kSamples).mean(backgroundShown);
    for (std::uint32_t number = 0; number < pixels.count(); ++number) {
        prefetchBelow(pixels, number + kAhead, scene.buffer, shown);
        const int x = pixels.x()[number], y = pixels.y()[number];
        const std::size_t at = (first + number) * antialias::kSamples;
        const std::uint8_t empty = emptySamples(&samples.invDepth[at]);
        if (empty == kAllSamples) {  // About every fourth.
            out[number] = nothing;
            continue;
        }
        Candidates candidates(x, y, scene, shown);
        std::int32_t chosen[antialias::kSamples], nearest[antialias::kSamples];
        const std::uint8_t unseen = chooseCandidates(candidates, samples, at, scene.view.focalPx, chosen, nearest);
        ColorSum sum = sumOfEmpty(std::popcount(empty));
        addTaken(candidates, &samples.light[at], chosen, palette.lighting, sum);
        if (unseen != 0) {
            UnseenSamples lit{unseen};
            lightUnseen(candidates, &samples.light[at], nearest, lit);
            addUnseen(palette, lit, sum);
        }
        out[number] = sum.mean(backgroundShown);
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(mixAll);

void mixEdges(const EdgePixels& pixels, const EdgeSamples& samples, std::size_t first, const EdgeScene& scene,
              const ShownRows& shown, std::uint32_t* out)
{
    HWY_DYNAMIC_DISPATCH(mixAll)(pixels, samples, first, scene, shown, out);
}

}  // namespace aeolic::cpu
#endif
