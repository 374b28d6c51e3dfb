#include "bench_scene.h"
#include "render/cpu/lic/flow_cells.h"
#include "render/cpu/lic/hierarchical.h"
#include "render/cpu/project/links.h"
#include "render/cpu/project/projection.h"

/// Parts of the cpu backend's stages: link_sheets/SIZE/cpu, flow_cells/SIZE/lic:METHOD/cpu.
namespace aeolic::bench {
namespace {

void linkSheets(benchmark::State& state, Size size)
{
    BenchScene& bench = BenchScene::on("cpu");
    const View view = bench.view(size, {});
    GBuffer buffer;
    cpu::Projection projection(bench.scene);
    projection.draw(view, whole(size), whole(size), buffer);
    measure(state, "pixels", double(size.width) * size.height, [&] { cpu::linkSheets(view, whole(size), buffer); });
}

void flowCells(benchmark::State& state, Size size, float sharpness)
{
    BenchScene& bench = BenchScene::on("cpu");
    bench.backend->project(bench.view(size, {}), whole(size));
    const GBuffer& buffer = bench.backend->probe().gbuffer();
    cpu::FlowCells cells;
    const Extent& valid = buffer.valid();
    const NearFlow near(valid, std::vector<ColumnSpan>(std::size_t(valid.height()), {valid.x0, valid.x1}));
    cells.build(buffer, near, sharpness);
    measure(state, "pixels", double(size.width) * size.height, [&] { cells.build(buffer, near, sharpness); });
}

const bool registered = [] {
    for (const Size& size : kSizes) {
        const std::string at = "/" + sizeName(size);
        const auto add = [&](const std::string& name, auto function, auto... arguments) {
            benchmark::RegisterBenchmark(name.c_str(), function, size, arguments...)->Unit(benchmark::kMillisecond);
        };
        add("link_sheets" + at + "/cpu", linkSheets);
        add("flow_cells" + at + "/lic:direct/cpu", flowCells, 0.0f);
        add("flow_cells" + at + "/lic:hierarchical/cpu", flowCells, kHierarchicalSharpness);
    }
    return true;
}();

}  // namespace
}  // namespace aeolic::bench
