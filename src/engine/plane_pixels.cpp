#include "engine/plane_pixels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/plane_pixels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

#include "render/cpu/lic/fine_cells.h"
#include "render/cpu/project/noise_sampling-inl.h"
#include "render/gbuffer.h"
#include "render/lic/noise.h"

// The compiler makes vectors of the plain loops, for each target.
HWY_BEFORE_NAMESPACE();
namespace aeolic::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr int kTogether = 64;  // Pixels that go through each step at once.

// Noise of each pixel, from -1 to 1: white, with the variance that the contrast is made for.
void whiteNoise(std::uint32_t pixel, std::uint32_t seed, float* noise)
{
    const std::uint32_t start = (seed + 0x7f4a7c15u) * 0x85ebca6bu;
    const float amplitude = float(std::sqrt(3.0) * kNoiseSigma);
    for (int i = 0; i < kTogether; ++i) {
        std::uint32_t x = (pixel + std::uint32_t(i)) * 0x9e3779b9u ^ start;  // Two rounds of a finaliser mix it.
        for (int round = 0; round < 2; ++round) {
            x ^= x >> 16;
            x *= 0x7feb352du;
            x ^= x >> 15;
            x *= 0x846ca68bu;
            x ^= x >> 16;
        }
        const float uniform = float(std::int32_t(x >> 8)) * 0x1p-23F - 1;
        noise[i] = uniform * amplitude;
    }
}

void grainsOf(const PlanePixels& pixels, int x0, float* noise)
{
    const hn::ScalableTag<float> d;
    for (int i = 0; i < kTogether; i += int(hn::Lanes(d))) {
        const auto x = hn::Iota(d, float(x0 + i));
        const cpu::HWY_NAMESPACE::Vec3v<hn::Vec<decltype(d)>> place{x, hn::Set(d, float(pixels.y)), hn::Zero(d)};
        const auto sample =
            cpu::HWY_NAMESPACE::sampleNoise(d, pixels.grains->pyramid, pixels.grains->lookup, place, hn::Set(d, 1.0F));
        hn::StoreU(sample, d, noise + i);
    }
}

void noiseOf(const PlanePixels& pixels, int x0, int count, float* noise)
{
    if (!pixels.texture && pixels.grains) return grainsOf(pixels, x0, noise);
    if (!pixels.texture) return whiteNoise(pixels.first + std::uint32_t(x0), pixels.seed, noise);
    for (int i = 0; i < count; ++i) {
        const float value = (pixels.texture[x0 + i] - pixels.middle) * pixels.perUnit;
        const float within = std::clamp(value, -1.0F, 1.0F);
        noise[i] = std::abs(value) <= std::numeric_limits<float>::max() ? within : 0.0F;
    }
}

RowScales scalesOfRow(const float* u, const float* v, const float* texture, int width)
{
    RowScales found;
    double longest = 0;
    constexpr double most = std::numeric_limits<double>::max();
    for (int x = 0; x < width; ++x) {
        const double squared = double(u[x]) * double(u[x]) + double(v[x]) * double(v[x]);
        const double finite = squared <= most ? squared : 0.0;
        longest = longest < finite ? finite : longest;
    }
    found.longest = std::sqrt(longest);
    for (int x = 0; texture && x < width; ++x) {
        if (!std::isfinite(texture[x])) continue;
        found.lo = std::min(found.lo, texture[x]);
        found.hi = std::max(found.hi, texture[x]);
    }
    return found;
}

using D64 = hn::ScalableTag<double>;
using V64 = hn::Vec<D64>;

// A vector's displacement per step, and whether it is finite.
struct Displacement {
    V64 x, y;
    hn::Mask<D64> finite;
};

HWY_INLINE Displacement displacementOf(const PlanePixels& pixels, V64 u, V64 v)
{
    const D64 d;
    const V64 most = hn::Set(d, flow_texel::kDisplacementMax);
    const V64 length = hn::Sqrt(hn::Add(hn::Mul(u, u), hn::Mul(v, v)));  // No float's square is too large for a double.
    const auto finite = hn::Le(length, hn::Set(d, std::numeric_limits<double>::max()));
    const auto goes = hn::And(finite, hn::Gt(length, hn::Set(d, pixels.least)));
    const V64 reference = pixels.reference > 0 ? hn::Set(d, pixels.reference) : length;
    const V64 units = hn::Div(hn::Set(d, pixels.unitsPerStep), reference);
    const auto along = [&](V64 component) HWY_ATTR {
        return hn::Max(hn::Min(hn::IfThenElseZero(goes, hn::Mul(component, units)), most), hn::Neg(most));
    };
    return {along(u), along(v), finite};
}

template <class V>
HWY_INLINE auto whole(V value)
{
    const hn::DFromV<V> d;
    const hn::Rebind<std::int32_t, decltype(d)> di;
    const V floored = hn::Floor(hn::Add(value, hn::Set(d, 0.5f)));
    if constexpr (sizeof(hn::TFromV<V>) == 8)
        return hn::DemoteTo(di, floored);
    else
        return hn::ConvertTo(di, floored);
}

