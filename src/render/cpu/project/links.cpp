#include "render/cpu/project/links.h"

#include "base/parallel.h"
#include "render/gbuffer.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/project/links.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/project/one_sheet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void linkRow(const View& view, const ColumnSpan& columns, int y, GBuffer& buffer)
{
    const hn::ScalableTag<float> d;
    const hn::RebindToUnsigned<decltype(d)> du;
    const hn::Rebind<std::uint8_t, decltype(d)> d8;
    const std::ptrdiff_t stride = buffer.invDepth.stride();
    const auto perDepth = slackPerDepth(d, view.focalPx);
    const float *depth = buffer.invDepth.row(y), *gradX = buffer.gradX.row(y), *gradY = buffer.gradY.row(y);
    const std::uint32_t* flow = buffer.flow.row(y);
    for (int x = columns.x0; x < columns.x1; x += int(hn::Lanes(d))) {
        const auto hasFlow = hn::Ne(hn::LoadU(du, flow + x), hn::Zero(du));
        auto mask = hn::Zero(du);
        if (!hn::AllFalse(du, hasFlow)) {
            const auto za = hn::LoadU(d, depth + x), gxa = hn::LoadU(d, gradX + x), gya = hn::LoadU(d, gradY + x);
            for (int sy = -1; sy <= 1; ++sy)
                for (int sx = -1; sx <= 1; ++sx) {
                    if (sx == 0 && sy == 0) continue;
                    const std::ptrdiff_t at = x + sx + sy * stride;
                    const auto zb = hn::LoadU(d, depth + at);
                    // The facets' change from this pixel to the other: gA by ours, gB by the other's.
                    const auto along = [&](auto gx, auto gy) {
                        return hn::MulAdd(gx, hn::Set(d, float(sx)), hn::Mul(gy, hn::Set(d, float(sy))));
                    };
                    const auto ga = along(gxa, gya), gb = along(hn::LoadU(d, gradX + at), hn::LoadU(d, gradY + at));
                    const auto one = onOneSheet(d, predict(d, za, ga, zb, gb, perDepth));
                    const auto otherFlow = hn::Ne(hn::LoadU(du, flow + at), hn::Zero(du));
                    const auto linked = hn::And(hn::RebindMask(du, one), hn::And(hasFlow, otherFlow));
                    mask = hn::Or(mask, hn::IfThenElseZero(linked, hn::Set(du, 1u << linkBit(sx, sy))));
                }
        }
        // The last vector's overhang falls on apron pixels, whose flow is zero: it writes zeros.
        hn::StoreU(hn::U8FromU32(mask), d8, buffer.links.row(y) + x);
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(linkRow);

void linkSheets(const View& view, const Extent& compute, GBuffer& buffer)
{
    parallelRows(compute, 8, [&](int y) { HWY_DYNAMIC_DISPATCH(linkRow)(view, buffer.surfaceColumns(y), y, buffer); });
}

}  // namespace aeolic::cpu
#endif
