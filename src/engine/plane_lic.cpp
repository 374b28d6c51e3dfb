#include <fmt/format.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "aeolic/error.h"
#include "aeolic/plane.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "description/option_table.h"
#include "description/validate.h"
#include "engine/plane_pixels.h"
#include "render/cpu/lic/fine_cells.h"
#include "render/cpu/lic/lic_stage.h"
#include "render/gbuffer.h"
#include "render/lic/jump_plan.h"
#include "render/lic/lic_kernel.h"
#include "render/lic/phase_mix.h"
#include "render/limits.h"
#include "render/view.h"

namespace aeolic {
namespace {

constexpr std::size_t grain = 16;  // Rows.

/// Repeats a row beside itself, from x0 to x1.
template <class T>
void repeatRow(T* row, int width, int x0, int x1)
{
    for (int x = -1; x >= x0; --x) row[x] = row[x + width];
    for (int x = width; x < x1; ++x) row[x] = row[x - width];
}

/// Rows of a plane as the LIC stage reads a picture. Where the plane is periodic, pixels of its other end follow
/// beside it and below it.
class PlaneRows {
public:
    /// `reach`: how many pixels a value depends on in each direction. `flow` and `lic` stay as long as this does. Cost:
    /// one pass over the plane, which finds the longest vector and the texture's span.
    PlaneRows(const PlaneFlow& flow, const LicOptions& lic, int reach) : flow_(flow), lic_(lic), reach_(reach)
    {
        flowUnitPx_ = std::exp2(std::ceil(std::log2(std::max(lic.step, 1e-3)))) / (flow_texel::kDisplacementMax + 1);
        unitsPerStep_ = lic.step / flowUnitPx_;
        if (lic.style == Style::oriented && !flow.texture) grains_.emplace(lic.seed);
        findScales();
    }

    /// The values of rows [y0, y1) of the plane depend on these rows, and, where it is periodic, on columns from -reach
    /// on.
    Extent extentFor(int y0, int y1) const
    {
        if (flow_.periodic) return {-reach_, y0 - reach_, flow_.width + reach_, y1 + reach_};
        return {0, std::max(y0 - reach_, 0), flow_.width, std::min(y1 + reach_, flow_.height)};
    }

    /// Fills `buffer.flow` and `buffer.links` of that extent, and `fine` where it is not null. The LIC stage reads
    /// nothing else. Rows before `fresh` stay: they are there, and in `fine`, too.
    void fill(const Extent& extent, int fresh, GBuffer& buffer, cpu::FineFlow* fine) const
    {
        buffer.rollFlow(extent);
        if (fine) fine->roll(extent);
        buffer.flowUnitPx = float(flowUnitPx_);
        const int width = flow_.width, height = flow_.height;
        const auto rowsFrom = [&](int first, const auto& body) {
            parallelRanges(std::size_t(extent.y1 - first), grain, [&](std::size_t begin, std::size_t end) {
                for (int y = first + int(begin); y < first + int(end); ++y) body(y);
            });
        };
        rowsFrom(std::max(fresh, extent.y0), [&](int y) {
            std::uint32_t* row = buffer.flow.row(y);
            std::uint32_t* vectors = fine ? fine->vectors.row(y) : nullptr;
            std::uint16_t* noise = fine ? fine->noise.row(y) : nullptr;
            fillRow((y % height + height) % height, row, vectors, noise);
            repeatRow(row, width, extent.x0, extent.x1);
            if (!fine) return;
            repeatRow(vectors, width, extent.x0, extent.x1);
            repeatRow(noise, width, extent.x0, extent.x1);
        });
        rowsFrom(std::max(fresh - limits::kLinkRows, extent.y0), [&](int y) {
            linkRow(buffer.flow.row(y - 1) + extent.x0, buffer.flow.row(y) + extent.x0,
                    buffer.flow.row(y + 1) + extent.x0, extent.width(), buffer.links.row(y) + extent.x0);
        });
    }

private:
    void findScales()
    {
        std::vector<RowScales> ofRow(std::size_t(flow_.height));
        parallelRanges(ofRow.size(), grain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t y = begin; y < end; ++y) {
                const std::size_t first = y * std::size_t(flow_.width);
                ofRow[y] = scalesOf(flow_.u + first, flow_.v + first, flow_.texture ? flow_.texture + first : nullptr,
                                    flow_.width);
            }
        });
        RowScales all;
        for (const RowScales& row : ofRow)
            all = {std::max(all.longest, row.longest), std::min(all.lo, row.lo), std::max(all.hi, row.hi)};
        longest_ = all.longest;
        if (!(all.lo < all.hi)) return;
        middle_ = 0.5F * all.lo + 0.5F * all.hi;
        perUnit_ = 1 / (0.5F * all.hi - 0.5F * all.lo);
        if (!std::isfinite(perUnit_)) perUnit_ = 0;
    }

