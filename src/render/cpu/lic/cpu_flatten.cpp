#include "render/cpu/lic/cpu_flatten.h"

#include <algorithm>
#include <vector>

#include "base/parallel.h"
#include "render/flatten.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/lic/cpu_flatten.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/simd/simd-inl.h"

#ifndef AEOLIC_RENDER_CPU_FLATTEN_ONCE
#define AEOLIC_RENDER_CPU_FLATTEN_ONCE
namespace aeolic::cpu {
namespace {

/// Sums of words, and how many of them there are, of some rows' columns [x0, x1): by column, and of all columns before.
struct FlattenSums {
    int x0, x1, reach;
    std::vector<std::uint32_t> sum, count;
    /// [i]: of the columns before x0 - reach + i. They wrap around, and what two of them differ by does not.
    std::vector<std::uint32_t> sumBefore, countBefore;

    FlattenSums(int first, int last, int reachPx)
        : x0(first),
          x1(last),
          reach(reachPx),
          sum(std::size_t(last - first) + kPadding),
          count(sum.size()),
          sumBefore(sum.size() + 2 * std::size_t(reachPx) + 1),
          countBefore(sumBefore.size())
    {
    }

private:
    static constexpr std::size_t kPadding = 64;  // Whole vectors.
};

}  // namespace
}  // namespace aeolic::cpu
#endif

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The words of a row's columns [x0, x1).
void flattenWords(const float* values, const std::uint32_t* flow, int x0, int x1, std::uint16_t* out)
{
    const DF d;
    const DU du;
    const hn::Rebind<std::uint16_t, DU> d16;
    const int lanes = int(hn::Lanes(d));
    for (int x = x0; x < x1; x += lanes) {
        const VF scaled = hn::MulAdd(hn::LoadU(d, values + x), hn::Set(d, float(flatten::kPerUnit)),
                                     hn::Set(d, float(flatten::kZero) + 0.5f));
        const VF within = hn::Min(hn::Max(scaled, hn::Set(d, 1.0f)), hn::Set(d, float(2 * flatten::kZero - 1)));
        const auto flows = hn::Ne(hn::LoadU(du, flow + x), hn::Zero(du));
        const VU word = hn::IfThenElseZero(flows, hn::BitCast(du, hn::ConvertTo(DI(), within)));
        const auto narrow = hn::DemoteTo(d16, hn::BitCast(DI(), word));
        storeUpTo(x1, narrow, x, d16, out);
    }
}

// Adds a row to the columns' sums, or takes it away. `row` by column of the picture.
template <bool adds>
HWY_INLINE void changeSums(const std::uint16_t* row, FlattenSums& sums)
{
    const DU du;
    const hn::Rebind<std::uint16_t, DU> d16;
    for (int x = sums.x0; x < sums.x1; x += int(hn::Lanes(du))) {
        const VU word = hn::PromoteTo(du, hn::LoadU(d16, row + x));
        const VU one = hn::IfThenElseZero(hn::Ne(word, hn::Zero(du)), hn::Set(du, 1));
        std::uint32_t *sum = &sums.sum[std::size_t(x - sums.x0)], *count = &sums.count[std::size_t(x - sums.x0)];
        const VU sumBefore = hn::LoadU(du, sum), countBefore = hn::LoadU(du, count);
        hn::StoreU(adds ? hn::Add(sumBefore, word) : hn::Sub(sumBefore, word), du, sum);
        hn::StoreU(adds ? hn::Add(countBefore, one) : hn::Sub(countBefore, one), du, count);
    }
}

void addRow(const std::uint16_t* row, FlattenSums& sums)
{
    changeSums<true>(row, sums);
}

void takeRow(const std::uint16_t* row, FlattenSums& sums)
{
    changeSums<false>(row, sums);
}

