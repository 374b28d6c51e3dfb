#include "scaling/scaling_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "description/camera.h"
#include "description/choices.h"
#include "scaling/paper.h"

namespace aeolic {
namespace {

double worst(const std::vector<double>& balances)
{
    return balances.empty() ? 1 : *std::min_element(balances.begin(), balances.end());
}

std::string heading(const ScalingBenchPlan& plan, const ScalingBench& bench)
{
    const SceneDescription& scene = plan.scene;
    std::string text = fmt::format("{}: {}, {}, cores: {}\n", bench.backend, bench.device, bench.simd, bench.cores);
    text += fmt::format("{}, {}, turned by {} degrees in {} pictures of {}x{}, each measured {} times\n",
                        scene.surface.spec, scene.field.spec.empty() ? "its own vectors" : "field " + scene.field.spec,
                        orbitDegOf(scene), scene.output.frames, scene.output.width, scene.output.height, plan.repeats);
    text += fmt::format("{}, {} steps each way, {}, guard {}\n", nameOf(scene.lic.method), scene.lic.steps,
                        nameOf(scene.lic.integrator), nameOf(scene.run.guard));
    return text;
}

const ScalingRow* find(const ScalingBench& bench, const std::string& balance, int ranks)
{
    for (const ScalingRow& row : bench.rows)
        if (row.part == ScalingPart::nodes && row.ranks == ranks && (row.balance == balance || ranks == 1)) return &row;
    return nullptr;
}

std::string tableLine(const std::string& balance, const char* whose, const std::vector<int>& ranks,
                      const std::function<std::string(int)>& cell)
{
    std::string line = fmt::format("{:<7}{:<7}", balance, whose);
    for (const int n : ranks) line += fmt::format(" {:>11}", cell(n));
    return line + "\n";
}

/// At most 11 characters, up to 99,999 pictures a second: tiny pictures reach tens of thousands.
std::string fpsAndSpeedup(double ms, std::optional<double> speedup)
{
    const auto decimals = [](double value) { return value < 9.995 ? 2 : value < 99.95 ? 1 : 0; };
    const double rate = framesPerSecond(ms), times = speedup.value_or(1);
    return fmt::format("{:.{}f} ({:.{}f})", rate, decimals(rate), times,
                       std::min(decimals(times), rate < 9999.5 ? 2 : 1));
}

/// The paper's Table 1: for each balancer a line with the network asked for, one with the paper's network, and the
/// paper's own numbers.
std::string nodesTable(const ScalingBenchPlan& plan, const ScalingBench& bench)
{
    std::string text = fmt::format(
        "\nFrames per second, modelled, and speedup, with a network of {};\n"
        "theirs: with that of Bachthaler et al. 2006, {}; paper: their Table 1\n{:<14}",
        networkText(plan.network), networkText(kPaperNetwork), "nodes");
    for (const int n : plan.ranks) text += fmt::format("{:>12}", n);
    text += "\n";
    for (const std::string& balance : plan.balancers) {
        text += tableLine(balance, "Aeolic", plan.ranks, [&](int n) -> std::string {
            const ScalingRow* row = find(bench, balance, n);
            return row ? fpsAndSpeedup(row->totalMs, row->speedup) : "-";
        });
        text += tableLine("", "theirs", plan.ranks, [&](int n) -> std::string {
            const ScalingRow* row = find(bench, balance, n);
            return row ? fpsAndSpeedup(row->paperNetworkMs, row->paperNetworkSpeedup) : "-";
        });
        if (!paper::table1(balance, 1)) continue;
        text += tableLine("", "paper", plan.ranks, [&](int n) -> std::string {
            const auto there = paper::table1(balance, n), one = paper::table1(balance, 1);
            return there ? fmt::format("{:.2f} ({:.1f})", *there, *there / *one) : "-";
        });
    }
    return text;
}

/// Room for the stage's name and for 99,999.99 ms, so that no cell touches the one before: direct LIC of large pictures
/// takes seconds on one rank.
std::size_t stageWidth(std::string_view name)
{
    return std::max<std::size_t>(9, name.size() + 1);
}

std::string stageNames()
{
    std::string text;
    for (const FrameStage& stage : kFrameStages) text += fmt::format("{:>{}}", stage.name, stageWidth(stage.name));
    return text + fmt::format("{:>8}{:>9}", "network", "total");
}

std::string stageTimes(const ScalingRow& row)
{
    std::string text;
    for (std::size_t i = 0; i < kFrameStages.size(); ++i)
        text += fmt::format("{:>{}.2f}", row.path.stages[i].computeMs, stageWidth(kFrameStages[i].name));
    return text + fmt::format("{:>8.2f}{:>9.2f}", row.path.networkMs(), row.totalMs);
}

std::string stageLine(const ScalingRow& row)
{
    const std::string wall = row.wallMs ? fmt::format("{:.1f}", *row.wallMs) : "-";
    return fmt::format("{:>5} {:<7}{}{:>8}{:>4.0f}%{:>4.0f}%{:>5.2f}\n", row.ranks, row.ranks == 1 ? "-" : row.balance,
                       stageTimes(row), wall, 100 * row.loadBalance, 100 * worst(row.afterJump), row.work.value_or(1));
}

std::string stagesHeading()
{
    return fmt::format(
        "\nWhere the median frame's time goes, ms: CPU time of each stage's slowest rank, and the network model\n"
        "{:>5} {:<7}{}{:>8}{:>5}{:>5}{:>5}\n",
        "nodes", "", stageNames(), "wall", "load", "jump", "work");
}

std::string wallSpeedups(const ScalingBench& bench)
{
    std::string text;
    for (const ScalingRow& row : bench.rows)
        if (row.wallSpeedup)
            text += fmt::format("{}{} on {}: {:.2f}", text.empty() ? "\nWall time, speedup: " : ", ", row.balance,
                                row.ranks, *row.wallSpeedup);
    return text.empty() ? text : text + "\n";
}

/// How steady the machine was while it drew `nodes`.
std::string steadinessLine(const ScalingBench& bench)
{
    return bench.steadiness ? fmt::format("\nOne rank alone took up to {:.2f} times its least for the same pictures.\n",
                                          *bench.steadiness)
                            : "";
}

std::string megabytes(std::int64_t bytes)
{
    return fmt::format("{:.2f}", double(bytes) * 1e-6);
}

/// Every rank in the median frame of the last row of `nodes` with several.
std::string ranksTable(const ScalingBench& bench)
{
    const ScalingRow* row = nullptr;
    for (const ScalingRow& candidate : bench.rows)
        if (candidate.part == ScalingPart::nodes && candidate.ranks > 1) row = &candidate;
    if (!row) return "";
    std::string text = fmt::format(
        "\nThe ranks of the median frame, {}, {} nodes: CPU time in ms, sent and received in MB\n"
        "{:>4}{:>6}{:>11}{:>9}{:>9}{:>9}{:>9}{:>8}{:>8}{:>9}{:>8}{:>9}{:>8}\n",
        row->balance, row->ranks, "rank", "rows", "guard", "pixels", "balance", "project", "convolve", "shade",
        "gather", "busy", "sent", "messages", "recvd");
    for (const RankStats& rank : row->ofRanks) {
        std::int64_t received = 0;
        for (const FrameStage& stage : kFrameStages) received += (rank.*stage.stats).receivedBytes;
        text += fmt::format("{:>4}{:>6}{:>11}{:>9}{:>9.2f}{:>9.2f}{:>9.2f}{:>8.2f}{:>8.2f}{:>9.2f}{:>8}{:>9}{:>8}\n",
                            rank.rank, rank.rows, fmt::format("{}+{}", rank.guardAbove, rank.guardBelow), rank.pixels,
                            rank.balance.busyMs, rank.project.busyMs, rank.convolve.busyMs, rank.shade.busyMs,
                            rank.gather.busyMs, rank.busyMs, megabytes(rank.sentBytes), rank.sentMessages,
                            megabytes(received));
    }
    return text;
}

std::string paperBricked(const ScalingRow& row, const ScalingBenchPlan& plan)
{
    if (row.part == ScalingPart::mesh) return fmt::format("{:.2f}", paper::kMesh);
    if (!row.bricked) {
        const auto there = paper::table1(row.balance, row.ranks);
        return there ? fmt::format("{:.2f}", *there) : "-";
    }
    const paper::Bricked& there = row.field == plan.largeField ? paper::kLargeField : paper::kSmallField;
    if (row.balance == "hybrid") return "-";
    return fmt::format("{:.2f}", row.balance == "static" ? there.fixed : there.dynamic);
}

std::string simulationTable(const ScalingBenchPlan& plan, const ScalingSimulation& simulation)
{
    if (simulation.points.empty()) return "";
    const double aloneMs = simulation.points.front().frame.totalMs();
    const std::string& shown = plan.balancers.back();
    std::string text =
        fmt::format("\nSimulated: {}x{}, {:.0f} % covered, guard of {} rows {}; speedups, and ms with {}\n{:>5}",
                    simulation.width, simulation.height, 100 * simulation.coveredShare, simulation.guardRows,
                    simulation.guardSource == GuardSource::receive ? "received" : "drawn again", shown, "nodes");
    for (const std::string& balance : plan.balancers) text += fmt::format("{:>9}", balance);
    text += fmt::format("{:>10}{:>9}{:>9}{:>9}{:>9}{:>9}{:>6}\n", "coverage", "project", "convolve", "rest", "network",
                        "total", "load");
    std::string line;
    for (const SimulatedPoint& point : simulation.points) {
        if (line.empty()) line = fmt::format("{:>5}", point.ranks);
        const std::string speedup = fmt::format("{:>9.2f}", aloneMs / point.frame.totalMs());
        for (std::size_t i = 0; i < (point.ranks == 1 ? plan.balancers.size() : 1); ++i) line += speedup;
        if (point.ranks > 1 && point.balance != shown) continue;
        const SimulatedFrame& f = point.frame;
        text += line + fmt::format("{:>10.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>5.0f}%\n", f.coverageMs,
                                   f.projectMs, f.convolveMs, f.shadeMs + f.gatherMs, f.networkMs(), f.totalMs(),
                                   100 * f.balance());
        line.clear();
    }
    return text;
}

}  // namespace

double framesPerSecond(double ms)
{
    return ms > 0 ? 1000 / ms : 0;
}

std::string networkText(const NetworkModel& network)
{
    return fmt::format("{:.4g} Gbit/s and {:.4g} us a message", network.bandwidthBytesPerS * 8e-9, network.latencyUs);
}

std::string ScalingTables::nodesRow(const ScalingRow& row)
{
    std::string text;
    if (lastRanks_ == 0) text = stagesHeading();
    if (lastRanks_ > 1 && row.ranks != lastRanks_) text += "\n";
    lastRanks_ = row.ranks;
    return text + stageLine(row);
}

/// A row of `bricks` or `mesh`.
std::string ScalingTables::otherRow(const ScalingRow& row)
{
    std::string text;
    const std::string setting =
        fmt::format("{} in {}, {}", row.surface, row.field, row.bricked ? "in bricks" : "on every node");
    if (setting != lastSetting_) {
        text += fmt::format("\n{}: frames per second on {} nodes, and the median frame in ms\n", setting, row.ranks);
        text += fmt::format("{:<8}{:>8}{:>6}{}{:>6}{}\n", "balance", "Aeolic", "paper", stageNames(), "load",
                            row.slowdown ? " slower" : "");
        lastSetting_ = setting;
    }
    text += fmt::format("{:<8}{:>8.1f}{:>6}{}{:>5.0f}%", row.balance, framesPerSecond(row.totalMs),
                        paperBricked(row, plan_), stageTimes(row), 100 * row.loadBalance);
    return text + (row.slowdown ? fmt::format("{:>7.2f}\n", *row.slowdown) : "\n");
}

std::string ScalingTables::next(const ScalingBench& soFar)
{
    std::string text;
    if (!std::exchange(begun_, true)) text = heading(plan_, soFar);
    for (; rows_ < soFar.rows.size(); ++rows_) {
        const ScalingRow& row = soFar.rows[rows_];
        text += row.part == ScalingPart::nodes ? nodesRow(row) : otherRow(row);
    }
    if (soFar.costs && !std::exchange(summedUp_, true))
        text += wallSpeedups(soFar) + steadinessLine(soFar) + nodesTable(plan_, soFar) + ranksTable(soFar);
    for (; simulations_ < soFar.simulations.size(); ++simulations_)
        text += simulationTable(plan_, soFar.simulations[simulations_]);
    return text;
}

std::string ScalingTables::notes(const ScalingBench&) const
{
    return fmt::format(
        "\nEach rank is a thread that computes alone; its CPU time is measured. The frame's time is modelled: the\n"
        "slowest rank of every stage, and a network of {} (--network, docs/scaling.md).\n"
        "load: mean busy / max busy of the ranks; jump: the same in the first frame after a turn by 90 degrees, the\n"
        "worst of some; work: CPU time of all ranks by that of one rank alone; wall: all ranks at once, where there\n"
        "are as many cores. Speedups and work: medians over the pictures, each beside one rank that draws the same\n"
        "picture. slower: time by that of the table above, drawn in turn, also a median over the pictures.\n",
        networkText(plan_.network));
}

}  // namespace aeolic
