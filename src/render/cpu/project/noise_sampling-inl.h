// Per-target include (Highway compiles it once per target): the noise pyramid at P-space positions.

#if defined(AEOLIC_RENDER_CPU_NOISE_SAMPLING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_NOISE_SAMPLING_INL_H
#undef AEOLIC_RENDER_CPU_NOISE_SAMPLING_INL_H
#else
#define AEOLIC_RENDER_CPU_NOISE_SAMPLING_INL_H
#endif

#include <hwy/highway.h>

#include "render/cpu/simd/simd-inl.h"
#include "render/lic/noise.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The face between the texels in the lowest four bits of each lane: a + b x + c y + d x y.
template <class D, class VU, class V = hn::Vec<D>>
HWY_INLINE Block4<V> noiseFace(D df, VU bits)
{
    if constexpr (hn::MaxLanes(df) == 16) {
        alignas(64) static constexpr float kA[16] = {-1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1};
        alignas(64) static constexpr float kB[16] = {0, -2, 2, 0, 0, -2, 2, 0, 0, -2, 2, 0, 0, -2, 2, 0};
        alignas(64) static constexpr float kC[16] = {0, -2, 0, -2, 2, 0, 2, 0, 0, -2, 0, -2, 2, 0, 2, 0};
        alignas(64) static constexpr float kD[16] = {0, 2, -2, 0, -2, 0, -4, -2, 2, 4, 0, 2, 0, 2, -2, 0};
        const auto index = hn::IndicesFromVec(df, hn::And(bits, hn::Set(hn::DFromV<VU>(), 15u)));
        const auto of = [&](const float* table) { return hn::TableLookupLanes(hn::Load(df, table), index); };
        return {of(kA), of(kB), of(kC), of(kD)};
    } else {
        const hn::RebindToSigned<D> di;
        const auto texel = [&](int k) {
            const auto bit = hn::And(hn::ShiftRightSame(bits, k), hn::Set(hn::DFromV<VU>(), 1u));
            return hn::ConvertTo(df, hn::Sub(hn::Add(hn::BitCast(di, bit), hn::BitCast(di, bit)), hn::Set(di, 1)));
        };
        const V a = texel(0), b = hn::Sub(texel(1), a), c = hn::Sub(texel(2), a);
        return {a, b, c, hn::Sub(hn::Sub(texel(3), texel(2)), b)};
    }
}

/// The cosine or the sine of a grain's phase, as grains::phaseOf() tells it: of the one grain that a cell can have.
/// `corners`: the cell's texels, a bit each, of which the first is at x, y and z. Anything where there is no grain.
template <class D, class VU, class VI, class V = hn::Vec<D>>
HWY_INLINE V grainPhase(D d, GrainValue value, VU corners, VI x, VI y, VI z)
{
    const hn::RebindToSigned<D> di;
    const hn::RebindToUnsigned<D> du;
    // `farther`: the corners that are one texel on in this direction.
    const auto texelOf = [&](VI first, std::uint32_t farther) AEOLIC_INLINE {
        const auto isNext = hn::Ne(hn::And(corners, hn::Set(du, farther)), hn::Zero(du));
        const auto next = hn::Sub(first, hn::VecFromMask(di, hn::RebindMask(di, isNext)));
        return hn::BitCast(du, hn::And(next, hn::Set(di, NoisePyramid::kSize - 1)));
    };
    static_assert(NoisePyramid::kSize == 64);
    auto hash =
        hn::Or(texelOf(x, 0xAAu), hn::Or(hn::ShiftLeft<6>(texelOf(y, 0xCCu)), hn::ShiftLeft<12>(texelOf(z, 0xF0u))));
    hash = hn::Mul(hash, hn::Set(du, grains::kHashFirst));
    hash = hn::Mul(hn::Xor(hash, hn::ShiftRight<15>(hash)), hn::Set(du, grains::kHashSecond));
    static_assert(grains::kPhases == 16);
    const auto quarters = hn::Set(du, value == GrainValue::sine ? 12u : 0u);
    const auto phase = hn::And(hn::Add(hn::ShiftRight<28>(hash), quarters), hn::Set(du, 15u));
    return hn::GatherIndex(d, grains::kWave.data(), hn::BitCast(di, phase));
}

