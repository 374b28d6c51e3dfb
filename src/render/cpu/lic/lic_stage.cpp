#include "render/cpu/lic/lic_stage.h"

#include <algorithm>

#include "base/parallel.h"
#include "render/along_flow.h"
#include "render/cpu/lic/along_flow.h"
#include "render/cpu/lic/direct.h"

namespace aeolic::cpu {

NearFlow LicStage::receiveFlow(GBuffer& buffer, const Extent& compute, GuardExchange* guards, int steps)
{
    const Extent& valid = buffer.valid();
    Extent rows = valid;
    if (guards) {
        guards->receive({{{imageRows(buffer.flow), imageRows(buffer.links)}, steps}});
        const GuardRows guard = guards->rows(steps);
        rows.y0 = std::max(compute.y0 - guard.above, valid.y0);
        rows.y1 = std::min(compute.y1 + guard.below, valid.y1);
    }
    std::vector<ColumnSpan> flow(std::size_t(std::max(rows.height(), 0)));
    parallelRanges(flow.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const int y = rows.y0 + int(i);
            const bool own = !guards || (y >= compute.y0 && y < compute.y1);
            const ColumnSpan& columns = buffer.surfaceColumns(y);
            flow[i] = own ? flowColumns(buffer.flow.row(y), columns.x0, columns.x1) : guards->flowOf(y);
        }
    });
    return {rows, flow};
}

void LicStage::run(GBuffer& buffer, const LicOptions& lic, const Extent& compute, GuardExchange* guards)
{
    lic_.resize(compute);
    if (lic.method == LicMethod::none) {
        for (int y = compute.y0; y < compute.y1; ++y) std::fill_n(&lic_.at(compute.x0, y), compute.width(), 0.0f);
    } else if (lic.method == LicMethod::hierarchical) {
        const NearFlow near = receiveFlow(buffer, compute, guards, planJumps(lic.steps).direct);
        flow_.build(buffer, near, kHierarchicalSharpness);
        convolveHierarchical(buffer, flow_, near, lic, compute, guards, hierarchy_, lic_);
    } else {
        flow_.build(buffer, receiveFlow(buffer, compute, guards, lic.steps), 0);
        convolveDirect(buffer, flow_, lic, compute, lic_);
    }
}

void LicStage::smooth(const GBuffer& buffer, const LicOptions& lic, const Extent& compute, RowExchange* beside)
{
    if (!along_flow::wanted(lic)) return;
    words_.resize(withNeighbours(compute, buffer.valid(), limits::kAlongRows));
    packValues(buffer, lic_, compute, words_);
    if (beside) beside->receive(imageRows(words_), limits::kAlongRows);
    smoothAlongFlow(buffer, words_, along_flow::gain(lic), compute, lic_);
}

}  // namespace aeolic::cpu
