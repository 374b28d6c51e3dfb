#include "output/stats_json.h"

#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "base/median.h"
#include "description/choices.h"
#include "version.h"

namespace aeolic {

namespace {

using Json = nlohmann::ordered_json;

Json stripeJson(const RankStats& rank)
{
    return {{"rank", rank.rank},
            {"first_row", rank.firstRow},
            {"rows", rank.rows},
            {"guard_rows", Json::array({rank.guardAbove, rank.guardBelow})},
            {"pixels", rank.pixels},
            {"busy_ms", rank.busyMs},
            {"sent_bytes", rank.sentBytes},
            {"sent_messages", rank.sentMessages}};
}

Json frameJson(const FrameStats& frame)
{
    Json stripes = Json::array();
    for (const RankStats& rank : frame.ranks) stripes.push_back(stripeJson(rank));
    return {{"total_ms", frame.totalMs},
            {"time", frame.time},
            {"step_ms", frame.stepMs},
            {"stages_ms",
             {{"balance", frame.balanceMs},
              {"project", frame.projectMs},
              {"composite", frame.compositeMs},
              {"convolve", frame.convolveMs},
              {"shade", frame.shadeMs},
              {"gather", frame.gatherMs}}},
            {"stripes", stripes}};
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
        frames.push_back(frameJson(frame));
        totals.push_back(frame.totalMs);
    }
    const double medianMs = median(totals);
    const Json document{
        {"version", versionText},
        {"backend", stats.info.backend},
        {"device", stats.info.device},
        {"simd", stats.info.simd},
        {"unused_gpu", stats.info.unusedGpu},
        {"threads", stats.info.threads},
        {"ranks", stats.info.ranks},
        {"threads_per_rank", stats.info.threadsOfRank},
        {"image",
         {{"width", scene.output.width},
          {"height", scene.output.height},
          {"covered_pixels", stats.frames.empty() ? 0 : stats.frames.back().coveredPixels}}},
        {"lic",
         {{"method", nameOf(scene.lic.method)},
          {"style", nameOf(scene.lic.style)},
          {"flow", nameOf(scene.lic.flow)},
          {"integrator", nameOf(scene.lic.integrator)},
          {"steps", scene.lic.steps},
          {"step_px", scene.lic.step},
          {"kernel", nameOf(scene.lic.kernel)}}},
        {"warnings", stats.info.warnings},
        {"load_ms", stats.info.loadMs},
        {"field_bytes_per_rank", stats.info.fieldBytesOfRank},
        {"peak_rss_bytes_per_rank", stats.peakRssBytesOfRank},
        {"frames", frames},
        {"summary", {{"median_total_ms", medianMs}, {"fps", medianMs > 0 ? 1000.0 / medianMs : 0.0}}},
    };
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace aeolic