// Takes the means off the values of the columns [x0, x1) in which there is flow.
void flattenRow(const FlattenSums& sums, const std::uint32_t* flow, int x0, int x1, float* values)
{
    const DF d;
    const DI di;
    const DU du;
    const int lanes = int(hn::Lanes(d));
    for (int x = x0; x < x1; x += lanes) {
        const std::size_t i = std::size_t(x - sums.x0);
        const auto inSquare = [&](const std::vector<std::uint32_t>& before) AEOLIC_INLINE {
            const std::uint32_t* first = &before[i];
            return hn::BitCast(di, hn::Sub(hn::LoadU(du, first + 2 * sums.reach + 1), hn::LoadU(du, first)));
        };
        const VI sum = inSquare(sums.sumBefore), count = inSquare(sums.countBefore);
        const VI signedSum = hn::Sub(sum, hn::Mul(count, hn::Set(di, flatten::kZero)));
        const VF mean = hn::Div(hn::ConvertTo(d, signedSum), hn::Mul(hn::ConvertTo(d, hn::Max(count, hn::Set(di, 1))),
                                                                     hn::Set(d, float(flatten::kPerUnit))));
        const auto flows = hn::RebindMask(d, hn::Ne(hn::LoadU(du, flow + x), hn::Zero(du)));
        const VF value = hn::LoadU(d, values + x), scaled = hn::Mul(hn::Sub(value, mean), hn::Set(d, flatten::kGain)),
                 flat = hn::IfThenElse(flows, scaled, value);
        storeUpTo(x1, flat, x, d, values);
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(flattenWords);
HWY_EXPORT(addRow);
HWY_EXPORT(takeRow);
HWY_EXPORT(flattenRow);

namespace {

constexpr std::size_t kRowsAtOnce = 32;  // The first row of a run sums up all rows of its square.

// Sums the columns up, from the left to the right.
void sumBefore(FlattenSums& sums)
{
    const auto add = [&](const std::vector<std::uint32_t>& columns, std::vector<std::uint32_t>& before) {
        std::uint32_t* out = before.data() + sums.reach;
        std::uint32_t all = 0;
        for (std::size_t i = 0; i < std::size_t(sums.x1 - sums.x0); ++i) {
            *out++ = all;
            all += columns[i];
        }
        std::fill(out, before.data() + before.size(), all);
    };
    add(sums.sum, sums.sumBefore);
    add(sums.count, sums.countBefore);
}

// Rows [y0, y1) of the values.
void flattenRows(const GBuffer& buffer, const Image<std::uint16_t>& words, int reach, int y0, int y1, LicImage& values)
{
    const ColumnSpan all = buffer.surfaceColumns(y0, y1);
    if (all.empty()) return;
    const Extent& held = words.valid();
    FlattenSums sums(std::max(all.x0 - reach, held.x0), std::min(all.x1 + reach, held.x1), reach);
    for (int y = y0 - reach; y < y0 + reach; ++y) HWY_DYNAMIC_DISPATCH(addRow)(words.row(y), sums);
    for (int y = y0; y < y1; ++y) {
        HWY_DYNAMIC_DISPATCH(addRow)(words.row(y + reach), sums);
        const ColumnSpan& columns = buffer.surfaceColumns(y);
        sumBefore(sums);
        HWY_DYNAMIC_DISPATCH(flattenRow)(sums, buffer.flow.row(y), columns.x0, columns.x1, values.row(y));
        HWY_DYNAMIC_DISPATCH(takeRow)(words.row(y - reach), sums);
    }
}

}  // namespace

void FlattenStage::run(const GBuffer& buffer, const LicOptions& lic, const Extent& compute, RowExchange* beside,
                       int more, LicImage& values)
{
    const int reach = flatten::reachPx(lic), around = compute.empty() ? 0 : reach + more;
    const Extent& valid = buffer.valid();
    words_.resize({valid.x0, compute.y0 - around, valid.x1, compute.y1 + around});
    const Extent& held = words_.valid();
    parallelRows(held, 8, [&](int y) {
        ColumnSpan columns{held.x1, held.x1};
        if (y >= compute.y0 && y < compute.y1) columns = buffer.surfaceColumns(y);
        words_.clearBeside(y, columns);
        HWY_DYNAMIC_DISPATCH(flattenWords)
        (values.row(y), buffer.flow.row(y), columns.x0, columns.x1, words_.row(y));
    });
    if (beside) beside->receive(imageRows(words_), reach + more);

    const Extent shown = withNeighbours(compute, valid, compute.empty() ? 0 : more);
    parallelRanges(std::size_t(std::max(shown.height(), 0)), kRowsAtOnce, [&](std::size_t begin, std::size_t end) {
        flattenRows(buffer, words_, reach, shown.y0 + int(begin), shown.y0 + int(end), values);
    });
}

}  // namespace aeolic::cpu
#endif