    void fillRow(int y, std::uint32_t* row, std::uint32_t* fineVectors, std::uint16_t* fineNoise) const
    {
        const std::size_t first = std::size_t(y) * std::size_t(flow_.width);
        // The direction of a vector shorter than a millionth of the longest is the data's rounding noise.
        const PlanePixels pixels{flow_.u + first,
                                 flow_.v + first,
                                 flow_.texture ? flow_.texture + first : nullptr,
                                 grains_ ? &*grains_ : nullptr,
                                 y,
                                 std::uint32_t(first),
                                 lic_.seed,
                                 middle_,
                                 perUnit_,
                                 unitsPerStep_,
                                 lic_.normalize ? 0 : longest_,
                                 lic_.normalize ? 1e-6 * longest_ : 0};
        packRow(pixels, flow_.width, row, fineVectors, fineNoise);
    }

    const PlaneFlow& flow_;
    const LicOptions& lic_;
    const int reach_;
    std::optional<PlaneGrains> grains_;         ///< Of oriented streaks.
    double longest_ = 0;                        ///< Vector; of all that are finite.
    float middle_ = 0, perUnit_ = 0;            ///< Of the texture: the value that becomes 0, and a factor.
    double flowUnitPx_ = 1, unitsPerStep_ = 0;  ///< A step is so many of the units that flow is kept in.
};

/// Traces go no farther than kLongestStepPx at once: a longer step is walked in parts.
LicOptions inShortSteps(LicOptions lic)
{
    const int parts = int(std::ceil(lic.step / double(kLongestStepPx)));
    lic.steps = kernelSteps(lic) * parts;
    lic.step /= parts;
    lic.noiseScale = 1;
    return lic;
}

