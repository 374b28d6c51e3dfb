#include "engine/plane_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "render/limits.h"

namespace aeolic {
namespace {

constexpr std::size_t grain = 16;  // Rows.

/// Repeats a row beside itself, from x0 to x1.
template <class T>
void repeatRow(T* row, int width, int x0, int x1)
{
    for (int x = -1; x >= x0; --x) row[x] = row[x + width];
    for (int x = width; x < x1; ++x) row[x] = row[x - width];
}

}  // namespace

PlaneRows::PlaneRows(const PlaneFlow& flow, const LicOptions& lic, int reach) : flow_(flow), lic_(lic), reach_(reach)
{
    flowUnitPx_ = std::exp2(std::ceil(std::log2(std::max(lic.step, 1e-3)))) / (flow_texel::kDisplacementMax + 1);
    unitsPerStep_ = lic.step / flowUnitPx_;
    if (lic.style == Style::oriented && !flow.texture) grains_.emplace(lic.seed);
    findScales();
}

void PlaneRows::findScales()
{
    std::vector<RowScales> ofRow(std::size_t(flow_.height));
    parallelRanges(ofRow.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) {
            const std::size_t first = y * std::size_t(flow_.width);
            ofRow[y] = scalesOf(flow_.u + first, flow_.v + first, flow_.texture ? flow_.texture + first : nullptr,
                                flow_.width);
        }
    });
    RowScales all;
    for (const RowScales& row : ofRow)
        all = {std::max(all.longest, row.longest), std::min(all.lo, row.lo), std::max(all.hi, row.hi)};
    longest_ = all.longest;
    if (!(all.lo < all.hi)) return;
    middle_ = 0.5F * all.lo + 0.5F * all.hi;
    perUnit_ = 1 / (0.5F * all.hi - 0.5F * all.lo);
    if (!std::isfinite(perUnit_)) perUnit_ = 0;
}

Extent PlaneRows::extentFor(int y0, int y1) const
{
    if (flow_.periodic) return {-reach_, y0 - reach_, flow_.width + reach_, y1 + reach_};
    return {0, std::max(y0 - reach_, 0), flow_.width, std::min(y1 + reach_, flow_.height)};
}

void PlaneRows::fillRow(int y, std::uint32_t* row, std::uint32_t* fineVectors, std::uint16_t* fineNoise) const
{
    const std::size_t first = std::size_t(y) * std::size_t(flow_.width);
    // The direction of a vector shorter than a millionth of the longest is the data's rounding noise.
    const PlanePixels pixels{flow_.u + first,
                             flow_.v + first,
                             flow_.texture ? flow_.texture + first : nullptr,
                             grains_ ? &*grains_ : nullptr,
                             y,
                             std::uint32_t(first),
                             lic_.seed,
                             middle_,
                             perUnit_,
                             unitsPerStep_,
                             lic_.normalize ? 0 : longest_,
                             lic_.normalize ? 1e-6 * longest_ : 0};
    packRow(pixels, flow_.width, row, fineVectors, fineNoise);
}

void PlaneRows::fill(const Extent& extent, int fresh, GBuffer& buffer, cpu::FineFlow* fine) const
{
    buffer.rollFlow(extent);
    if (fine) fine->roll(extent);
    buffer.flowUnitPx = float(flowUnitPx_);
    const int width = flow_.width, height = flow_.height;
    const auto rowsFrom = [&](int first, const auto& body) {
        parallelRanges(std::size_t(extent.y1 - first), grain, [&](std::size_t begin, std::size_t end) {
            for (int y = first + int(begin); y < first + int(end); ++y) body(y);
        });
    };
    rowsFrom(std::max(fresh, extent.y0), [&](int y) {
        std::uint32_t* row = buffer.flow.row(y);
        std::uint32_t* vectors = fine ? fine->vectors.row(y) : nullptr;
        std::uint16_t* noise = fine ? fine->noise.row(y) : nullptr;
        fillRow((y % height + height) % height, row, vectors, noise);
        repeatRow(row, width, extent.x0, extent.x1);
        if (!fine) return;
        repeatRow(vectors, width, extent.x0, extent.x1);
        repeatRow(noise, width, extent.x0, extent.x1);
    });
    rowsFrom(std::max(fresh - limits::kLinkRows, extent.y0), [&](int y) {
        linkRow(buffer.flow.row(y - 1) + extent.x0, buffer.flow.row(y) + extent.x0, buffer.flow.row(y + 1) + extent.x0,
                extent.width(), buffer.links.row(y) + extent.x0);
    });
}

}  // namespace aeolic
