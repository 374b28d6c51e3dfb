#include "bench_scene.h"
#include "description/choices.h"
#include "render/palette.h"

/// The three stages of a frame: project/SIZE/BACKEND, convolve/SIZE/steps:N/lic:METHOD/BACKEND, shade/SIZE/BACKEND.
namespace aeolic::bench {
namespace {

void project(benchmark::State& state, const char* backendName, Size size)
{
    BenchScene& bench = BenchScene::on(backendName);
    const View view = bench.view(size, {});
    const auto draw = [&] { bench.backend->project(view, whole(size)); };
    draw();
    const double covered = double(bench.backend->coveredPixels(0, size.height));
    measure(state, "pixels", covered, draw);
}

void convolve(benchmark::State& state, const char* backendName, Size size, LicMethod method, int steps)
{
    BenchScene& bench = BenchScene::on(backendName);
    const LicOptions lic = licOf(method, steps);
    const View view = bench.view(size, lic);
    const LicOptions walked = inShortSteps(lic, view);
    bench.backend->project(view, whole(size));
    const auto draw = [&] { bench.backend->convolve(walked, whole(size)); };
    draw();  // Gets its memory.
    measure(state, "pixel_steps", 2.0 * walked.steps * double(bench.backend->coveredPixels(0, size.height)), draw);
}

void shade(benchmark::State& state, const char* backendName, Size size)
{
    BenchScene& bench = BenchScene::on(backendName);
    const LicOptions lic = licOf(LicMethod::hierarchical, 16);
    const View view = bench.view(size, lic);
    bench.backend->project(view, whole(size));
    bench.backend->convolve(inShortSteps(lic, view), whole(size));
    const Palette palette = makePalette({}, bench.scene.hasScalar, bench.scene.scalarRange);
    Tile tile;
    tile.resize(whole(size));
    const auto draw = [&] { bench.backend->shade(palette, whole(size), tile), bench.backend->finish(); };
    draw();
    measure(state, "pixels", double(size.width) * size.height, draw);
}

template <class Function, class... Arguments>
void add(const std::string& name, Function function, Arguments... arguments)
{
    benchmark::RegisterBenchmark(name.c_str(), function, arguments...)->Unit(benchmark::kMillisecond);
}

const bool registered = [] {
    for (const char* backend : kBackends)
        for (const Size& size : kSizes) {
            const std::string at = "/" + sizeName(size), on = std::string("/") + backend;
            add("project" + at + on, project, backend, size);
            for (const LicMethod method : {LicMethod::hierarchical, LicMethod::direct})
                for (const int steps : {16, 128, 1024})
                    add("convolve" + at + "/steps:" + std::to_string(steps) + "/lic:" + std::string(nameOf(method)) +
                            on,
                        convolve, backend, size, method, steps);
            add("shade" + at + on, shade, backend, size);
        }
    return true;
}();

}  // namespace
}  // namespace aeolic::bench
