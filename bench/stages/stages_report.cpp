#include "stages/stages_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "description/choices.h"
#include "version.h"

namespace aeolic {
namespace {

using Json = nlohmann::ordered_json;

std::string_view methodName(LicMethod method)
{
    return nameOf(method);
}

double coveredShare(const StagesBenchRow& row)
{
    return double(row.coveredPixels) / (double(row.size.width) * double(row.size.height));
}

std::string rateLine(const char* name, const cpu::LaneRate& rate)
{
    return fmt::format("  {:<26}{:7.2f} G lanes/s on one thread{:9.2f} on all\n", name, rate.oneThread * 1e-9,
                       rate.allThreads * 1e-9);
}

std::string heading(const StagesBenchPlan& plan, const StagesBench& bench)
{
    const SceneDescription& scene = plan.scene;
    std::string text = fmt::format("{}: {}, {}threads: {}\n", bench.backend, bench.device,
                                   bench.simd.empty() ? "" : bench.simd + ", ", bench.threads);
    text += fmt::format("surface {}, field {}; direct integrates by {}; kernel {}; medians of {}\n", scene.surface.spec,
                        scene.field.spec.empty() ? "the surface's own" : scene.field.spec, nameOf(scene.lic.integrator),
                        nameOf(scene.lic.kernel), plan.repeats);
    if (bench.gatherRates) {
        text += "\nWhat this machine fetches at most, 32-bit lanes, 1 MiB working set:\n";
        text += rateLine("32-bit gather instruction", bench.gatherRates->gather);
        text += rateLine("128-bit block loads", bench.gatherRates->blocks);
    }
    if (bench.fetchRates)
        text += fmt::format(
            "\nWhat this device does at most: {:.2f} G texels/s gathered by fours along traces, {:.1f} GB/s copied.\n",
            bench.fetchRates->lanesPerS * 1e-9, bench.fetchRates->bytesPerS * 1e-9);
    return text + "\n";
}

std::string columns(const StagesBench& bench)
{
    std::string text = fmt::format("{:<10}{:>5}  {:<12} {:>5} {:>8} {:>9} {:>6} {:>9} {:>8} {:>6}", "size", "cover",
                                   "method", "steps", "project", "convolve", "shade", "total ms", "Gsteps/s", "walked");
    if (bench.gatherRates) text += fmt::format(" {:>8} {:>6} {:>6}", "Glanes/s", "gather", "blocks");
    if (bench.fetchRates)
        text += fmt::format(" {:>9} {:>9} {:>9} {:>6}", "device ms", "read back", "following", "fetch");
    return text + "\n";
}

std::string rowLine(const StagesBenchRow& row, bool lanes)
{
    const std::string size = fmt::format("{}x{}", row.size.width, row.size.height);
    std::string text =
        fmt::format("{:<10}{:>4.0f}%  {:<12} {:>5} {:>8.2f} {:>9.2f} {:>6.2f} {:>9.2f} {:>8.2f} {:>5.0f}%", size,
                    100 * coveredShare(row), methodName(row.method), row.steps, row.projectMs, row.convolveMs,
                    row.shadeMs, row.totalMs, row.pixelStepsPerS * 1e-9, 100 * row.walkedShare);
    if (lanes)
        text += fmt::format(" {:>8.2f} {:>5.0f}% {:>5.0f}%", row.lanesPerS * 1e-9, 100 * row.shareOfGatherRate,
                            100 * row.shareOfBlockRate);
    if (row.device)
        text += fmt::format(" {:>9.3f} {:>9.3f} {:>9.3f} {:>5.0f}%", row.device->stagesMs, row.device->readBackMs,
                            row.device->followingMs, 100 * row.shareOfFetchRate);
    return text + "\n";
}

Json rateJson(const cpu::LaneRate& rate)
{
    return {{"one_thread", rate.oneThread}, {"all_threads", rate.allThreads}};
}

Json rowJson(const StagesBenchRow& row, bool lanes)
{
    Json json{
        {"size", {row.size.width, row.size.height}},
        {"covered_pixels", row.coveredPixels},
        {"covered", coveredShare(row)},
        {"method", methodName(row.method)},
        {"steps", row.steps},
        {"stages_ms",
         {{"project", row.projectMs}, {"convolve", row.convolveMs}, {"shade", row.shadeMs}, {"total", row.totalMs}}},
        {"pixel_steps_per_s", row.pixelStepsPerS},
        {"walked_share", row.walkedShare}};
    if (row.device) {
        json["stages_ms"]["device_total"] = row.device->stagesMs;
        json["stages_ms"]["read_back"] = row.device->readBackMs;
        json["following_frame_ms"] = row.device->followingMs;
        json["lanes_per_s"] = row.lanesPerS;
        json["share_of_fetch_rate"] = row.shareOfFetchRate;
    }
    if (lanes) {
        json["lanes_per_s"] = row.lanesPerS;
        json["lanes_per_s_at_most"] = row.mostLanesPerS;
        json["share_of_gather_rate"] = row.shareOfGatherRate;
        json["share_of_block_load_rate"] = row.shareOfBlockRate;
    }
    return json;
}

}  // namespace

std::string StagesTable::next(const StagesBench& soFar)
{
    std::string text;
    if (!std::exchange(begun_, true)) text = heading(plan_, soFar) + columns(soFar);
    for (; rows_ < soFar.rows.size(); ++rows_) {
        if (rows_ > 0 && soFar.rows[rows_].method != soFar.rows[rows_ - 1].method) text += "\n";
        text += rowLine(soFar.rows[rows_], soFar.gatherRates.has_value());
    }
    return text;
}

std::string StagesTable::notes(const StagesBench& all)
{
    std::string text =
        "\nGsteps/s: covered pixels x 2 directions x steps, by the time of the LIC stage (convolve). A step that the\n"
        "view would show too long is walked in parts, and each part counts.\n"
        "walked: how many of those steps traces take before they end at silhouettes; estimated from a sample.\n";
    if (all.gatherRates)
        text +=
            "Glanes/s: 32-bit lanes that the LIC stage fetches for traces that still go on, without those of finished\n"
            "traces in the same vector. gather, blocks: these lanes as a share of the machine's two rates above.\n";
    if (all.fetchRates)
        text +=
            "Times of stages, device and read back are the GPU's own; total is wall time, until the pixels are in "
            "this\n"
            "process's memory. following: wall time of a frame among others that follow each other, each drawn while\n"
            "the one before is read back.\n"
            "fetch: texels that traces gather in the LIC stage, as a share of what the device gathers at most.\n";
    return text;
}

std::string stagesJson(const StagesBenchPlan& plan, const StagesBench& bench)
{
    Json rates;
    if (bench.gatherRates)
        rates = {{"unit", "32-bit lanes per second"},
                 {"working_set_bytes", cpu::kGatherSetBytes},
                 {"gather_instruction", rateJson(bench.gatherRates->gather)},
                 {"block_loads", rateJson(bench.gatherRates->blocks)}};
    if (bench.fetchRates)
        rates = {{"unit", "32-bit texels per second, bytes per second"},
                 {"gathers", bench.fetchRates->lanesPerS},
                 {"copy_bytes", bench.fetchRates->bytesPerS}};
    Json rows = Json::array();
    for (const StagesBenchRow& row : bench.rows) rows.push_back(rowJson(row, bench.gatherRates.has_value()));
    const SceneDescription& scene = plan.scene;
    const Json document{
        {"version", versionText},
        {"machine",
         {{"backend", bench.backend}, {"device", bench.device}, {"simd", bench.simd}, {"threads", bench.threads}}},
        {"scene",
         {{"surface", scene.surface.spec},
          {"field", scene.field.spec},
          {"integrator", nameOf(scene.lic.integrator)},
          {"kernel", nameOf(scene.lic.kernel)},
          {"step_px", scene.lic.step}}},
        {"repeats", plan.repeats},
        {"gather_rates", rates},
        {"rows", rows}};
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace aeolic
