// Per-target include (Highway compiles it once per target): following streamlines jump by jump.

#if defined(AEOLIC_RENDER_CPU_JUMP_WALKER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_JUMP_WALKER_INL_H
#undef AEOLIC_RENDER_CPU_JUMP_WALKER_INL_H
#else
#define AEOLIC_RENDER_CPU_JUMP_WALKER_INL_H
#endif

#include <hwy/highway.h>

#include "render/cpu/lic/jumps-inl.h"
#include "render/cpu/lic/sheets-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Jumps around where traces are, on their way from memory.
struct JumpLookup {
    Taps taps;
    VI at;
    Block4<VU> upper, lower;  ///< Place and meta of (0,0), place and meta of (1,0); of (0,1) and (1,1).
};

/// What traces gather on a jump, in the level's units: not counted yet.
struct JumpGain {
    VF sum, length, width;
    MF reached;         ///< Not ended on the way to the jump: gains what it walks, though it may end on it.
    Block4<VF> weight;  ///< Of the taps at `at`, for their weighted sums.
    VI at;
};

HWY_INLINE JumpGain noGain()
{
    const VF zero = hn::Zero(DF());
    return {zero, zero, zero, hn::MaskFromVec(zero), {zero, zero, zero, zero}, hn::Zero(DI())};
}

HWY_INLINE JumpLookup lookUpJump(const JumpLevel& level, const LinkImage& links, const Traces& t)
{
    const DU du;
    JumpLookup look;
    look.taps = findTaps(t.dx, t.dy);
    look.at = links.index(t, look.taps);
    const auto* words = reinterpret_cast<const std::uint32_t*>(links.base(level.jumps));
    loadBlocksTwice<2>(du, words, words + 2 * links.stride, look.at, look.upper, look.lower);
    weigh(look.taps);
    return look;
}

/// Moves the traces along the jump, interpolated among taps of their sheet that got as far as the nearest one did.
HWY_INLINE void moveByJump(const JumpLevel& level, JumpLookup& look, const LinkImage& links, Traces& t, JumpGain& gain)
{
    const DF d;
    const DU du;
    Taps& taps = look.taps;
    const Block4<VU>&upper = look.upper, &lower = look.lower;
    const VU allMeta = hn::And(hn::And(upper.b, upper.d), hn::And(lower.b, lower.d));
    const VU openAndAlive = hn::Set(du, jump_word::kOpenBit | jump_word::kAliveBit);
    const MU open = hn::Eq(hn::And(allMeta, openAndAlive), openAndAlive);
    const MF uneven = hn::RebindMask(d, hn::Not(hasBit(allMeta, jump_word::kAliveBit)));
    moveAlongLinks(links, t.dx, t.dy, open, float(limits::kOpenReachPx), uneven, taps, t);
    gain.reached = t.alive;
    if (HWY_UNLIKELY(taps.anyPartial)) {
        // A trace goes on where most of its taps do, and then with those alone: the others would drag it back. A tap
        // without weight has no say, not even by rounding: it may lie where a rank has nothing.
        const Block4<VF> weight = taps.weight;
        const auto aliveOf = [&](VU meta)
                                 AEOLIC_INLINE { return hn::RebindMask(d, hasBit(meta, jump_word::kAliveBit)); };
        const MF alive00 = aliveOf(upper.b), alive10 = aliveOf(upper.d), alive01 = aliveOf(lower.b),
                 alive11 = aliveOf(lower.d);
        const auto total = [](VF w00, VF w10, VF w01, VF w11)
                               AEOLIC_INLINE { return hn::Add(hn::Add(hn::Add(w00, w10), w01), w11); };
        const VF going = total(hn::IfThenElseZero(alive00, weight.a), hn::IfThenElseZero(alive10, weight.b),
                               hn::IfThenElseZero(alive01, weight.c), hn::IfThenElseZero(alive11, weight.d));
        const VF ending = total(hn::IfThenZeroElse(alive00, weight.a), hn::IfThenZeroElse(alive10, weight.b),
                                hn::IfThenZeroElse(alive01, weight.c), hn::IfThenZeroElse(alive11, weight.d));
        const MF goesOn = hn::Ge(going, hn::Set(d, 0.5f));
        t.alive = hn::And(t.alive, goesOn);
        const MF others = hn::Gt(hn::IfThenElse(goesOn, ending, going), hn::Zero(d));
        const VF inverse =
            hn::Div(hn::Set(d, 1.0f), hn::IfThenElse(goesOn, going, hn::Max(ending, hn::Set(d, limits::kLeastWeight))));
        const auto among = [&](VF whole, MF isAlive) AEOLIC_INLINE {
            const MF same = hn::Not(hn::Xor(goesOn, isAlive));
            return hn::IfThenElse(others, hn::IfThenElseZero(same, hn::Mul(whole, inverse)), whole);
        };
        taps.weight = {among(weight.a, alive00), among(weight.b, alive10), among(weight.c, alive01),
                       among(weight.d, alive11)};
    }
    const auto blend = [&](auto field) AEOLIC_INLINE {
        return blendTaps(taps.weight, field(upper.a), field(upper.c), field(lower.a), field(lower.c));
    };
    const VF dx = blend([](VU v) AEOLIC_INLINE { return lowHalf(v); }),
             dy = blend([](VU v) AEOLIC_INLINE { return highHalf(v); });
    // The pixel on which the nearest tap's own trace ended is on the sheet for certain: the interpolated end is checked
    // against it. No end is further away than that of some tap's jump from here: so guards have it, and the few rows
    // around it that the sheet's pixel needs.
    const VU nearestPlace = taps.pick(upper.a, upper.c, lower.a, lower.c);
    const VF zero = hn::Zero(d), one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
    const VF go = hn::IfThenElseZero(t.alive, hn::Set(d, level.units.displacementPx * kHalfUnit));
    const auto fromCell = [&](VF weight) AEOLIC_INLINE {
        return hn::Sub(hn::IfThenElse(hn::Ge(weight, half), one, zero), weight);
    };
    const VF cellX = fromCell(taps.wx), cellY = fromCell(taps.wy);
    t.sheetX = hn::MulAdd(lowHalf(nearestPlace), go, hn::Add(t.dx, cellX));
    t.sheetY = hn::MulAdd(highHalf(nearestPlace), go, hn::Add(t.dy, cellY));
    const VF endX = hn::MulAdd(dx, go, t.dx), endY = hn::MulAdd(dy, go, t.dy);
    // Where neighbours part (a separation line, an edge of the surface) their mean lies on neither's way: go as the
    // nearest does.
    const VF apart = hn::Max(hn::Abs(hn::Sub(endX, t.sheetX)), hn::Abs(hn::Sub(endY, t.sheetY)));
    const MF together = hn::Le(apart, hn::Set(d, float(limits::kTogetherPx)));
    t.dx = hn::IfThenElse(together, endX, hn::Sub(t.sheetX, cellX));
    t.dy = hn::IfThenElse(together, endY, hn::Sub(t.sheetY, cellY));
    const VU meta00 = withoutOpenBit(upper.b), meta10 = withoutOpenBit(upper.d), meta01 = withoutOpenBit(lower.b),
             meta11 = withoutOpenBit(lower.d);
    const auto metas = [&](auto field) AEOLIC_INLINE {
        return blendTaps(taps.weight, field(meta00), field(meta10), field(meta01), field(meta11));
    };
    gain.sum = metas([](VU v) AEOLIC_INLINE { return sumField(v); });
    gain.length = metas([](VU v) AEOLIC_INLINE { return lengthField(v); });
    gain.width = metas([](VU v) AEOLIC_INLINE { return widthField(v); });
    gain.weight = taps.weight;
    gain.at = look.at;
}

