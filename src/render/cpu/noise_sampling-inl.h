// Per-target include (Highway compiles it once per target): the noise pyramid at P-space positions.

#if defined(AEOLIC_RENDER_CPU_NOISE_SAMPLING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_NOISE_SAMPLING_INL_H
#undef AEOLIC_RENDER_CPU_NOISE_SAMPLING_INL_H
#else
#define AEOLIC_RENDER_CPU_NOISE_SAMPLING_INL_H
#endif

#include <hwy/highway.h>

#include "render/cpu/simd-inl.h"
#include "render/noise.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Trilinear noise (-1 … 1) of one level; `texel` in that level's texels. One 64-bit gather brings the eight corners.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V noiseLevel(D d, const NoisePyramid& noise, const Vec3v<V>& texel)
{
    const hn::RebindToSigned<D> di;
    const hn::RebindToUnsigned<D> du;
    const auto fx = hn::Floor(texel.x), fy = hn::Floor(texel.y), fz = hn::Floor(texel.z);
    const auto wrap = hn::Set(di, NoisePyramid::kSize - 1);
    const auto ix = hn::And(hn::ConvertTo(di, fx), wrap), iy = hn::And(hn::ConvertTo(di, fy), wrap),
               iz = hn::And(hn::ConvertTo(di, fz), wrap);
    static_assert(NoisePyramid::kSize == 64);
    const auto cell = hn::Add(hn::ShiftLeft<6>(hn::Add(hn::ShiftLeft<6>(iz), iy)), ix);
    const auto corners = gatherWords(du, noise.cells.data(), widen(d, hn::ShiftLeft<3>(cell)), 0);
    const auto byte = [&](auto word, int k) {
        return hn::ConvertTo(d, hn::BitCast(di, hn::And(hn::ShiftRightSame(word, 8 * k), hn::Set(du, 0xFFu))));
    };
    const auto wx = hn::Sub(texel.x, fx), wy = hn::Sub(texel.y, fy), wz = hn::Sub(texel.z, fz);
    const auto face = [&](auto word) {
        return lerp(lerp(byte(word, 0), byte(word, 1), wx), lerp(byte(word, 2), byte(word, 3), wx), wy);
    };
    const auto value = lerp(face(corners.first), face(corners.second), wz);
    return hn::Mul(hn::Sub(value, hn::Set(d, 128.0f)), hn::Set(d, 1.0f / 127.0f));
}

/// Noise at P-space positions for a footprint (world units): the levels o and o + 1 with 2^o <= footprint < 2^(o+1),
/// blended in proportion, with the contrast of a single level restored.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V sampleNoise(D d, const NoisePyramid& noise, const NoiseLookup& lookup, const Vec3v<V>& local, V footprint)
{
    const hn::RebindToSigned<D> di;
    const auto row = [&](int r) {
        const auto& m = lookup.texelFromLocal;
        return hn::MulAdd(
            local.x, hn::Set(d, float(m[0][r])),
            hn::MulAdd(local.y, hn::Set(d, float(m[1][r])), hn::Mul(local.z, hn::Set(d, float(m[2][r])))));
    };
    const Vec3v<V> texel{row(0), row(1), row(2)};
    const auto bits = hn::BitCast(di, hn::Mul(footprint, hn::Set(d, float(lookup.levelFromFootprint))));
    const auto exponent = hn::Sub(hn::ShiftRight<23>(bits), hn::Set(di, 127));
    const auto mantissa = hn::BitCast(d, hn::Or(hn::And(bits, hn::Set(di, 0x007FFFFF)), hn::Set(di, 0x3F800000)));
    const auto blend = hn::Sub(mantissa, hn::Set(d, 1.0f));
    const auto shrink = hn::BitCast(d, hn::ShiftLeft<23>(hn::Sub(hn::Set(di, 127), exponent)));  // 2^-exponent
    const auto level = hn::ConvertTo(d, exponent);
    const auto at = [&](auto o, auto factor) {
        const auto shift = [&](int c) { return hn::Mul(o, hn::Set(d, float(kNoiseLevelOffset[std::size_t(c)]))); };
        return Vec3v<V>{hn::MulAdd(texel.x, factor, shift(0)), hn::MulAdd(texel.y, factor, shift(1)),
                        hn::MulAdd(texel.z, factor, shift(2))};
    };
    const auto fine = noiseLevel(d, noise, at(level, shrink));
    const auto coarse = noiseLevel(d, noise, at(hn::Add(level, hn::Set(d, 1.0f)), hn::Mul(shrink, hn::Set(d, 0.5f))));
    const auto keep = hn::Sub(hn::Set(d, 1.0f), blend);
    const auto power = hn::MulAdd(keep, keep, hn::Mul(blend, blend));
    return hn::Mul(hn::MulAdd(coarse, blend, hn::Mul(fine, keep)), inverseLength(d, power));
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
