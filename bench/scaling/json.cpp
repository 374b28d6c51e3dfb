#include <nlohmann/json.hpp>

#include "description/camera.h"
#include "description/choices.h"
#include "scaling/paper.h"
#include "scaling/scaling_report.h"
#include "version.h"

namespace aeolic {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kPartNames[] = {"nodes", "bricks", "mesh"};

Json networkJson(const NetworkModel& network)
{
    return {{"bytes_per_s", network.bandwidthBytesPerS}, {"latency_us", network.latencyUs}};
}

Json stageJson(const StageStats& stage)
{
    return {{"busy_ms", stage.busyMs},
            {"sent_bytes", stage.sentBytes},
            {"sent_messages", stage.sentMessages},
            {"received_bytes", stage.receivedBytes},
            {"received_messages", stage.receivedMessages}};
}

Json rankJson(const RankStats& rank)
{
    Json stages;
    for (const FrameStage& stage : kFrameStages) stages[stage.name] = stageJson(rank.*stage.stats);
    return {{"rank", rank.rank},
            {"first_row", rank.firstRow},
            {"rows", rank.rows},
            {"guard_rows", {rank.guardAbove, rank.guardBelow}},
            {"pixels", rank.pixels},
            {"guard_pixels_drawn_again", rank.guardPixels},
            {"busy_ms", rank.busyMs},
            {"sent_bytes", rank.sentBytes},
            {"sent_messages", rank.sentMessages},
            {"stages", stages}};
}

Json pathJson(const CriticalPath& path)
{
    Json stages;
    for (std::size_t i = 0; i < path.stages.size(); ++i)
        stages[kFrameStages[i].name] = {{"compute_ms", path.stages[i].computeMs},
                                        {"slowest_rank", path.stages[i].slowestRank},
                                        {"network_ms", path.stages[i].networkMs}};
    return {{"compute_ms", path.computeMs()}, {"network_ms", path.networkMs()}, {"stages", stages}};
}

Json rowJson(const ScalingRow& row)
{
    Json json{{"part", kPartNames[std::size_t(row.part)]},
              {"surface", row.surface},
              {"field", row.field},
              {"bricked", row.bricked},
              {"ranks", row.ranks},
              {"balance", row.balance},
              {"modelled_ms", row.totalMs},
              {"modelled_fps", framesPerSecond(row.totalMs)},
              {"modelled_ms_on_the_papers_network", row.paperNetworkMs}};
    if (row.part == ScalingPart::nodes) {
        json["modelled_speedup"] = row.speedup.value_or(1);
        json["modelled_speedup_on_the_papers_network"] = row.paperNetworkSpeedup.value_or(1);
        json["cpu_ms_by_one_ranks"] = row.work.value_or(1);
        json["wall_speedup"] = row.wallSpeedup ? Json(*row.wallSpeedup) : Json();
        if (const auto there = paper::table1(row.balance, row.ranks)) json["paper_fps"] = *there;
    }
    if (row.slowdown) json["modelled_ms_by_that_of_the_rows_before"] = *row.slowdown;
    json["cpu_ms"] = row.cpuMs;
    json["wall_ms"] = row.wallMs ? Json(*row.wallMs) : Json();
    json["load_balance"] = row.loadBalance;
    json["load_balance_after_90_degrees"] = row.afterJump;
    json["critical_path"] = pathJson(row.path);
    Json ranks = Json::array();
    for (const RankStats& rank : row.ofRanks) ranks.push_back(rankJson(rank));
    json["ranks_of_median_frame"] = ranks;
    return json;
}

Json simulationJson(const ScalingSimulation& simulation)
{
    Json points = Json::array();
    for (const SimulatedPoint& point : simulation.points) {
        const SimulatedFrame& frame = point.frame;
        points.push_back({{"ranks", point.ranks},
                          {"balance", point.balance},
                          {"simulated_ms", frame.totalMs()},
                          {"speedup", simulation.points.front().frame.totalMs() / frame.totalMs()},
                          {"coverage_ms", frame.coverageMs},
                          {"project_ms", frame.projectMs},
                          {"convolve_ms", frame.convolveMs},
                          {"shade_ms", frame.shadeMs},
                          {"gather_ms", frame.gatherMs},
                          {"network_ms", frame.networkMs()},
                          {"load_balance", frame.balance()}});
    }
    return {{"size", {simulation.width, simulation.height}},
            {"covered", simulation.coveredShare},
            {"guard_rows", simulation.guardRows},
            {"guard_received", simulation.guardSource == GuardSource::receive},
            {"points", points}};
}

Json costsJson(const MeasuredCosts& costs)
{
    return {{"project_fixed_ms", costs.projectFixedMs},
            {"project_covered_pixel_ns", costs.projectPixelNs},
            {"project_any_pixel_ns", costs.projectAreaNs},
            {"convolve_covered_pixel_ns", costs.convolvePixelNs},
            {"convolve_guard_pixel_ns", costs.convolveGuardPixelNs},
            {"convolve_any_pixel_ns", costs.convolveAreaNs},
            {"shade_any_pixel_ns", costs.shadePixelNs},
            {"pack_covered_pixel_ns", costs.packPixelNs}};
}

}  // namespace

std::string scalingJson(const ScalingBenchPlan& plan, const ScalingBench& bench)
{
    const SceneDescription& scene = plan.scene;
    Json rows = Json::array(), simulations = Json::array();
    for (const ScalingRow& row : bench.rows) rows.push_back(rowJson(row));
    for (const ScalingSimulation& simulation : bench.simulations) simulations.push_back(simulationJson(simulation));
    const Json document{
        {"version", versionText},
        {"machine",
         {{"backend", bench.backend}, {"device", bench.device}, {"simd", bench.simd}, {"cores", bench.cores}}},
        {"scene",
         {{"surface", scene.surface.spec},
          {"field", scene.field.spec},
          {"large_field", plan.largeField},
          {"mesh", plan.mesh},
          {"size", {scene.output.width, scene.output.height}},
          {"method", nameOf(scene.lic.method)},
          {"integrator", nameOf(scene.lic.integrator)},
          {"steps", scene.lic.steps},
          {"step_px", scene.lic.step},
          {"frames", scene.output.frames},
          {"repeats", plan.repeats},
          {"orbit_degrees", orbitDegOf(scene)}}},
        {"network", networkJson(plan.network)},
        {"papers_network", networkJson(kPaperNetwork)},
        {"one_rank_most_by_least", bench.steadiness ? Json(*bench.steadiness) : Json()},
        {"rows", rows},
        {"costs", bench.costs ? costsJson(*bench.costs) : Json()},
        {"simulations", simulations}};
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace aeolic