/// Adds what the traces gather on a jump.
template <bool kWeighted>
HWY_INLINE void countJump(const JumpLevel& level, const JumpGain& gain, const LinkImage& links, Turn turn, Walk& walk)
{
    const DF d;
    const DU du;
    // The jump's weights count from its own start.
    const VF width = hn::IfThenElseZero(gain.reached, walk.width);
    walk.sum = hn::MulAdd(hn::Mul(gain.sum, hn::Set(d, level.units.sum * kSumUnit)), width, walk.sum);
    walk.lengthPx =
        hn::MulAdd(hn::Mul(gain.length, hn::Set(d, level.units.lengthPx * kLengthUnit)), width, walk.lengthPx);
    walk.width = hn::IfThenElse(gain.reached, hn::Mul(width, hn::Mul(gain.width, hn::Set(d, kWidthUnit))), walk.width);
    if constexpr (kWeighted) {
        const auto* from = links.base(level.weighted);
        const VU w00 = hn::GatherIndex(du, from, gain.at), w10 = hn::GatherIndex(du, from + 1, gain.at);
        const VU w01 = hn::GatherIndex(du, from + links.stride, gain.at),
                 w11 = hn::GatherIndex(du, from + links.stride + 1, gain.at);
        const auto weighted = [&](auto field) AEOLIC_INLINE {
            return blendTaps(gain.weight, field(w00), field(w10), field(w01), field(w11));
        };
        const VF weightedUnit = hn::Mul(width, hn::Set(d, level.units.weighted * kHalfUnit));
        addWeighted(hn::Mul(weightedUnit, weighted([](VU v) AEOLIC_INLINE { return lowHalf(v); })),
                    hn::Mul(weightedUnit, weighted([](VU v) AEOLIC_INLINE { return highHalf(v); })), turn, gain.reached,
                    walk);
    }
}

/// A trace in one direction, jump by jump.
template <bool kWeighted>
struct JumpWalker {
    Traces trace;
    Walk walk;
    JumpGain gain;                         // What the last jump brought, not counted yet.
    const JumpLevel* uncounted = nullptr;  // The level of that jump; null once it is counted.
    Turn turn;                             // At the start of that jump.

    // Takes the jump that was looked up for it. The one before is counted only now, while this one is on its way: what
    // they wait for must not wait for it.
    HWY_INLINE void next(const JumpLevel& level, JumpLookup& look, const LinkImage& links, Turn by)
    {
        count(links);
        moveByJump(level, look, links, trace, gain);
        uncounted = &level;
        turn = by;
    }

    HWY_INLINE void count(const LinkImage& links)
    {
        if (uncounted) countJump<kWeighted>(*uncounted, gain, links, turn, walk);
        uncounted = nullptr;
    }
};

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
