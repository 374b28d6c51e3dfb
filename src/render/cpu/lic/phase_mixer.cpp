#include "render/cpu/lic/phase_mixer.h"

#include <utility>

#include "base/parallel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/lic/phase_mixer.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/simd/simd-inl.h"

#ifndef AEOLIC_RENDER_CPU_LIC_PHASE_MIXER_ONCE
#define AEOLIC_RENDER_CPU_LIC_PHASE_MIXER_ONCE
namespace aeolic::cpu {
namespace {

/// What comets of a row are mixed from.
struct StreakRow {
    std::array<const float*, phase_mix::kMostRuns> runs;
    const std::uint32_t* flow;
    ColumnSpan columns;
};

}  // namespace
}  // namespace aeolic::cpu
#endif

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// How bright a streak is at x, and where along it the pixel lies: a number of the complex plane of that length.
struct Streak {
    VF re, im, bright;
};
HWY_INLINE Streak streakAt(const StreakRow& row, int x)
{
    const DF d;
    const auto at = [&](std::size_t which) AEOLIC_INLINE { return hn::LoadU(d, row.runs[which] + x); };
    const VF re = hn::Sub(at(0), at(3)), im = hn::Neg(hn::Add(at(1), at(2)));
    return {re, im, hn::Sqrt(hn::MulAdd(re, re, hn::Mul(im, im)))};
}

// Stores value(x) in the columns of a row that have flow, and 0 in the others. The last vector may reach beyond the
// columns, where there is no flow.
template <class Value>
HWY_INLINE void fillRow(const StreakRow& row, float* out, const Value& value)
{
    const DF d;
    const DU du;
    for (int x = row.columns.x0; x < row.columns.x1; x += int(hn::Lanes(d))) {
        const auto active = hn::RebindMask(d, hn::Ne(hn::LoadU(du, row.flow + x), hn::Zero(du)));
        hn::StoreU(hn::IfThenElseZero(active, value(x)), d, out + x);
    }
}

void meanOfComets(const StreakRow& row, float* out)
{
    const DF d;
    const VF share = hn::Set(d, phase_mix::Comet::kMean), takenOff = hn::Set(d, phase_mix::Comet::kTakenOff);
    fillRow(row, out, [&](int x) AEOLIC_INLINE { return hn::MulSub(streakAt(row, x).bright, share, takenOff); });
}

void mixComets(const StreakRow& row, const float* mean, const phase_mix::Turned& phase, float* out)
{
    using phase_mix::Comet;
    const DF d;
    const VF cosine = hn::Set(d, phase.cosine), sine = hn::Set(d, phase.sine), one = hn::Set(d, 1.0f);
    fillRow(row, out, [&](int x) AEOLIC_INLINE {
        const Streak streak = streakAt(row, x);
        const VF inverse = hn::Div(one, hn::Max(streak.bright, hn::Set(d, 1e-6f)));
        const VF c = hn::Mul(hn::MulAdd(streak.re, cosine, hn::Mul(streak.im, sine)), inverse),
                 s = hn::Mul(hn::Sub(hn::Mul(streak.im, cosine), hn::Mul(streak.re, sine)), inverse);
        const VF c2 = hn::Sub(hn::Mul(hn::Add(c, c), c), one), s2 = hn::Mul(hn::Add(c, c), s);
        const VF c3 = hn::Mul(c, hn::Sub(hn::Add(c2, c2), one)), s3 = hn::Mul(s, hn::MulAdd(c2, hn::Set(d, 2.0f), one));
        const auto both = [&](std::size_t k, VF ck, VF sk) AEOLIC_INLINE {
            return hn::MulAdd(hn::Set(d, Comet::kCosine[k]), ck, hn::Mul(hn::Set(d, Comet::kSine[k]), sk));
        };
        const VF comet = hn::Add(both(0, c, s), hn::Add(both(1, c2, s2), both(2, c3, s3)));
        return hn::MulAdd(hn::Mul(streak.bright, hn::Set(d, Comet::kContrast)), comet, hn::LoadU(d, mean + x));
    });
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(meanOfComets);
HWY_EXPORT(mixComets);

namespace {

using Kept = std::array<LicImage, phase_mix::kMostKept>;

StreakRow streaksOf(const Kept& kept, const GBuffer& buffer, int y)
{
    return {
        {kept[0].row(y), kept[1].row(y), kept[2].row(y), kept[3].row(y)}, buffer.flow.row(y), buffer.surfaceColumns(y)};
}

void mixRow(const phase_mix::Weights& weights, const Kept& kept, const GBuffer& buffer, int y, float* out)
{
    const auto [a, b, c] = weights;
    const ColumnSpan& columns = buffer.surfaceColumns(y);
    const float *first = kept[0].row(y), *second = kept[1].row(y), *third = kept[2].row(y);
    for (int x = columns.x0; x < columns.x1; ++x) out[x] = a * first[x] + b * second[x] + c * third[x];
}

void mixRow(const phase_mix::Turned& phase, const Kept& kept, const GBuffer& buffer, int y, float* out)
{
    const float* mean = kept[phase_mix::kMeanOfComets].row(y);
    HWY_DYNAMIC_DISPATCH(mixComets)(streaksOf(kept, buffer, y), mean, phase, out);
}

void mixRow(phase_mix::MeanOfComets, const Kept& kept, const GBuffer& buffer, int y, float* out)
{
    HWY_DYNAMIC_DISPATCH(meanOfComets)(streaksOf(kept, buffer, y), out);
}

}  // namespace

void PhaseMixer::keep(int which, LicImage& values)
{
    LicImage& kept = kept_[std::size_t(which)];
    std::swap(kept, values);
    values.resize(kept.valid());
}

void PhaseMixer::mix(const GBuffer& buffer, const phase_mix::Mixture& mixture, LicImage& values) const
{
    const Extent& rows = kept_[0].valid();
    values.resize(rows);
    parallelRows(rows, 16, [&](int y) {
        std::visit([&](const auto& how) { mixRow(how, kept_, buffer, y, values.row(y)); }, mixture);
    });
}

}  // namespace aeolic::cpu
#endif
