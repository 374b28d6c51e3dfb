#include "render/cpu/shade/cpu_occlusion.h"

#include <algorithm>
#include <vector>

#include "base/parallel.h"
#include "render/occlusion.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/shade/cpu_occlusion.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/simd/simd-inl.h"

#ifndef AEOLIC_RENDER_CPU_OCCLUSION_ONCE
#define AEOLIC_RENDER_CPU_OCCLUSION_ONCE
namespace aeolic::cpu {
namespace {

constexpr std::size_t kMostLanes = 16;

/// The pixels that those of one row of patterns look at, a pixel a lane. A vector begins at a multiple of the patterns'
/// width.
struct OcclusionTaps {
    alignas(64) float right[occlusion::kTaps][kMostLanes], down[occlusion::kTaps][kMostLanes],
        squared[occlusion::kTaps][kMostLanes];
    alignas(64) std::int32_t offset[occlusion::kTaps][kMostLanes];  ///< In the image of depths.
    float perFar;                                                   ///< 1 / (2 radius)^2

    OcclusionTaps(int y, int radius, std::ptrdiff_t stride) : perFar(0.25f / (float(radius) * float(radius)))
    {
        for (int k = 0; k < occlusion::kTaps; ++k)
            for (std::size_t lane = 0; lane < kMostLanes; ++lane) {
                const int at = occlusion::patternOf(int(lane), y) * occlusion::kTaps + k;
                const int u = occlusion::tapPx(occlusion::kRight[at], radius),
                          v = occlusion::tapPx(occlusion::kDown[at], radius);
                right[k][lane] = float(u), down[k][lane] = float(v);
                squared[k][lane] = float(std::max(u * u + v * v, 1));
                offset[k][lane] = std::int32_t(v * stride + u);
            }
    }
};

}  // namespace
}  // namespace aeolic::cpu
#endif

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Depths to pixels of this depth, so that slopes are those in the world.
HWY_INLINE VF pixelsPerDepth(VF depth, float focalPx)
{
    const DF d;
    const VF zero = hn::Zero(d);
    return hn::Div(hn::Set(d, focalPx), hn::IfThenElse(hn::Gt(depth, zero), depth, hn::Set(d, 1.0f)));
}

// What is hidden from each pixel of [x0, x1). `depths`, `gradX`, `gradY`, `out`: the row's, by column.
void hiddenRow(const OcclusionTaps& taps, float focalPx, const float* depths, const float* gradX, const float* gradY,
               int x0, int x1, float* out)
{
    const DF d;
    const DI di;
    const VF zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    for (int x = x0; x < x1; x += int(hn::Lanes(d))) {
        const VF depth = hn::LoadU(d, depths + x);
        if (hn::AllTrue(d, hn::Eq(depth, zero))) {
            storeUpTo(x1, zero, x, d, out);
            continue;
        }
        const VF scale = pixelsPerDepth(depth, focalPx);
        const VF slopeX = hn::Mul(hn::LoadU(d, gradX + x), scale), slopeY = hn::Mul(hn::LoadU(d, gradY + x), scale);
        const VF perHeight = hn::Div(one, hn::MulAdd(slopeX, slopeX, hn::MulAdd(slopeY, slopeY, one)));
        const VI lanes = hn::Iota(di, 0);
        VF hidden = zero;
        for (int k = 0; k < occlusion::kTaps; ++k) {
            const VF there = hn::GatherIndex(d, depths + x, hn::Add(lanes, hn::Load(di, taps.offset[k])));
            const VF toEye = hn::Mul(hn::Sub(there, depth), scale);
            const VF predicted =
                hn::MulAdd(slopeX, hn::Load(d, taps.right[k]), hn::Mul(slopeY, hn::Load(d, taps.down[k])));
            const VF above = hn::Max(hn::Sub(toEye, predicted), zero);
            const VF far = hn::MulAdd(toEye, toEye, hn::Load(d, taps.squared[k]));
            const VF near = hn::Max(hn::NegMulAdd(far, hn::Set(d, taps.perFar), one), zero);
            hidden = hn::MulAdd(hn::Div(hn::Mul(hn::Mul(above, above), near), far), perHeight, hidden);
        }
        storeUpTo(x1, hn::Mul(hidden, hn::Set(d, 1.0f / float(occlusion::kTaps))), x, d, out);
    }
}

