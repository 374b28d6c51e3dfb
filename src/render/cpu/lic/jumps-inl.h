// Per-target include (Highway compiles it once per target): reading, joining and writing jumps.

#if defined(AEOLIC_RENDER_CPU_JUMPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_JUMPS_INL_H
#undef AEOLIC_RENDER_CPU_JUMPS_INL_H
#else
#define AEOLIC_RENDER_CPU_JUMPS_INL_H
#endif

#include <hwy/highway.h>

#include "render/cpu/lic/hierarchical.h"
#include "render/cpu/lic/sheets-inl.h"
#include "render/cpu/simd/prefetch.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// What a trace has gathered so far.
struct Walk {
    VF sum, lengthPx;   ///< Noise in bytes times pixels; pixels.
    VF cosSum, sinSum;  ///< Hann only: noise weighted by e^(i omega step).
};

HWY_INLINE Walk noWalk()
{
    const VF zero = hn::Zero(DF());
    return {zero, zero, zero, zero};
}

/// Signed 16-bit halves of a word, times 2^16: read without unpacking. The upper one comes with the lower one's bits
/// below it, and was rounded with them in mind (joinHalves).
HWY_INLINE VF lowHalf(VU v)
{
    return hn::ConvertTo(DF(), hn::ShiftLeft<16>(hn::BitCast(DI(), v)));
}
HWY_INLINE VF highHalf(VU v)
{
    return hn::ConvertTo(DF(), hn::BitCast(DI(), v));
}
inline constexpr float kHalfUnit = 1.0f / 65536.0f;

/// Whole numbers that fit 16 bits.
HWY_INLINE VI clampedHalf(VF v)
{
    return hn::Min(hn::Max(wholeNumber(v), hn::Set(DI(), -jump_word::kHalfMost)), hn::Set(DI(), jump_word::kHalfMost));
}
HWY_INLINE VU joinHalves(VF low, VF high)
{
    const VI lowBits = hn::And(clampedHalf(low), hn::Set(DI(), 0xFFFF));
    const VF below = hn::Mul(hn::ConvertTo(DF(), lowBits), hn::Set(DF(), kHalfUnit));
    return hn::BitCast(DU(), hn::Or(lowBits, hn::ShiftLeft<16>(clampedHalf(hn::Sub(high, below)))));
}

HWY_INLINE MU hasBit(VU meta, std::uint32_t bit)
{
    return hn::Ne(hn::And(meta, hn::Set(DU(), bit)), hn::Zero(DU()));
}
HWY_INLINE VF lengthWalked(VU meta)
{
    return hn::ConvertTo(DF(), hn::BitCast(DI(), hn::ShiftRight<jump_word::kLengthShift>(meta)));
}

/// Adds a jump's wave sums, turned by the steps walked before it: they count from the jump's own start.
HWY_INLINE void addWaves(VF cosSum, VF sinSum, Rotation by, MF use, Walk& walk)
{
    const DF d;
    const VF c = hn::Set(d, by.cosine), s = hn::Set(d, by.sine);
    walk.cosSum = hn::Add(walk.cosSum, hn::IfThenElseZero(use, hn::NegMulAdd(sinSum, s, hn::Mul(cosSum, c))));
    walk.sinSum = hn::Add(walk.sinSum, hn::IfThenElseZero(use, hn::MulAdd(cosSum, s, hn::Mul(sinSum, c))));
}

