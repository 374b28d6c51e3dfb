#include "render/cpu/lic/lic_stage.h"

#include <algorithm>
#include <cstring>

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
        runHierarchical(buffer, lic, compute, guards, {});
    } else {
        flow_.build(buffer, receiveFlow(buffer, compute, guards, lic.steps), 0);
        convolveDirect(buffer, flow_, lic, compute, lic_);
    }
}

void LicStage::runOn(GBuffer& buffer, const LicOptions& lic, const Extent& compute, const FreshRows& fresh)
{
    lic_.resize(compute);
    runHierarchical(buffer, lic, compute, nullptr, fresh);
}

void LicStage::runHierarchical(GBuffer& buffer, const LicOptions& lic, const Extent& compute, GuardExchange* guards,
                               const FreshRows& fresh)
{
    const int direct = planJumps(lic.steps).direct;
    const NearFlow near = receiveFlow(buffer, compute, guards, direct);
    flow_.build(buffer, near, kHierarchicalSharpness, fresh, direct);
    convolveHierarchical(buffer, flow_, near, lic, compute, guards, fresh, hierarchy_, lic_);
}

void LicStage::runFine(const GBuffer& buffer, const FineFlow& fine, const LicOptions& lic, const Extent& compute)
{
    lic_.resize(compute);
    fine_.build(buffer, fine);
    convolveDirect(buffer, fine_, lic, compute, lic_);
    smooth(buffer, &fine, lic, compute, nullptr, 0);
}

void LicStage::smooth(const GBuffer& buffer, const FineFlow* fine, const LicOptions& lic, const Extent& compute,
                      RowExchange* beside, int more)
{
    const int around = compute.empty() ? 0 : more;
    const Extent shown = withNeighbours(compute, buffer.valid(), around);
    if (lic.method == LicMethod::none) {
        lic_.resize(shown);
        for (int y = shown.y0; y < shown.y1; ++y) std::fill_n(&lic_.at(shown.x0, y), shown.width(), 0.0f);
    } else if (along_flow::wanted(lic)) {
        words_.resize(withNeighbours(compute, buffer.valid(), around + limits::kAlongRows));
        packValues(buffer, lic_, compute, words_);
        if (beside) beside->receive(imageRows(words_), more + limits::kAlongRows);
        lic_.resize(shown);
        smoothAlongFlow(buffer, fine, words_, along_flow::gain(lic), shown, lic_);
    } else if (beside && more > 0) {
        const auto copy = [](const auto& from, auto& to, const Extent& rows) {
            for (int y = rows.y0; y < rows.y1; ++y)
                std::memcpy(&to.at(rows.x0, y), &from.at(rows.x0, y), std::size_t(rows.width()) * sizeof(float));
        };
        words_.resize(shown);
        copy(lic_, words_, compute);
        beside->receive(imageRows(words_), more);
        lic_.resize(shown);
        copy(words_, lic_, shown);
    }
}

}  // namespace aeolic::cpu