// kTogether pixels. All arrays are as long.
void packSome(const PlanePixels& pixels, const float* u, const float* v, const float* noise, std::uint32_t* row,
              std::uint32_t* fineVectors, std::uint16_t* fineNoise)
{
    using cpu::FineFlow;
    const D64 d;
    const hn::Rebind<float, D64> df;
    const hn::Rebind<std::int32_t, D64> di;
    const hn::Rebind<std::uint32_t, D64> du;
    const hn::Rebind<std::uint16_t, D64> d16;
    for (int i = 0; i < kTogether; i += int(hn::Lanes(d))) {
        const auto to = hn::PromoteTo(d, hn::LoadU(df, u + i));
        const Displacement by = displacementOf(pixels, to, hn::PromoteTo(d, hn::LoadU(df, v + i)));
        const auto flows = hn::IfThenElseZero(hn::RebindMask(d, by.finite), hn::Set(d, 1.0));
        const auto mask = hn::BitCast(du, hn::Neg(hn::DemoteTo(di, flows)));
        const auto sample = hn::LoadU(df, noise + i);
        const auto noiseByte = hn::Add(hn::Set(di, flow_texel::kNoiseZero),
                                       whole(hn::Mul(sample, hn::Set(df, float(flow_texel::kNoiseMost)))));
        const auto x = hn::ShiftLeft<flow_texel::kDxShift>(whole(by.x));
        const auto y = hn::ShiftLeft<flow_texel::kDyShift>(hn::And(whole(by.y), hn::Set(di, 0xFFF)));
        hn::StoreU(hn::And(hn::BitCast(du, hn::Or(hn::Or(x, y), noiseByte)), mask), du, row + i);
        if (!fineVectors) continue;
        // The number x is read with that of y below it.
        const V64 perUnit = hn::Set(d, FineFlow::kPerUnit);
        const auto low = hn::And(whole(hn::Mul(by.y, perUnit)), hn::Set(di, 0xFFFF));
        const V64 below = hn::Mul(hn::PromoteTo(d, low), hn::Set(d, 0x1p-16));
        const auto high = hn::ShiftLeft<16>(whole(hn::Sub(hn::Mul(by.x, perUnit), below)));
        hn::StoreU(hn::And(hn::BitCast(du, hn::Or(high, low)), mask), du, fineVectors + i);
        const auto noiseWord =
            hn::Add(hn::Set(di, FineFlow::kNoiseZero),
                    whole(hn::Mul(sample, hn::Set(df, float(flow_texel::kNoiseMost * FineFlow::kNoisePerByte)))));
        hn::StoreU(hn::DemoteTo(d16, noiseWord), d16, fineNoise + i);
    }
}

void packPixels(const PlanePixels& pixels, int width, std::uint32_t* row, std::uint32_t* fineVectors,
                std::uint16_t* fineNoise)
{
    float u[kTogether] = {}, v[kTogether] = {}, noise[kTogether] = {};
    std::uint32_t texels[kTogether], vectors[kTogether];
    std::uint16_t words[kTogether];
    for (int x = 0; x < width; x += kTogether) {
        const int count = std::min(kTogether, width - x);
        std::copy_n(pixels.u + x, count, u);
        std::copy_n(pixels.v + x, count, v);
        noiseOf(pixels, x, count, noise);
        packSome(pixels, u, v, noise, texels, fineVectors ? vectors : nullptr, words);
        std::copy_n(texels, count, row + x);
        if (!fineVectors) continue;
        std::copy_n(vectors, count, fineVectors + x);
        std::copy_n(words, count, fineNoise + x);
    }
}

void linkPixels(const std::uint32_t* above, const std::uint32_t* row, const std::uint32_t* below, int width,
                std::uint8_t* links)
{
    const auto bit = [](std::uint32_t texel, int which) { return texel != 0 ? 1u << which : 0u; };
    for (int x = 0; x < width; ++x) {
        const std::uint32_t bits = bit(above[x - 1], linkBit(-1, -1)) | bit(above[x], linkBit(0, -1)) |
                                   bit(above[x + 1], linkBit(1, -1)) | bit(row[x - 1], linkBit(-1, 0)) |
                                   bit(row[x + 1], linkBit(1, 0)) | bit(below[x - 1], linkBit(-1, 1)) |
                                   bit(below[x], linkBit(0, 1)) | bit(below[x + 1], linkBit(1, 1));
        links[x] = std::uint8_t(row[x] != 0 ? bits : 0u);
    }
}

}  // namespace aeolic::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic {

HWY_EXPORT(scalesOfRow);
HWY_EXPORT(packPixels);
HWY_EXPORT(linkPixels);

RowScales scalesOf(const float* u, const float* v, const float* texture, int width)
{
    return HWY_DYNAMIC_DISPATCH(scalesOfRow)(u, v, texture, width);
}

void packRow(const PlanePixels& pixels, int width, std::uint32_t* row, std::uint32_t* fineVectors,
             std::uint16_t* fineNoise)
{
    HWY_DYNAMIC_DISPATCH(packPixels)(pixels, width, row, fineVectors, fineNoise);
}

void linkRow(const std::uint32_t* above, const std::uint32_t* row, const std::uint32_t* below, int width,
             std::uint8_t* links)
{
    HWY_DYNAMIC_DISPATCH(linkPixels)(above, row, below, width, links);
}

}  // namespace aeolic
#endif
