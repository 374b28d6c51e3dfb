#include "render/cpu/edges/find_edges.h"

#include <algorithm>

#include "base/parallel.h"
#include "render/antialias.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/edges/find_edges.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/project/one_sheet-inl.h"
#include "render/cpu/simd/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Whether all pixels at x of row y are linked to all neighbours: all lie on one sheet.
HWY_INLINE bool allLinked(const GBuffer& buffer, int x, int y)
{
    const DU du;
    const hn::Rebind<std::uint8_t, DU> d8;
    const auto links = hn::PromoteTo(du, hn::LoadU(d8, buffer.links.row(y) + x));
    return hn::AllTrue(du, hn::Eq(links, hn::Set(du, 0xFFu)));
}

// Which pixels lie at a crease: a step of light between two sides that are even in themselves. `counts(sx, sy)`: which
// of the neighbours count.
template <class Counts>
HWY_INLINE MF creases(const GBuffer& buffer, VF lightStep, int x, int y, const Counts& counts)
{
    const DF d;
    const std::ptrdiff_t stride = buffer.light.stride();
    const float* light = buffer.light.row(y) + x;
    const VF own = hn::Abs(hn::LoadU(d, light));
    VF nine[9];
    VF least = own, most = own;
    for (int sy = -1, k = 0; sy <= 1; ++sy)
        for (int sx = -1; sx <= 1; ++sx, ++k) {
            nine[k] = hn::IfThenElse(counts(sx, sy), hn::Abs(hn::LoadU(d, light + sx + sy * stride)), own);
            least = hn::Min(least, nine[k]);
            most = hn::Max(most, nine[k]);
        }
    const VF step = hn::Sub(most, least);
    const MF steep = hn::Gt(step, lightStep);
    if (hn::AllFalse(d, steep)) return steep;  // Most of a smooth surface.
    const VF middle = hn::Mul(hn::Add(least, most), hn::Set(d, 0.5f));
    VF darkEnd = least, brightBegin = most;
    for (const VF& value : nine) {
        const auto bright = hn::Gt(value, middle);
        darkEnd = hn::Max(darkEnd, hn::IfThenElse(bright, least, value));
        brightBegin = hn::Min(brightBegin, hn::IfThenElse(bright, value, most));
    }
    const VF sides = hn::Max(hn::Sub(darkEnd, least), hn::Sub(most, brightBegin));
    return hn::And(steep, hn::Le(sides, hn::Mul(step, hn::Set(d, antialias::kUneven))));
}

// The edges among pixels that are linked to all neighbours.
HWY_INLINE MF creasesAt(const GBuffer& buffer, VF lightStep, int x, int y)
{
    const auto all = [](int, int) AEOLIC_INLINE { return hn::FirstN(DF(), hn::Lanes(DF())); };
    return creases(buffer, lightStep, x, y, all);
}

// Whether there is surface in none of the pixels at x of row y and their neighbours.
HWY_INLINE bool allBackground(const GBuffer& buffer, int height, int x, int y)
{
    const DF d;
    const std::ptrdiff_t stride = buffer.invDepth.stride();
    const float* depth = buffer.invDepth.row(y) + x;
    VF most = hn::Zero(d);
    for (int sy = y > 0 ? -1 : 0; sy <= (y + 1 < height ? 1 : 0); ++sy)
        for (int sx = -1; sx <= 1; ++sx) most = hn::Max(most, hn::LoadU(d, depth + sx + sy * stride));
    return hn::AllFalse(d, hn::Gt(most, hn::Zero(d)));
}