/// The jump of the pixels `at` themselves: the first of every trace, without interpolation.
template <bool kHann>
HWY_INLINE void firstJump(const JumpLevel& level, std::ptrdiff_t at, Traces& t, Walk& walk)
{
    const DF d;
    const DU du;
    VU place, meta;
    hn::LoadInterleaved2(du, reinterpret_cast<const std::uint32_t*>(level.jumps.origin() + at), place, meta);
    const VF unit = hn::Set(d, level.displacementUnitPx * kHalfUnit), sumUnit = hn::Set(d, level.sumUnit * kHalfUnit);
    t.dx = hn::Mul(lowHalf(place), unit);
    t.dy = hn::Mul(highHalf(place), unit);
    t.sheetX = t.dx;
    t.sheetY = t.dy;
    walk.sum = hn::Mul(lowHalf(meta), sumUnit);
    walk.lengthPx = hn::Mul(lengthWalked(meta), hn::Set(d, level.lengthUnitPx));
    if constexpr (kHann) {
        const VU wave = hn::LoadU(du, level.waves.origin() + at);
        addWaves(hn::Mul(lowHalf(wave), sumUnit), hn::Mul(highHalf(wave), sumUnit), {}, t.alive, walk);
    }
    t.alive = hn::And(t.alive, hn::RebindMask(d, hasBit(meta, jump_word::kAliveBit)));
}

/// Jumps that traces from the pixels `at` look up `rows` below, and will be looked up there soon.
template <bool kHann>
HWY_INLINE void prefetchBelow(const JumpLevel& level, std::ptrdiff_t at, int rows)
{
    cpu::prefetchBelow(level.jumps, at, rows, hn::Lanes(DF()));
    if constexpr (kHann) cpu::prefetchBelow(level.waves, at, rows, hn::Lanes(DF()));
}

/// Jumps that are stored soon.
template <bool kHann>
HWY_INLINE void prefetchToWrite(const JumpLevel& level, std::ptrdiff_t at)
{
    cpu::prefetchToWrite(level.jumps, at, hn::Lanes(DF()));
    if constexpr (kHann) cpu::prefetchToWrite(level.waves, at, hn::Lanes(DF()));
}

/// Background: a jump that goes nowhere.
template <bool kHann>
HWY_INLINE void storeNoJump(JumpLevel& level, std::ptrdiff_t at)
{
    const VU zero = hn::Zero(DU());
    hn::StoreInterleaved2(zero, zero, DU(), reinterpret_cast<std::uint32_t*>(level.jumps.origin() + at));
    if constexpr (kHann) hn::StoreU(zero, DU(), level.waves.origin() + at);
}

/// Packs what the traces have walked as jumps of `level` at the pixels `at`.
template <bool kHann>
HWY_INLINE void storeJump(JumpLevel& level, std::ptrdiff_t at, const Traces& t, const Walk& walk, MU isOpen)
{
    const DF d;
    const DI di;
    const DU du;
    const auto scaled = [&](VF v, float unit) AEOLIC_INLINE { return hn::Mul(v, hn::Set(d, 1.0f / unit)); };
    const VU place = joinHalves(scaled(t.dx, level.displacementUnitPx), scaled(t.dy, level.displacementUnitPx));
    const VU open = hn::IfThenElseZero(isOpen, hn::Set(du, jump_word::kOpenBit));
    const VU alive = hn::IfThenElseZero(hn::RebindMask(du, t.alive), hn::Set(du, jump_word::kAliveBit));
    const VU length = hn::ShiftLeft<jump_word::kLengthShift>(
        hn::BitCast(du, hn::Min(wholeNumber(hn::Mul(walk.lengthPx, hn::Set(d, 1.0f / level.lengthUnitPx))),
                                hn::Set(di, jump_word::kLengthMost))));
    const VU sum = hn::BitCast(du, hn::And(clampedHalf(scaled(walk.sum, level.sumUnit)), hn::Set(di, 0xFFFF)));
    const VU meta = hn::Or(hn::Or(sum, open), hn::Or(alive, length));
    hn::StoreInterleaved2(place, meta, du, reinterpret_cast<std::uint32_t*>(level.jumps.origin() + at));
    if constexpr (kHann)
        hn::StoreU(joinHalves(scaled(walk.cosSum, level.sumUnit), scaled(walk.sinSum, level.sumUnit)), du,
                   level.waves.origin() + at);
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
