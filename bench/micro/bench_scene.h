#pragma once

#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "base/timing.h"
#include "data/scene.h"
#include "render/backend.h"
#include "render/view.h"

/// What the micro-benchmarks share: one scene on one backend, in a few sizes, and rates by wall time.
namespace aeolic::bench {

struct Size {
    int width, height;
};
inline constexpr Size kSizes[] = {{800, 800}, {1920, 1080}, {3840, 2160}};
std::string sizeName(const Size& size);  ///< "800x800"

inline constexpr const char* kBackends[] = {"cpu"};

/// The teapot under the ABC flow, filling some 70 % of the picture, as `aeolic-bench stages` draws it.
struct BenchScene {
    Scene scene;
    std::unique_ptr<Backend> backend;

    /// Made at first use and kept: loading is not measured.
    static BenchScene& on(const std::string& backendName);

    View view(const Size& size, const LicOptions& lic) const;

private:
    explicit BenchScene(const std::string& backendName);
    double radius_ = 0;
};

/// The direct or hierarchical method with a kernel of `steps`.
LicOptions licOf(LicMethod method, int steps);

inline Extent whole(const Size& size)
{
    return {0, 0, size.width, size.height};
}

/// Runs `body` for each iteration, and counts `perIteration` of `unit` by wall time: most of the work is on other
/// threads, whose time Google Benchmark's own rates leave out.
template <class Body>
void measure(benchmark::State& state, const char* unit, double perIteration, const Body& body)
{
    StopWatch watch;
    for (auto iteration : state) {
        static_cast<void>(iteration);
        body();
    }
    state.counters[std::string(unit) + "/s"] = perIteration * double(state.iterations()) / (watch.lapMs() * 1e-3);
}

}  // namespace aeolic::bench