// The open share of each pixel of row `y`, [x0, x1), from the hidden shares of those around it.
void openRow(const Image<float>& depths, const Image<float>& hidden, float focalPx, const float* gradX,
             const float* gradY, int y, int x0, int x1, float* out)
{
    const DF d;
    const VF zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    for (int x = x0; x < x1; x += int(hn::Lanes(d))) {
        const VF depth = hn::LoadU(d, depths.row(y) + x);
        if (hn::AllTrue(d, hn::Eq(depth, zero))) {
            storeUpTo(x1, one, x, d, out);
            continue;
        }
        const VF slack = hn::Div(hn::Set(d, occlusion::kSlackPx), pixelsPerDepth(depth, focalPx));
        const VF slopeX = hn::LoadU(d, gradX + x), slopeY = hn::LoadU(d, gradY + x);
        VF sum = zero, count = zero;
        for (int v = -occlusion::kBefore; v < occlusion::kBefore; ++v)
            for (int u = -occlusion::kBefore; u < occlusion::kBefore; ++u) {
                const VF there = hn::LoadU(d, depths.row(y + v) + x + u);
                const VF predicted =
                    hn::MulAdd(slopeX, hn::Set(d, float(u)), hn::MulAdd(slopeY, hn::Set(d, float(v)), depth));
                const auto counts = hn::And(hn::Gt(there, zero), hn::Le(hn::Abs(hn::Sub(there, predicted)), slack));
                sum = hn::Add(sum, hn::IfThenElseZero(counts, hn::LoadU(d, hidden.row(y + v) + x + u)));
                count = hn::Add(count, hn::IfThenElseZero(counts, one));
            }
        const VF mean = hn::Div(sum, hn::Max(count, one));
        storeUpTo(x1, hn::Div(one, hn::MulAdd(mean, hn::Set(d, occlusion::kStrength), one)), x, d, out);
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(hiddenRow);
HWY_EXPORT(openRow);

void OcclusionStage::copyDepths(const GBuffer& buffer, const Extent& compute)
{
    const Extent& held = depths_.valid();
    parallelRows(held, 8, [&](int y) {
        ColumnSpan columns{held.x1, held.x1};
        if (y >= compute.y0 && y < compute.y1) columns = buffer.surfaceColumns(y);
        depths_.clearBeside(y, columns);
        if (columns.empty()) return;
        const float* from = buffer.invDepth.row(y);
        std::copy(from + columns.x0, from + columns.x1, depths_.row(y) + columns.x0);
    });
}

void OcclusionStage::findHidden(const GBuffer& buffer, const View& view, const Extent& compute, int radius)
{
    std::vector<OcclusionTaps> taps;
    taps.reserve(occlusion::kTile);
    for (int y = 0; y < occlusion::kTile; ++y) taps.emplace_back(y, radius, depths_.stride());
    parallelRows(compute, 8, [&](int y) {
        const ColumnSpan& columns = buffer.surfaceColumns(y);
        HWY_DYNAMIC_DISPATCH(hiddenRow)
        (taps[std::size_t(y % occlusion::kTile)], view.focalPx, depths_.row(y), buffer.gradX.row(y),
         buffer.gradY.row(y), columns.x0, columns.x1, hidden_.row(y));
    });
}

void OcclusionStage::run(const GBuffer& buffer, const View& view, const Extent& compute, RowExchange* beside, int more)
{
    const int radius = occlusion::radiusPx(view.camera.height), averaged = more + occlusion::kBefore;
    const auto grown = [&](int rows, int columns) {
        const int around = compute.empty() ? 0 : rows;
        return Extent{compute.x0 - columns, compute.y0 - around, compute.x1 + columns, compute.y1 + around};
    };
    depths_.resize(grown(radius + averaged, radius));
    copyDepths(buffer, compute);
    if (beside) beside->receive(imageRows(depths_), radius + averaged);
    hidden_.resize(grown(averaged, 0));
    findHidden(buffer, view, compute, radius);
    if (beside) beside->receive(imageRows(hidden_), averaged);
    open_.resize(withNeighbours(compute, buffer.valid(), compute.empty() ? 0 : more));
    parallelRows(open_.valid(), 8, [&](int y) {
        const ColumnSpan& columns = buffer.surfaceColumns(y);
        HWY_DYNAMIC_DISPATCH(openRow)
        (depths_, hidden_, view.focalPx, buffer.gradX.row(y), buffer.gradY.row(y), y, columns.x0, columns.x1,
         open_.row(y));
    });
}

}  // namespace aeolic::cpu
#endif
