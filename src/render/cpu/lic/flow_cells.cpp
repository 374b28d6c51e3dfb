#include "render/cpu/lic/flow_cells.h"

#include <algorithm>

#include "base/parallel.h"
#include "render/lic/jump_plan.h"
#include "render/limits.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/lic/flow_cells.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/simd/vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Texels of one row from column x0 of the valid extent on: the flow with the noise sharpened, packed for the tracer.
void texelRow(const GBuffer& buffer, int y, int x0, int x1, float sharpness, float noiseUnit, Image<std::uint32_t>& out)
{
    const DU d;
    const DF df;
    const DI di;
    const hn::Rebind<std::uint8_t, DU> d8;
    const std::ptrdiff_t stride = buffer.flow.stride(), row = (y - buffer.valid().y0) * stride;
    const std::uint32_t* flow = buffer.flow.origin() + row;
    const auto noiseOf = [&](auto texel) {
        return hn::ConvertTo(df, hn::BitCast(di, hn::And(texel, hn::Set(d, 0xFFu))));
    };
    const auto zeroNoise = hn::Set(df, float(flow_texel::kNoiseZero));
    for (int x = x0; x < x1; x += int(hn::Lanes(d))) {
        const auto texel = hn::LoadU(d, flow + x);
        const auto links = hn::PromoteTo(d, hn::LoadU(d8, buffer.links.origin() + row + x));
        const auto noise = noiseOf(texel);
        auto excess = hn::Zero(df);
        const auto against = [&](std::ptrdiff_t offset, int sx, int sy) {
            const auto linked = hn::Ne(hn::And(links, hn::Set(d, 1u << linkBit(sx, sy))), hn::Zero(d));
            excess = hn::Add(excess, hn::IfThenElseZero(hn::RebindMask(df, linked),
                                                        hn::Sub(noise, noiseOf(hn::LoadU(d, flow + x + offset)))));
        };
        if (sharpness > 0) {
            against(1, 1, 0);
            against(-1, -1, 0);
            against(stride, 0, 1);
            against(-stride, 0, -1);
        }
        // From the lowest field up, each rounded with the bits below it in mind.
        const auto field = [&](auto value, auto lowest, auto highest) {
            return hn::Min(hn::Max(hn::NearestInt(value), hn::Set(di, lowest)), hn::Set(di, highest));
        };
        const auto below = [&](auto bits, float unit) { return hn::Mul(hn::ConvertTo(df, bits), hn::Set(df, unit)); };
        const auto mask = [&](auto v, int bits) { return hn::And(v, hn::Set(di, bits)); };
        const auto sharp = hn::MulAdd(excess, hn::Set(df, sharpness), hn::Sub(noise, zeroNoise));
        const auto byte =
            field(hn::MulAdd(sharp, hn::Set(df, 1.0f / noiseUnit), zeroNoise), limits::kLeastNoise, limits::kMostNoise);
        const auto signedTexel = hn::BitCast(di, texel);
        const auto vy = hn::ConvertTo(df, hn::ShiftRight<20>(hn::ShiftLeft<12>(signedTexel)));
        const auto vx = hn::ConvertTo(df, hn::ShiftRight<20>(signedTexel));
        const auto yField = mask(field(hn::Sub(vy, below(byte, 0x1p-8f)), -2048, 2047), 0xFFF);
        const auto low20 = hn::Or(hn::ShiftLeft<8>(yField), byte);
        const auto xField = field(hn::Sub(vx, below(low20, 0x1p-20f)), -2048, 2047);
        const auto packed = hn::BitCast(d, hn::Or(hn::ShiftLeft<20>(xField), low20));
        hn::StoreU(hn::IfThenElseZero(hn::Ne(texel, hn::Zero(d)), packed), d, out.origin() + row + x);
    }
}

void cellRow(const Image<std::uint32_t>& texels, const Image<std::uint8_t>& linkMasks, int y, int begin, int end,
             FlowCell* out)
{
    const DU d;
    const int lanes = int(hn::Lanes(d)), x0 = texels.valid().x0;
    const std::uint32_t *upper = texels.row(y) + x0, *lower = upper + texels.stride();
    const std::uint8_t* links = linkMasks.row(y) + x0;
    const auto one = hn::Set(d, 1u);
    // From a vector before, so that cell -1 is there, to the end; zeros beyond the image.
    for (int x = begin - lanes; x < end; x += lanes) {
        const auto open = hn::IfThenElseZero(openTo(links + x, linkMasks.stride(), 1 + limits::kOpenRings), one);
        // The first texel's noise takes an even value, up or down by chance, and the flag is put beside it. The
        // bits of a cell must not depend on links farther away than traces go, which a rank may not have.
        const auto texel = hn::LoadU(d, upper + x);
        const auto isOdd = hn::Ne(hn::And(texel, one), hn::Zero(d));
        const auto change = hn::Sub(hn::And(texel, hn::Set(d, 2u)), one);
        const auto first = hn::Or(hn::Add(texel, hn::IfThenElseZero(isOdd, change)), open);
        hn::StoreInterleaved4(first, hn::LoadU(d, upper + x + 1), hn::LoadU(d, lower + x), hn::LoadU(d, lower + x + 1),
                              d, out[x].texel);
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(texelRow);
HWY_EXPORT(cellRow);

void FlowCells::build(const GBuffer& buffer, const NearFlow& near, float sharpness, const FreshRows& fresh, int steps)
{
    const Extent &valid = buffer.valid(), &rows = near.rows();
    noiseUnit = sharpness > 0 ? kSharpenedNoiseUnit : 1.0f;
    fresh.prepare(cells, valid, fresh.readFrom(steps, 1, valid));
    if (rows.empty()) return;
    const auto columnsOf = [&](int y) { return near.at(std::clamp(y, rows.y0, rows.y1 - 1)); };
    const int first = std::max(fresh.changedFrom(0, 0, valid), rows.y0);
    const int firstTexel = std::max(first - 1, valid.y0), endTexel = std::min(rows.y1 + 1, valid.y1);
    texels_.resizeFrom(valid, firstTexel);
    parallelRows({valid.x0, firstTexel, valid.x1, endTexel}, 16, [&](int y) {
        const ColumnSpan columns = columnsOf(y);
        if (columns.empty()) return;
        HWY_DYNAMIC_DISPATCH(texelRow)
        (buffer, y, columns.x0 - valid.x0, columns.x1 - valid.x0, sharpness, noiseUnit, texels_);
    });
    parallelRows({valid.x0, first - 1, valid.x1, rows.y1}, 16, [&](int y) {
        const ColumnSpan columns = columnsOf(y);
        if (columns.empty()) return;
        HWY_DYNAMIC_DISPATCH(cellRow)
        (texels_, buffer.links, y, columns.x0 - valid.x0, columns.x1 - valid.x0, cells.row(y) + valid.x0);
    });
}

}  // namespace aeolic::cpu
#endif
