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
using KeptRow = std::array<const float*, phase_mix::kMostKept>;  // What is kept of a row.
}
#endif

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// How bright a streak is at x, and where along it the pixel lies: a number of the complex plane of that length.
struct Streak {
    VF re, im, bright;
};
HWY_INLINE Streak streakAt(const KeptRow& kept, int x)
{
    const DF d;
    const auto at = [&](std::size_t which) AEOLIC_INLINE { return hn::LoadU(d, kept[which] + x); };
    const VF re = hn::Sub(at(0), at(3)), im = hn::Neg(hn::Add(at(1), at(2)));
    return {re, im, hn::Sqrt(hn::MulAdd(re, re, hn::Mul(im, im)))};
}

// Calls out(x) for the columns of a row, and stores what it returns where there is flow, else 0. The last vector may
// reach beyond, where there is none.
template <class Value>
HWY_INLINE void forRow(const std::uint32_t* flow, const ColumnSpan& columns, float* out, const Value& value)
{
    const DF d;
    const DU du;
    for (int x = columns.x0; x < columns.x1; x += int(hn::Lanes(d))) {
        const auto active = hn::RebindMask(d, hn::Ne(hn::LoadU(du, flow + x), hn::Zero(du)));
        hn::StoreU(hn::IfThenElseZero(active, value(x)), d, out + x);
    }
}

void meanOfComets(const KeptRow& kept, const std::uint32_t* flow, const ColumnSpan& columns, float* out)
{
    const DF d;
    const VF share = hn::Set(d, phase_mix::Comet::kMean), takenOff = hn::Set(d, phase_mix::Comet::kTakenOff);
    forRow(flow, columns, out,
           [&](int x) AEOLIC_INLINE { return hn::MulSub(streakAt(kept, x).bright, share, takenOff); });
}

void mixComets(const KeptRow& kept, const phase_mix::Turned& phase, const std::uint32_t* flow,
               const ColumnSpan& columns, float* out)
{
    using phase_mix::Comet;
    const DF d;
    const VF cosine = hn::Set(d, phase.cosine), sine = hn::Set(d, phase.sine), one = hn::Set(d, 1.0f);
    forRow(flow, columns, out, [&](int x) AEOLIC_INLINE {
        const Streak streak = streakAt(kept, x);
        const VF inverse = hn::Div(one, hn::Max(streak.bright, hn::Set(d, 1e-6f)));
        const VF c = hn::Mul(hn::MulAdd(streak.re, cosine, hn::Mul(streak.im, sine)), inverse),
                 s = hn::Mul(hn::Sub(hn::Mul(streak.im, cosine), hn::Mul(streak.re, sine)), inverse);
        const VF c2 = hn::Sub(hn::Mul(hn::Add(c, c), c), one), s2 = hn::Mul(hn::Add(c, c), s);
        const VF c3 = hn::Mul(c, hn::Sub(hn::Add(c2, c2), one)), s3 = hn::Mul(s, hn::MulAdd(c2, hn::Set(d, 2.0f), one));
        const auto both = [&](std::size_t k, VF ck, VF sk) AEOLIC_INLINE {
            return hn::MulAdd(hn::Set(d, Comet::kCosine[k]), ck, hn::Mul(hn::Set(d, Comet::kSine[k]), sk));
        };
        const VF comet = hn::Add(both(0, c, s), hn::Add(both(1, c2, s2), both(2, c3, s3)));
        const VF mean = hn::LoadU(d, kept[phase_mix::kMeanOfComets] + x);
        return hn::MulAdd(hn::Mul(streak.bright, hn::Set(d, Comet::kContrast)), comet, mean);
    });
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(meanOfComets);
HWY_EXPORT(mixComets);

void PhaseMixer::keep(int which, LicImage& values)
{
    LicImage& kept = kept_[std::size_t(which)];
    std::swap(kept, values);
    values.resize(kept.valid());
}

void PhaseMixer::mix(const GBuffer& buffer, const phase_mix::Mixture& mixture, LicImage& values) const
{
    static_assert(phase_mix::kPhases == 3);
    const Extent& rows = kept_[0].valid();
    values.resize(rows);
    parallelRanges(std::size_t(rows.empty() ? 0 : rows.height()), 16, [&](std::size_t begin, std::size_t end) {
        for (int y = rows.y0 + int(begin); y < rows.y0 + int(end); ++y) {
            const ColumnSpan& columns = buffer.surfaceColumns(y);
            float* out = values.row(y);
            const auto* weights = std::get_if<phase_mix::Weights>(&mixture);
            if (!weights) {
                KeptRow kept{};
                for (std::size_t i = 0; i < kept.size(); ++i)
                    if (kept_[i].valid() == rows) kept[i] = kept_[i].row(y);
                if (const auto* phase = std::get_if<phase_mix::Turned>(&mixture))
                    HWY_DYNAMIC_DISPATCH(mixComets)(kept, *phase, buffer.flow.row(y), columns, out);
                else
                    HWY_DYNAMIC_DISPATCH(meanOfComets)(kept, buffer.flow.row(y), columns, out);
                continue;
            }
            const auto [a, b, c] = *weights;
            const float *first = kept_[0].row(y), *second = kept_[1].row(y), *third = kept_[2].row(y);
            for (int x = columns.x0; x < columns.x1; ++x) out[x] = a * first[x] + b * second[x] + c * third[x];
        }
    });
}

}  // namespace aeolic::cpu
#endif
