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
    VF sum, lengthPx;  ///< Noise in bytes times pixels; pixels. Both weighted by the width.
    VF width;          ///< The least of the stream tube so far, beside that at the start.
    VF first, second;  ///< Noise weighted by the kernel's pair (KernelModel), where it has one.
};

HWY_INLINE Walk noWalk()
{
    const VF zero = hn::Zero(DF());
    return {zero, zero, hn::Set(DF(), 1.0f), zero, zero};
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

/// `v` rounded to whole numbers, none below `least` or above `most`.
HWY_INLINE VI clampedWhole(VF v, int least, int most)
{
    return hn::Min(hn::Max(wholeNumber(v), hn::Set(DI(), least)), hn::Set(DI(), most));
}

HWY_INLINE VU joinHalves(VF low, VF high)
{
    const auto clampedHalf = [](VF v)
                                 AEOLIC_INLINE { return clampedWhole(v, -jump_word::kHalfMost, jump_word::kHalfMost); };
    const VI lowBits = hn::And(clampedHalf(low), hn::Set(DI(), 0xFFFF));
    const VF below = hn::Mul(hn::ConvertTo(DF(), lowBits), hn::Set(DF(), kHalfUnit));
    return hn::BitCast(DU(), hn::Or(lowBits, hn::ShiftLeft<16>(clampedHalf(hn::Sub(high, below)))));
}

HWY_INLINE MU hasBit(VU meta, std::uint32_t bit)
{
    return hn::Ne(hn::And(meta, hn::Set(DU(), bit)), hn::Zero(DU()));
}

HWY_INLINE VU withoutOpenBit(VU meta)
{
    return hn::And(meta, hn::Set(DU(), ~jump_word::kOpenBit));
}

/// The fields of jump_word without its open bit, each with the bits below it, in kLengthUnit, kSumUnit, kWidthUnit.
HWY_INLINE VF lengthField(VU meta)
{
    return hn::ConvertTo(DF(), hn::BitCast(DI(), hn::And(meta, hn::Set(DU(), (1u << jump_word::kSumShift) - 1))));
}
HWY_INLINE VF sumField(VU meta)
{
    return hn::ConvertTo(DF(), hn::BitCast(DI(), hn::ShiftLeft<32 - jump_word::kWidthShift>(meta)));
}
HWY_INLINE VF widthField(VU meta)
{
    return hn::ConvertTo(DF(), hn::BitCast(DI(), hn::ShiftRight<jump_word::kWidthShift>(meta)));
}
inline constexpr float kLengthUnit = 1.0f / float(1 << jump_word::kLengthShift);
inline constexpr float kSumUnit = 1.0f / float(1 << (jump_word::kSumShift + 32 - jump_word::kWidthShift));
inline constexpr float kWidthUnit = 1.0f / float(jump_word::kWidthOne);

/// All fields in one word. Each counts the bits below it as a fraction of its own unit, the open bit apart.
HWY_INLINE VU packJump(VU open, VU alive, VF length, VF sum, VF width)
{
    const DF d;
    const DI di;

    const auto below = [&](VI bits, int shift) AEOLIC_INLINE {
        return hn::Mul(hn::ConvertTo(d, bits), hn::Set(d, 1.0f / float(1 << shift)));
    };
    VI word = hn::BitCast(di, alive);
    const VI lengthBits =
        clampedWhole(hn::Sub(length, below(word, jump_word::kLengthShift)), 0, jump_word::kLengthMost);
    word = hn::Or(word, hn::ShiftLeft<jump_word::kLengthShift>(lengthBits));
    const VI sumBits =
        clampedWhole(hn::Sub(sum, below(word, jump_word::kSumShift)), -jump_word::kSumMost, jump_word::kSumMost);
    const VI sumMask = hn::Set(di, 2 * jump_word::kSumMost + 1);
    word = hn::Or(word, hn::ShiftLeft<jump_word::kSumShift>(hn::And(sumBits, sumMask)));
    const VI widthBits = clampedWhole(hn::Mul(width, hn::Set(d, float(jump_word::kWidthOne))), 0, jump_word::kWidthOne);
    return hn::Or(open, hn::BitCast(DU(), hn::Or(word, hn::ShiftLeft<jump_word::kWidthShift>(widthBits))));
}

/// Adds a jump's weighted sums, turned by the steps walked before it: they count from the jump's own start.
HWY_INLINE void addWeighted(VF first, VF second, const Turn& by, MF use, Walk& walk)
{
    const DF d;
    const auto turned = [&](VF same, float ofSame, VF other, float ofOther) AEOLIC_INLINE {
        return hn::IfThenElseZero(use, hn::MulAdd(other, hn::Set(d, ofOther), hn::Mul(same, hn::Set(d, ofSame))));
    };
    walk.first = hn::Add(walk.first, turned(first, by.aa, second, by.ab));
    walk.second = hn::Add(walk.second, turned(second, by.bb, first, by.ba));
}

/// The jump of the pixels `at` themselves: the first of every trace, without interpolation.
template <bool kWeighted>
HWY_INLINE void firstJump(const JumpLevel& level, std::ptrdiff_t at, Traces& t, Walk& walk)
{
    const DF d;
    const DU du;
    VU place, meta;
    hn::LoadInterleaved2(du, reinterpret_cast<const std::uint32_t*>(level.jumps.origin() + at), place, meta);
    meta = withoutOpenBit(meta);
    const VF unit = hn::Set(d, level.units.displacementPx * kHalfUnit);
    t.dx = hn::Mul(lowHalf(place), unit);
    t.dy = hn::Mul(highHalf(place), unit);
    t.sheetX = t.dx;
    t.sheetY = t.dy;
    walk.sum = hn::Mul(sumField(meta), hn::Set(d, level.units.sum * kSumUnit));
    walk.lengthPx = hn::Mul(lengthField(meta), hn::Set(d, level.units.lengthPx * kLengthUnit));
    walk.width = hn::Mul(widthField(meta), hn::Set(d, kWidthUnit));
    if constexpr (kWeighted) {
        const VU weighted = hn::LoadU(du, level.weighted.origin() + at);
        const VF weightedUnit = hn::Set(d, level.units.weighted * kHalfUnit);
        addWeighted(hn::Mul(lowHalf(weighted), weightedUnit), hn::Mul(highHalf(weighted), weightedUnit), {}, t.alive,
                    walk);
    }
    t.alive = hn::And(t.alive, hn::RebindMask(d, hasBit(meta, jump_word::kAliveBit)));
}

/// Jumps that traces from the pixels `at` look up `rows` below, and will be looked up there soon.
template <bool kWeighted>
HWY_INLINE void prefetchBelow(const JumpLevel& level, std::ptrdiff_t at, int rows)
{
    cpu::prefetchBelow(level.jumps, at, rows, hn::Lanes(DF()));
    if constexpr (kWeighted) cpu::prefetchBelow(level.weighted, at, rows, hn::Lanes(DF()));
}

/// Jumps that are stored soon.
template <bool kWeighted>
HWY_INLINE void prefetchToWrite(const JumpLevel& level, std::ptrdiff_t at)
{
    cpu::prefetchToWrite(level.jumps, at, hn::Lanes(DF()));
    if constexpr (kWeighted) cpu::prefetchToWrite(level.weighted, at, hn::Lanes(DF()));
}

/// Background: a jump that goes nowhere.
template <bool kWeighted>
HWY_INLINE void storeNoJump(JumpLevel& level, std::ptrdiff_t at)
{
    const VU zero = hn::Zero(DU());
    hn::StoreInterleaved2(zero, zero, DU(), reinterpret_cast<std::uint32_t*>(level.jumps.origin() + at));
    if constexpr (kWeighted) hn::StoreU(zero, DU(), level.weighted.origin() + at);
}

/// Packs what the traces have walked as jumps of `level` at the pixels `at`. Those without flow become zeros on every
/// rank: rows that are received have zeros there, too.
template <bool kWeighted>
HWY_INLINE void storeJump(JumpLevel& level, std::ptrdiff_t at, const Traces& t, const Walk& walk, MU isOpen, MF hasFlow)
{
    const DF d;
    const DU du;
    const auto scaled = [&](VF v, float unit) AEOLIC_INLINE { return hn::Mul(v, hn::Set(d, 1.0f / unit)); };
    const VU place = joinHalves(scaled(t.dx, level.units.displacementPx), scaled(t.dy, level.units.displacementPx));
    const VU open = hn::IfThenElseZero(isOpen, hn::Set(du, jump_word::kOpenBit));
    const VU alive = hn::IfThenElseZero(hn::RebindMask(du, t.alive), hn::Set(du, jump_word::kAliveBit));
    const VU packed = packJump(open, alive, scaled(walk.lengthPx, level.units.lengthPx),
                               scaled(walk.sum, level.units.sum), walk.width);
    const VU meta = hn::IfThenElseZero(hn::RebindMask(du, hasFlow), packed);
    hn::StoreInterleaved2(place, meta, du, reinterpret_cast<std::uint32_t*>(level.jumps.origin() + at));
    if constexpr (kWeighted)
        hn::StoreU(joinHalves(scaled(walk.first, level.units.weighted), scaled(walk.second, level.units.weighted)), du,
                   level.weighted.origin() + at);
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