// The edges among the pixels at x of row y, whatever their neighbours are.
HWY_INLINE MF edgesAt(const View& view, const GBuffer& buffer, VF lightStep, int x, int y)
{
    const DF d;
    const DI di;
    const int width = view.camera.width, height = view.camera.height;
    const VF zero = hn::Zero(d), perDepth = slackPerDepth(d, view.focalPx);
    const std::ptrdiff_t stride = buffer.invDepth.stride();
    const float *depth = buffer.invDepth.row(y) + x, *gradX = buffer.gradX.row(y) + x, *gradY = buffer.gradY.row(y) + x;
    const VI column = hn::Add(hn::Iota(di, 0), hn::Set(di, x));
    const VF za = hn::LoadU(d, depth), gxa = hn::LoadU(d, gradX), gya = hn::LoadU(d, gradY);
    const MF covered = hn::Gt(za, zero);
    const auto inside = [&](int sx, int sy) AEOLIC_INLINE {
        const VI beside = hn::Add(column, hn::Set(di, sx));
        const auto columns = hn::AndNot(hn::Lt(beside, hn::Zero(di)), hn::Lt(beside, hn::Set(di, width)));
        return y + sy < 0 || y + sy >= height ? hn::FirstN(d, 0) : hn::RebindMask(d, columns);
    };
    const auto both = [&](int sx, int sy) AEOLIC_INLINE {
        return hn::And(hn::And(inside(sx, sy), covered), hn::Gt(hn::LoadU(d, depth + sx + sy * stride), zero));
    };
    MF edge = hn::FirstN(d, 0);
    for (int sy = -1; sy <= 1; ++sy) {
        if (y + sy < 0 || y + sy >= height) continue;
        for (int sx = -1; sx <= 1; ++sx) {
            if (sx == 0 && sy == 0) continue;
            const std::ptrdiff_t at = sx + sy * stride;
            const VF zb = hn::LoadU(d, depth + at);
            MF differ = hn::Xor(covered, hn::Gt(zb, zero));
            const MF surface = both(sx, sy);
            if (!hn::AllFalse(d, surface)) {
                const auto along = [&](VF gx, VF gy) AEOLIC_INLINE {
                    return hn::MulAdd(gx, hn::Set(d, float(sx)), hn::Mul(gy, hn::Set(d, float(sy))));
                };
                const VF ga = along(gxa, gya), gb = along(hn::LoadU(d, gradX + at), hn::LoadU(d, gradY + at));
                const MF apart = hn::Not(onOneSheet(d, predict(d, za, ga, zb, gb, perDepth)));
                differ = hn::Or(differ, hn::And(surface, apart));
            }
            edge = hn::Or(edge, hn::And(differ, inside(sx, sy)));
        }
    }
    if (hn::AllFalse(d, covered)) return edge;
    return hn::Or(edge, hn::And(covered, creases(buffer, lightStep, x, y, both)));
}

void findInRow(const View& view, const GBuffer& buffer, bool lighting, const ColumnSpan& columns, int y,
               std::uint64_t* words)
{
    const DF d;
    const VF lightStep = lighting ? hn::Set(d, antialias::kLightStep) : hn::Inf(d);
    constexpr int kWord = 64;
    for (int x = columns.x0; x < columns.x1; x += int(hn::Lanes(d))) {
        const bool linked = allLinked(buffer, x, y);
        if (!linked && allBackground(buffer, view.camera.height, x, y)) continue;
        MF edge = linked ? creasesAt(buffer, lightStep, x, y) : edgesAt(view, buffer, lightStep, x, y);
        edge = hn::And(edge, hn::FirstN(d, std::size_t(std::max(columns.x1 - x, 0))));
        if (!hn::AllFalse(d, edge)) words[x / kWord] |= bitsOf(d, edge) << (x % kWord);
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(findInRow);

ColumnSpan edgeColumns(const GBuffer& buffer, int y)
{
    constexpr int kAligned = Image<float>::kApron;
    const Extent& valid = buffer.valid();
    const ColumnSpan all = buffer.surfaceColumns(std::max(y - 1, valid.y0), std::min(y + 2, valid.y1));
    if (all.empty()) return {valid.x1, valid.x1};
    return {std::max(valid.x0, (all.x0 - 1 - valid.x0) / kAligned * kAligned + valid.x0),
            std::min(all.x1 + 1, valid.x1)};
}

void findEdges(const View& view, const GBuffer& buffer, bool lighting, const Extent& compute, EdgeMask& out)
{
    out.clear(compute);
    parallelRows(compute, 8, [&](int y) {
        HWY_DYNAMIC_DISPATCH(findInRow)(view, buffer, lighting, edgeColumns(buffer, y), y, out.row(y));
    });
}

}  // namespace aeolic::cpu
#endif