/// Trilinear noise of one level, -1 to 1; `texel` in that level's texels. Of grains with a phase: 0 to 1, times the
/// phase's cosine or sine.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V noiseLevel(D d, const NoisePyramid& noise, GrainValue value, const Vec3v<V>& texel)
{
    const hn::RebindToSigned<D> di;
    const hn::RebindToUnsigned<D> du;
    const auto fx = hn::Floor(texel.x), fy = hn::Floor(texel.y), fz = hn::Floor(texel.z);
    const auto wrap = hn::Set(di, NoisePyramid::kSize - 1);
    const auto ix = hn::And(hn::ConvertTo(di, fx), wrap), iy = hn::And(hn::ConvertTo(di, fy), wrap),
               iz = hn::And(hn::ConvertTo(di, fz), wrap);
    static_assert(NoisePyramid::kSize == 64);
    const auto at = hn::Add(hn::ShiftLeft<6>(hn::Add(hn::ShiftLeft<6>(iz), iy)), ix);
    const auto corners = hn::GatherOffset(du, reinterpret_cast<const std::uint32_t*>(noise.cells.data()), at);
    const auto wx = hn::Sub(texel.x, fx), wy = hn::Sub(texel.y, fy), wz = hn::Sub(texel.z, fz);
    const auto blend = [&](const Block4<V>& f) {
        return hn::MulAdd(hn::MulAdd(f.d, wx, f.c), wy, hn::MulAdd(f.b, wx, f.a));
    };
    const V level = lerp(blend(noiseFace(d, corners)), blend(noiseFace(d, hn::ShiftRight<4>(corners))), wz);
    if (value != GrainValue::cosine && value != GrainValue::sine) return level;
    const V share = hn::MulAdd(level, hn::Set(d, 0.5f), hn::Set(d, 0.5f));
    return hn::Mul(share, grainPhase(d, value, corners, ix, iy, iz));
}

/// How much the coarser level of grains counts; `m` is 1 to 2 within an octave.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V grainBlend(D d, V m)
{
    const V slope = hn::Set(d, 1.0f / (grains::kBlendTo - grains::kBlendFrom));
    const V blend = hn::Mul(hn::Sub(m, hn::Set(d, grains::kBlendFrom)), slope);
    return hn::Min(hn::Max(blend, hn::Zero(d)), hn::Set(d, 1.0f));
}

/// Noise of grains, 1 or -1 where there is none, as their height above the mean; `m` as above. That of grains with a
/// phase has no mean.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V grainHeight(D d, GrainValue value, V noise, V m, float height)
{
    const V above =
        value == GrainValue::height ? hn::MulAdd(noise, hn::Set(d, 0.5f), hn::Set(d, 0.5f - grains::kShare)) : noise;
    return hn::Mul(above, hn::Mul(m, hn::Set(d, height)));
}

/// Noise at P-space positions for a footprint (world units): the levels o and o + 1 with 2^o <= footprint < 2^(o+1),
/// blended, with the contrast of a single level restored. Grains: 0 to 1, less their mean.
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
    const auto one = hn::Set(d, 1.0f);
    const bool hasGrains = lookup.grains != GrainValue::none;
    const auto blend = hasGrains ? grainBlend(d, mantissa) : hn::Sub(mantissa, one);
    const auto shrink = hn::BitCast(d, hn::ShiftLeft<23>(hn::Sub(hn::Set(di, 127), exponent)));  // 2^-exponent
    const auto level = hn::ConvertTo(d, exponent);
    const auto at = [&](auto o, auto factor) {
        const auto shift = [&](int c) { return hn::Mul(o, hn::Set(d, float(kNoiseLevelOffset[std::size_t(c)]))); };
        return Vec3v<V>{hn::MulAdd(texel.x, factor, shift(0)), hn::MulAdd(texel.y, factor, shift(1)),
                        hn::MulAdd(texel.z, factor, shift(2))};
    };
    auto fine = noiseLevel(d, noise, lookup.grains, at(level, shrink));
    auto coarse = noiseLevel(d, noise, lookup.grains, at(hn::Add(level, one), hn::Mul(shrink, hn::Set(d, 0.5f))));
    const auto keep = hn::Sub(one, blend);
    if (hasGrains) {
        fine = grainHeight(d, lookup.grains, fine, mantissa, grains::kHeight);
        coarse = grainHeight(d, lookup.grains, coarse, mantissa, 0.5f * grains::kHeight);
    }
    const auto power = hn::MulAdd(keep, keep, hn::Mul(blend, blend));
    return hn::Mul(hn::MulAdd(coarse, blend, hn::Mul(fine, keep)), inverseLength(d, power));
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
