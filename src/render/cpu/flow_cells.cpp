#include "render/cpu/flow_cells.h"

#include "base/parallel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/flow_cells.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void buildRow(const GBuffer& buffer, int y, FlowCell* out)
{
    const hn::ScalableTag<std::uint32_t> d;
    const hn::Rebind<std::uint8_t, decltype(d)> d8;
    const int lanes = int(hn::Lanes(d));
    const std::ptrdiff_t stride = buffer.flow.stride();
    const Extent& valid = buffer.valid();
    const auto one = hn::Set(d, 1u);
    const auto texel = [&](std::ptrdiff_t at) {
        const auto flow = hn::LoadU(d, buffer.flow.origin() + at);
        const auto links = hn::PromoteTo(d, hn::LoadU(d8, buffer.links.origin() + at));
        return hn::Or(hn::AndNot(one, flow), hn::IfThenElseZero(hn::Eq(links, hn::Set(d, 0xFFu)), one));
    };
    const std::ptrdiff_t row = (y - valid.y0) * stride;
    // From the last columns of the left apron, so that cell -1 is there, to the end of the row; zeros beyond the image.
    for (int x = -lanes; x < valid.width(); x += lanes) {
        const std::ptrdiff_t at = row + x;
        hn::StoreInterleaved4(texel(at), texel(at + 1), texel(at + stride), texel(at + stride + 1), d, out[x].texel);
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(buildRow);

void FlowCells::build(const GBuffer& buffer)
{
    const Extent& valid = buffer.valid();
    cells.resize({valid.x0, valid.y0 - 1, valid.x1, valid.y1});
    parallelRanges(std::size_t(valid.height() + 1), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const int y = valid.y0 - 1 + int(i);
            HWY_DYNAMIC_DISPATCH(buildRow)(buffer, y, cells.row(y) + valid.x0);
        }
    });
}

}  // namespace aeolic::cpu
#endif
