#include "render/cpu/edges/find_edges.h"

#include <algorithm>
#include <cstring>

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

// The edges among such pixels: light alone may differ.
HWY_INLINE MF creasesAt(const GBuffer& buffer, VF lightStep, int x, int y)
{
    const DF d;
    const std::ptrdiff_t stride = buffer.light.stride();
    const float* light = buffer.light.row(y) + x;
    const VF own = hn::LoadU(d, light);
    VF least = own, most = own;
    for (const std::ptrdiff_t row : {-stride, std::ptrdiff_t{0}, stride})
        for (int sx = -1; sx <= 1; ++sx) {
            const VF other = hn::LoadU(d, light + row + sx);
            least = hn::Min(least, other);
            most = hn::Max(most, other);
        }
    return hn::Gt(hn::Max(hn::Sub(most, own), hn::Sub(own, least)), lightStep);
}

// The edges among the pixels at x of row y, which has these neighbours.
HWY_INLINE MF edgesAt(const View& view, const GBuffer& buffer, VF lightStep, int x, int y)
{
    const DF d;
    const DI di;
    const int width = view.camera.width, height = view.camera.height;
    const VF zero = hn::Zero(d), perDepth = slackPerDepth(d, view.focalPx);
    const std::ptrdiff_t stride = buffer.invDepth.stride();
    const float *depth = buffer.invDepth.row(y) + x, *gradX = buffer.gradX.row(y) + x, *gradY = buffer.gradY.row(y) + x,
                *light = buffer.light.row(y) + x;
    const VI column = hn::Add(hn::Iota(di, 0), hn::Set(di, x));
    const VF za = hn::LoadU(d, depth), gxa = hn::LoadU(d, gradX), gya = hn::LoadU(d, gradY),
             lightA = hn::LoadU(d, light);
    const MF covered = hn::Gt(za, zero);
    MF edge = hn::FirstN(d, 0);
    for (int sy = -1; sy <= 1; ++sy) {
        if (y + sy < 0 || y + sy >= height) continue;
        for (int sx = -1; sx <= 1; ++sx) {
            if (sx == 0 && sy == 0) continue;
            const std::ptrdiff_t at = sx + sy * stride;
            const VF zb = hn::LoadU(d, depth + at);
            const MF other = hn::Gt(zb, zero);
            MF differ = hn::Xor(covered, other);
            const MF both = hn::And(covered, other);
            if (!hn::AllFalse(d, both)) {
                const auto along = [&](VF gx, VF gy) AEOLIC_INLINE {
                    return hn::MulAdd(gx, hn::Set(d, float(sx)), hn::Mul(gy, hn::Set(d, float(sy))));
                };
                const VF ga = along(gxa, gya), gb = along(hn::LoadU(d, gradX + at), hn::LoadU(d, gradY + at));
                const MF apart = hn::Not(onOneSheet(d, predict(d, za, ga, zb, gb, perDepth)));
                const MF turned = hn::Gt(hn::Abs(hn::Sub(hn::LoadU(d, light + at), lightA)), lightStep);
                differ = hn::Or(differ, hn::And(both, hn::Or(apart, turned)));
            }
            if (sx != 0) {
                const VI beside = hn::Add(column, hn::Set(di, sx));
                const auto inside = hn::AndNot(hn::Lt(beside, hn::Zero(di)), hn::Lt(beside, hn::Set(di, width)));
                differ = hn::And(differ, hn::RebindMask(d, inside));
            }
            edge = hn::Or(edge, differ);
        }
    }
    return edge;
}

void findInRow(const View& view, const GBuffer& buffer, bool lighting, const ColumnSpan& columns, int y,
               std::uint64_t* words)
{
    const DF d;
    const VF lightStep = lighting ? hn::Set(d, antialias::kLightStep) : hn::Inf(d);
    constexpr int kWord = 64;
    for (int x = columns.x0; x < columns.x1; x += int(hn::Lanes(d))) {
        MF edge = allLinked(buffer, x, y) ? creasesAt(buffer, lightStep, x, y) : edgesAt(view, buffer, lightStep, x, y);
        edge = hn::And(edge, hn::FirstN(d, std::size_t(std::max(columns.x1 - x, 0))));
        if (hn::AllFalse(d, edge)) continue;
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(d, edge, bytes);
        std::uint64_t some = 0;
        std::memcpy(&some, bytes, sizeof some);
        words[x / kWord] |= some << (x % kWord);
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
    ColumnSpan all{valid.x1, valid.x0};
    for (int row = std::max(y - 1, valid.y0); row < std::min(y + 2, valid.y1); ++row) {
        const ColumnSpan& columns = buffer.surfaceColumns(row);
        if (columns.empty()) continue;
        all = {std::min(all.x0, columns.x0), std::max(all.x1, columns.x1)};
    }
    if (all.empty()) return {valid.x1, valid.x1};
    return {std::max(valid.x0, (all.x0 - 1 - valid.x0) / kAligned * kAligned + valid.x0),
            std::min(all.x1 + 1, valid.x1)};
}

void findEdges(const View& view, const GBuffer& buffer, bool lighting, const Extent& compute, EdgeMask& out)
{
    out.clear(compute);
    parallelRanges(std::size_t(std::max(compute.height(), 0)), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const int y = compute.y0 + int(i);
            HWY_DYNAMIC_DISPATCH(findInRow)(view, buffer, lighting, edgeColumns(buffer, y), y, out.row(y));
        }
    });
}

}  // namespace aeolic::cpu
#endif
