#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "aeolic/error.h"
#include "aeolic/plane.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "description/option_table.h"
#include "description/validate.h"
#include "engine/plane_rows.h"
#include "render/cpu/lic/lic_stage.h"
#include "render/lic/jump_plan.h"
#include "render/limits.h"

namespace aeolic {
namespace {

/// Traces go no farther than kLongestStepPx at once: a longer step is walked in parts.
LicOptions inShortSteps(LicOptions lic)
{
    const int parts = int(std::ceil(lic.stepPx / double(kLongestStepPx)));
    lic.steps *= parts;
    lic.stepPx /= parts;
    lic.noiseScale = 1;
    return lic;
}

void check(const PlaneFlow& flow, const LicOptions& lic)
{
    if (!flow.u || !flow.v) throw InputError("lic2d", "found a null pointer", "numbers for u and v");
    SceneDescription scene;
    scene.lic = lic;
    validate(scene, commandLineName);
    for (const int side : {flow.width, flow.height})
        if (!options::side.accepts(side))
            throw InputError(
                "lic2d", fmt::format("a plane of {} x {} pixels", flow.width, flow.height),
                fmt::format("from {:.0f} to {:.0f} in each direction", options::side.lo, options::side.hi));
}

/// How many rows the window goes down at once. More rows need more memory, and memory that is new takes time. Fewer
/// rows move up more often: those that the next window keeps are as many as streaks are long. By measurement.
int rowsTogether(int reach)
{
    constexpr int least = 192;
    return std::max(least, 2 * reach + 64);
}

void requireMemoryFor(const Extent& largest)
{
    constexpr std::int64_t bytesPerPixel = 100;  // Flow, links, cells, and the hierarchy's levels.
    requireMemory("lic2d", fmt::format("{} x {} pixels of a plane", largest.width(), largest.height()),
                  std::uint64_t(largest.width()) * std::uint64_t(largest.height()) * bytesPerPixel);
}

}  // namespace

void licOfPlane(const PlaneFlow& flow, const LicOptions& options, float* values)
{
    check(flow, options);
    if (!values) throw InputError("lic2d", "found a null pointer", "memory for the values");
    const LicOptions lic = inShortSteps(options);
    const int reach = guardRowsBound(lic.steps, lic.stepPx, traceReach(lic).levels) + limits::kAlongRows;
    const PlaneRows plane(flow, lic, reach);
    const int rows = rowsTogether(reach), lastRead = plane.extentFor(flow.height, flow.height).y1;
    requireMemoryFor(plane.extentFor(reach, reach + rows));
    GBuffer buffer;
    cpu::FineFlow fine;
    cpu::LicStage stage;
    const bool direct = lic.method == LicMethod::direct;
    for (int y0 = 0, y1, known = plane.extentFor(0, 0).y0; y0 < flow.height; y0 = y1) {
        // Of each window, the first one included, as many rows are new. So all need about the same memory.
        y1 = known + rows < lastRead ? known + rows - reach : flow.height;
        const Extent extent = plane.extentFor(y0, y1);
        plane.fill(extent, known, buffer, direct ? &fine : nullptr);
        // The second convolution reads a few rows more of the first.
        const Extent compute{extent.x0, std::max(y0 - limits::kAlongRows, extent.y0), extent.x1,
                             std::min(y1 + limits::kAlongRows, extent.y1)};
        if (direct) {
            stage.runFine(buffer, fine, lic, compute);
        } else {
            stage.runOn(buffer, lic, compute, FreshRows(known, lic.stepPx));
            stage.smooth(buffer, lic, compute, nullptr);
        }
        known = extent.y1;
        parallelRanges(std::size_t(y1 - y0), 16, [&](std::size_t begin, std::size_t end) {
            for (int y = y0 + int(begin); y < y0 + int(end); ++y) {
                const std::uint32_t* there = buffer.flow.row(y);
                const float* from = stage.values().row(y);
                float* to = values + std::size_t(y) * std::size_t(flow.width);
                for (int x = 0; x < flow.width; ++x)
                    to[x] = there[x] == 0 ? std::numeric_limits<float>::quiet_NaN() : from[x];
            }
        });
    }
}

std::vector<float> licOfPlane(const PlaneFlow& flow, const LicOptions& lic)
{
    check(flow, lic);
    std::vector<float> values(std::size_t(flow.width) * std::size_t(flow.height));
    licOfPlane(flow, lic, values.data());
    return values;
}

}  // namespace aeolic
