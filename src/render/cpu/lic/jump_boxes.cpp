#include "render/cpu/lic/hierarchical.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/lic/jump_boxes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <limits>

#ifndef AEOLIC_RENDER_CPU_JUMP_BOXES_ONCE
#define AEOLIC_RENDER_CPU_JUMP_BOXES_ONCE
namespace aeolic::cpu {
constexpr int kColumns = JumpBoxes::kColumns, kRows = JumpBoxes::kRows;
constexpr int kFields = 4;    // A jump has these, 16 bits each: dx, dy, sum, meta.
constexpr int kUnitBits = 8;  // A box counts in so many bits less than a jump.
static_assert(Image<std::uint64_t>::kApron >= kColumns, "the last block may end beyond the image");
}  // namespace aeolic::cpu
#endif

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kRun = std::size_t(kColumns) * kFields;  // Fields of a row of a block.
using D = hn::CappedTag<std::int16_t, kRun>;

// Least, or most, of each field, from those of several pixels.
template <class Pick>
void fold(hn::Vec<D> v, const Pick& pick, std::int16_t (&fields)[kFields])
{
    const D d;
    HWY_ALIGN std::int16_t all[kRun];
    hn::Store(v, d, all);
    for (int f = 0; f < kFields; ++f) fields[f] = all[f];
    for (std::size_t i = kFields; i < hn::Lanes(d); ++i) fields[i % kFields] = pick(fields[i % kFields], all[i]);
}

JumpBox boxOf(const JumpLevel& level, int x, const int* rows, int count)
{
    const D d;
    auto low = hn::Set(d, std::numeric_limits<std::int16_t>::max()),
         high = hn::Set(d, std::numeric_limits<std::int16_t>::min());
    for (int k = 0; k < count; ++k) {
        const auto* run = reinterpret_cast<const std::int16_t*>(level.jumps.row(rows[k]) + x);
        for (std::size_t i = 0; i < kRun; i += hn::Lanes(d)) {
            const auto v = hn::LoadU(d, run + i);
            low = hn::Min(low, v);
            high = hn::Max(high, v);
        }
    }
    std::int16_t least[kFields], most[kFields];
    fold(
        low, [](std::int16_t a, std::int16_t b) { return std::min(a, b); }, least);
    fold(
        high, [](std::int16_t a, std::int16_t b) { return std::max(a, b); }, most);
    const auto none = [&](int field) { return least[field] >= 0 && most[field] <= 0; };
    if (none(0) && none(1) && none(3)) return {};
    const auto box = [](std::int16_t v) { return std::int8_t(v >> kUnitBits); };
    return {box(least[0]), box(most[0]), box(least[1]), box(most[1])};
}

// What is near flow, in whole blocks: where it ends within one of the image there is background.
ColumnSpan blocksNear(const ColumnSpan& near, int width)
{
    return {near.x0 / kColumns, near.x1 == width ? JumpBoxes::columnsOf(width) : near.x1 / kColumns};
}

void boxesOfRows(const JumpLevel& level, const NearFlow& near, const Extent& extent, JumpBox* boxes)
{
    ColumnSpan spans[kRows], all;
    for (int y = extent.y0; y < extent.y1; ++y) {
        spans[y - extent.y0] = blocksNear(near.at(y), level.jumps.valid().x1);
        all = all.with(spans[y - extent.y0]);
    }
    const int end = std::min(all.x1, JumpBoxes::columnsOf(extent.x1));
    for (int c = std::max(all.x0, extent.x0 / kColumns); c < end; ++c) {
        int rows[kRows], count = 0;
        for (int y = extent.y0; y < extent.y1; ++y) {
            rows[count] = y;
            count += c >= spans[y - extent.y0].x0 && c < spans[y - extent.y0].x1;
        }
        if (count > 0) boxes[c] = boxOf(level, c * kColumns, rows, count);
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(boxesOfRows);

JumpBoxes emptyBoxes(const JumpLevel& level, const Extent& own)
{
    const int columns = JumpBoxes::columnsOf(own.width());
    return {level.units.displacementPx * float(1 << kUnitBits), columns,
            std::vector<JumpBox>(std::size_t(JumpBoxes::rowsOf(own.height())) * std::size_t(columns))};
}

void addBoxes(const JumpLevel& level, const NearFlow& near, const Extent& own, const Extent& tile, JumpBoxes& boxes)
{
    for (int y = tile.y0; y < tile.y1; y += kRows) {
        const auto first = std::size_t((y - own.y0) / kRows) * std::size_t(boxes.columns);
        HWY_DYNAMIC_DISPATCH(boxesOfRows)
        (level, near, {tile.x0, y, tile.x1, std::min(y + kRows, tile.y1)}, &boxes.boxes[first]);
    }
}

}  // namespace aeolic::cpu
#endif