void check(const PlaneFlow& flow, const LicOptions& lic)
{
    if (!flow.u || !flow.v) throw InputError("lic2d", "found a null pointer", "numbers for u and v");
    if (flow.axial && lic.method == LicMethod::hierarchical)
        throw InputError("lic2d", "found polarization with lic=hierarchical", "lic=direct");
    if (flow.axial && lic.phase != 0)
        throw InputError("lic2d", fmt::format("found polarization with phase={}", lic.phase),
                         "0: without signs no way is forwards");
    if (flow.axial && lic.style == Style::oriented)
        throw InputError("lic2d", "found polarization with style=oriented",
                         "style=dense: without signs no way is forwards");
    if (phase_mix::isComets(lic))
        throw InputError("lic2d", "found flow=loop together with style=oriented", "one or the other on a plane");
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

/// `largest`: of the windows. A periodic plane may be small, and yet its border large.
void requireMemoryFor(const Extent& largest, const PlaneFlow& flow, const LicOptions& asked)
{
    constexpr std::uint64_t bytesPerPixel = 100;  // Flow, links, cells, and the hierarchy's levels.
    constexpr double bytesPerGiB = 1 << 30;
    const std::uint64_t pixels = std::uint64_t(largest.width()) * std::uint64_t(largest.height());
    const std::string size = fmt::format("{} x {} pixels", largest.width(), largest.height());
    if (!flow.periodic) return requireMemory("lic2d", size + " of a plane", pixels * bytesPerPixel);
    const std::uint64_t available = availableMemoryBytes();
    if (pixels * bytesPerPixel <= available) return;
    throw InputError(
        "lic2d",
        fmt::format("steps={} of step={:g} with boundary=\"periodic\" need {} with the border, and {:.1f} GiB",
                    asked.steps, asked.step, size, double(pixels * bytesPerPixel) / bytesPerGiB),
        fmt::format("at most {} pixels, for the {:.1f} GiB of memory that is available: fewer or shorter "
                    "steps, or boundary=\"closed\"",
                    available / bytesPerPixel, double(available) / bytesPerGiB));
}

/// The second convolution reads a few pixels more of the first. `there`: what there is. Columns are whole vectors of
/// any processor where there are more of them.
Extent computedFor(int width, int y0, int y1, const Extent& there)
{
    constexpr int more = limits::kAlongRows, vectors = 64;
    const int x0 = std::max(-more, there.x0), columns = (width + 2 * more + vectors - 1) / vectors * vectors;
    return {x0, std::max(y0 - more, there.y0), std::min(x0 + columns, there.x1), std::min(y1 + more, there.y1)};
}

/// Goes down the plane. `lic`: in short steps.
void convolve(const PlaneFlow& flow, const LicOptions& lic, const PlaneRows& plane, int reach, float* values,
              const std::stop_token& stop)
{
    const int rows = rowsTogether(reach), lastRead = plane.extentFor(flow.height, flow.height).y1;
    GBuffer buffer;
    cpu::FineFlow fine;
    fine.axial = flow.axial;
    cpu::LicStage stage;
    const bool direct = lic.method == LicMethod::direct;
    for (int y0 = 0, y1, known = plane.extentFor(0, 0).y0; y0 < flow.height && !stop.stop_requested(); y0 = y1) {
        // Every window brings `rows` new rows, the first one too. So all windows need about the same memory.
        y1 = known + rows < lastRead ? known + rows - reach : flow.height;
        const Extent extent = plane.extentFor(y0, y1);
        plane.fill(extent, known, buffer, direct ? &fine : nullptr);
        const Extent compute = computedFor(flow.width, y0, y1, extent);
        if (direct) {
            stage.runFine(buffer, fine, lic, compute);
        } else {
            stage.run(buffer, lic, compute, nullptr, FreshRows(known, lic.step));
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

}  // namespace

void licOfPlane(const PlaneFlow& flow, const LicOptions& options, float* values, const std::stop_token& stop)
{
    check(flow, options);
    if (!values) throw InputError("lic2d", "found a null pointer", "memory for the values");
    const LicOptions lic = inShortSteps(options);
    const int reach = guardRowsBound(lic.steps, lic.step, traceReach(lic).levels) + limits::kAlongRows;
    tbb::task_group_context work;  // What is asked to stop skips all that its loops have not begun.
    const std::stop_callback skip(stop, [&] { work.cancel_group_execution(); });
    tbb::task_group(work).run_and_wait([&] {
        const PlaneRows plane(flow, lic, reach);
        requireMemoryFor(plane.extentFor(reach, reach + std::min(rowsTogether(reach), flow.height)), flow, options);
        convolve(flow, lic, plane, reach, values, stop);
    });
}

void licOfPlane(const PlaneFlow& flow, const LicOptions& lic, float* values)
{
    licOfPlane(flow, lic, values, {});
}

std::vector<float> licOfPlane(const PlaneFlow& flow, const LicOptions& lic)
{
    check(flow, lic);
    std::vector<float> values(std::size_t(flow.width) * std::size_t(flow.height));
    licOfPlane(flow, lic, values.data());
    return values;
}

}  // namespace aeolic
