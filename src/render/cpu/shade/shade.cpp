#include "render/cpu/shade/shade.h"

#include <bit>

#include "base/parallel.h"
#include "render/cpu/edges/find_edges.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/shade/shade.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/shade/surface_color-inl.h"
#include "render/cpu/simd/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void shadeRow(const ShadeInput& input, int y, int x0, int x1, std::uint8_t* out)
{
    const auto& [buffer, lic, open, palette] = input;
    const DF d;
    const DU du;
    const std::size_t lanes = hn::Lanes(d);
    HWY_ALIGN std::uint32_t pixels[hn::MaxLanes(d)];
    const auto background = hn::Set(du, std::bit_cast<std::uint32_t>(palette.background));
    for (int x = x0; x < x1; x += int(lanes)) {
        auto color = background;
        const auto covered = hn::Gt(hn::LoadU(d, buffer.invDepth.row(y) + x), hn::Zero(d));
        if (!hn::AllFalse(d, covered)) {
            VF light = hn::LoadU(d, buffer.light.row(y) + x);
            if (palette.occlusion) light = hn::Mul(light, hn::LoadU(d, open.row(y) + x));
            const VF scalar = palette.useScalar ? hn::LoadU(d, buffer.scalar.row(y) + x) : hn::Zero(d);
            VI kinds = hn::Zero(DI());
            if (!palette.tables.empty())
                kinds = hn::PromoteTo(DI(), hn::LoadU(hn::Rebind<std::uint8_t, DI>(), buffer.colors.row(y) + x));
            const VU surface = surfaceColor(palette, hn::LoadU(d, lic.row(y) + x), light, scalar, kinds);
            color = hn::IfThenElse(hn::RebindMask(du, covered), surface, background);
        }
        hn::Store(color, du, pixels);
        std::copy_n(reinterpret_cast<const std::uint8_t*>(pixels), 4 * std::min(lanes, std::size_t(x1 - x)),
                    out + 4 * (x - x0));
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(shadeRow);

void shadeRows(const ShadeInput& input, const Extent& compute, Tile& out)
{
    const GBuffer& buffer = input.buffer;
    const Palette& palette = input.palette;
    out.setBackground(palette.background);
    parallelRows(compute, 8, [&](int y) {
        const ColumnSpan columns = palette.antialias ? edgeColumns(buffer, y) : buffer.surfaceColumns(y);
        out.clearBeside(y, columns);
        std::uint8_t* first = out.row(y) + 4 * std::ptrdiff_t(columns.x0 - out.extent.x0);
        HWY_DYNAMIC_DISPATCH(shadeRow)(input, y, columns.x0, columns.x1, first);
    });
}

}  // namespace aeolic::cpu
#endif
