#include "scene/stats_json.h"

#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scene/scene_text.h"
#include "version.h"

namespace aeolic {

namespace {

using Json = nlohmann::ordered_json;

double median(std::vector<double> values)
{
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// One frame of a single process: one stripe that is the whole image and sends nothing.
Json frameJson(const FrameStats& frame, int height)
{
    return {{"total_ms", frame.totalMs},
            {"stages_ms",
             {{"project", frame.projectMs},
              {"composite", frame.compositeMs},
              {"convolve", frame.convolveMs},
              {"shade", frame.shadeMs},
              {"gather", frame.gatherMs}}},
            {"stripes", Json::array({{{"rank", 0},
                                      {"first_row", 0},
                                      {"rows", height},
                                      {"guard_rows", Json::array({0, 0})},
                                      {"pixels", frame.coveredPixels},
                                      {"busy_ms", frame.busyMs},
                                      {"sent_bytes", 0}}})}};
}

}  // namespace

std::uint64_t peakRssBytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::uint64_t(usage.ru_maxrss) * 1024;  // Linux counts in KiB.
}

std::string statsToJson(const RunStats& stats)
{
    const SceneDescription& scene = stats.scene;
    Json frames = Json::array();
    std::vector<double> totals;
    for (const FrameStats& frame : stats.frames) {
        frames.push_back(frameJson(frame, scene.output.height));
        totals.push_back(frame.totalMs);
    }
    const double medianMs = median(totals);
    const Json document{
        {"version", versionText},
        {"backend", stats.info.backend},
        {"device", stats.info.device},
        {"simd", stats.info.simd},
        {"threads", stats.info.threads},
        {"ranks", 1},
        {"image",
         {{"width", scene.output.width},
          {"height", scene.output.height},
          {"covered_pixels", stats.frames.empty() ? 0 : stats.frames.back().coveredPixels}}},
        {"lic",
         {{"method", fieldText(scene, "--lic")},
          {"integrator", fieldText(scene, "--integrator")},
          {"steps", scene.lic.steps},
          {"step_px", scene.lic.stepPx},
          {"kernel", fieldText(scene, "--kernel")}}},
        {"load_ms", stats.info.loadMs},
        {"field_bytes_per_rank", Json::array({stats.info.fieldBytes})},
        {"peak_rss_bytes_per_rank", Json::array({stats.peakRssBytes})},
        {"frames", frames},
        {"summary", {{"median_total_ms", medianMs}, {"fps", medianMs > 0 ? 1000.0 / medianMs : 0.0}}},
    };
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace aeolic
