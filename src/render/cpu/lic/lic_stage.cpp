#include "render/cpu/lic/lic_stage.h"

#include <algorithm>

#include "base/parallel.h"
#include "render/cpu/lic/cpu_along_flow.h"
#include "render/cpu/lic/direct.h"
#include "render/lic/along_flow.h"

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
    parallelRows(rows, 64, [&](int y) {
        const bool own = !guards || (y >= compute.y0 && y < compute.y1);
        const ColumnSpan& columns = buffer.surfaceColumns(y);
        flow[std::size_t(y - rows.y0)] =
            own ? flowColumns(buffer.flow.row(y), columns.x0, columns.x1) : guards->flowOf(y);
    });
    return {rows, flow};
}

void LicStage::run(GBuffer& buffer, const LicOptions& lic, const Extent& compute, GuardExchange* guards,
                   const FreshRows& fresh)
{
    lic_.resize(compute);
    if (lic.method == LicMethod::none) {
        lic_.fill(compute, 0);
    } else if (lic.method == LicMethod::hierarchical) {
        const int direct = planJumps(lic.steps).direct;
        const NearFlow near = receiveFlow(buffer, compute, guards, direct);
        flow_.build(buffer, near, kHierarchicalSharpness, fresh, direct);
        convolveHierarchical(buffer, flow_, near, lic, compute, guards, fresh, hierarchy_, lic_);
    } else {
        flow_.build(buffer, receiveFlow(buffer, compute, guards, lic.steps), 0);
        convolveDirect(buffer, flow_, lic, compute, lic_);
    }
}

void LicStage::runFine(const GBuffer& buffer, const FineFlow& fine, const LicOptions& lic, const Extent& compute)
{
    lic_.resize(compute);
    fine_.build(buffer, fine);
    convolveDirect(buffer, fine_, lic, compute, lic_);
    smooth(buffer, lic, compute, nullptr, 0, &fine);
}

void LicStage::smooth(const GBuffer& buffer, const LicOptions& lic, const Extent& compute, RowExchange* beside,
                      int more, const FineFlow* fine)
{
    const int around = compute.empty() ? 0 : more;
    const Extent shown = withNeighbours(compute, buffer.valid(), around);
    if (lic.method == LicMethod::none) {
        lic_.resize(shown);
        lic_.fill(shown, 0);
    } else if (along_flow::wanted(lic)) {
        words_.resize(withNeighbours(compute, buffer.valid(), around + limits::kAlongRows));
        packValues(buffer, lic_, compute, words_);
        if (beside) beside->receive(imageRows(words_), more + limits::kAlongRows);
        lic_.resize(shown);
        smoothAlongFlow(buffer, fine, words_, along_flow::gain(lic), shown, lic_);
    } else if (beside && more > 0) {
        lic_.roll(shown, shown.y0);
        beside->receive(imageRows(lic_), more);
    }
}

}  // namespace aeolic::cpu
