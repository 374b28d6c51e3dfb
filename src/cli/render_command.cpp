#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "aeolic/aeolic.h"
#include "cli/commands.h"
#include "cli/progress_line.h"
#include "cli/scene_options.h"
#include "cluster/comm/together.h"
#include "description/colormap.h"
#include "description/idle_options.h"
#include "output/nothing_shown.h"
#include "output/output_check.h"
#include "output/picture_files.h"
#include "output/print.h"
#include "output/stats_json.h"

namespace aeolic {

namespace {

struct RenderCommand {
    RenderCommand(CLI::App& command, std::shared_ptr<Communicator> theRanks)
        : sceneOptions(command), ranks(std::move(theRanks))
    {
        command
            .add_option(
                "-o,--output", outputPath,
                wrapped("the file to write: .png, .jpg or .webp; with --frames numbered .png or .jpg, or one .webp, "
                        ".apng or .mp4 (through an ffmpeg that is installed); with --flow loop also .html, a page that "
                        "plays in any browser"))
            ->type_name("OUT.png")
            ->take_last();
        command.add_option("--stats", statsPath, "writes times and memory as JSON; - is standard output")
            ->type_name("FILE")
            ->take_last();
        command.add_flag("--verbose", verbose,
                         "a summary on standard error even where that is not a terminal, and why no GPU draws");
        command.add_flag("--list-colormaps", listColorMaps, "prints the names --colormap takes");
    }

    void run();
    void openFiles(const SceneDescription& scene);

    SceneOptions sceneOptions;
    std::shared_ptr<Communicator> ranks;
    std::string outputPath, statsPath;
    std::optional<PictureFiles> files;  // Of the root alone.
    bool verbose = false, listColorMaps = false;
};

void writeStats(const RunStats& stats, const std::string& path)
{
    const std::string text = statsToJson(stats);
    if (path == "-")
        print(text);
    else
        writeTextFile(path, text);
}

/// Such as `3 ranks x 1 to 4 threads`.
std::string threadsText(const SceneInfo& info)
{
    if (info.ranks == 1) return fmt::format("{} threads", info.threads);
    const auto [least, most] = std::minmax_element(info.threadsOfRank.begin(), info.threadsOfRank.end());
    const std::string range = *least == *most ? std::to_string(*most) : fmt::format("{} to {}", *least, *most);
    return fmt::format("{} ranks x {} threads", info.ranks, range);
}

void printSummary(const RunStats& stats, const std::string& names)
{
    double totalMs = 0;
    for (const FrameStats& frame : stats.frames) totalMs += frame.totalMs;
    const std::size_t frames = stats.frames.size();
    const SceneInfo& info = stats.info;
    fmt::print(stderr, "{}: {}x{}, {}{:.1f} ms a frame on {} ({}, {}), loaded in {:.0f} ms\n", names,
               stats.scene.output.width, stats.scene.output.height,
               frames > 1 ? fmt::format("{} frames, ", frames) : "", totalMs / double(frames), info.backend,
               threadsText(info), info.backend == "gl" ? info.device : info.simd, info.loadMs);
}

void warn(const std::string& warning)
{
    fmt::print(stderr, "aeolic: warning: {}\n", warning);
}

void RenderCommand::openFiles(const SceneDescription& scene)
{
    files.emplace(outputPath, scene);
    if (!statsPath.empty() && statsPath != "-") checkWritable(statsPath);
    if (statsPath == outputPath) throw InputError("--stats", "found the picture's own name", "another file");
}

void RenderCommand::run()
{
    const bool root = ranks->isRoot();  // The root loads as the others do, and is the only rank that writes.
    if (listColorMaps) {
        if (root) print(fmt::format("{}\n", fmt::join(colorMapNames(), "\n")));
        return;
    }
    RunStats stats;
    runTogether(*ranks, [&] {
        const SceneDescription asked = sceneOptions.scene();
        if (root) openFiles(asked);
        stats.scene = drawnFor(outputPath, asked);
    });
    const int frames = stats.scene.output.frames;

    ProgressLine progress;
    const auto show = [&](const std::string& what, double fraction) {
        if (root) progress.show(what, fraction);
    };
    Renderer renderer(stats.scene, ranks, show);
    progress.clear();
    std::set<std::string> told;
    const auto warnOfMore = [&] {  // Other moments may bring other warnings.
        for (const std::string& warning : renderer.info().warnings) {
            if (!root || !told.insert(warning).second) continue;
            progress.clear();
            warn(warning);
        }
    };
    warnOfMore();
    const std::vector<std::string> idle =
        idleOptions(stats.scene, sceneOptions.given(), !renderer.info().times.empty());
    if (root) std::for_each(idle.begin(), idle.end(), warn);

    Picture picture;
    int blank = 0;
    for (int frame = 0, started = 0; frame < frames; ++frame) {
        show(fmt::format("frame {} of {}", frame + 1, frames), double(frame) / frames);
        // A GPU draws the next frames while this one is written.
        while (started < std::min(frame + renderer.framesInFlight(), frames))
            renderer.start({AnimationFrame{started++}});
        picture = renderer.finish(std::move(picture));
        stats.frames.push_back(renderer.lastFrame());
        blank += stats.frames.back().coveredPixels == 0 ? 1 : 0;
        warnOfMore();
        if (root) files->write(picture);
    }
    if (root) files->complete();
    progress.clear();
    if (root && blank > 0) warn(nothingShown(blank, frames));

    stats.info = renderer.info();  // Asked at the end, because another moment may have been too large for the GPU.
    stats.info.warnings.insert(stats.info.warnings.end(), idle.begin(), idle.end());
    stats.peakRssBytesOfRank = ranks->allGatherValue(std::int64_t(peakRssBytes()));
    if (!root) return;
    if (!statsPath.empty()) writeStats(stats, statsPath);
    if (verbose || isatty(STDERR_FILENO)) printSummary(stats, files->names());
    // Why `auto` took the processor is told only to those who ask: most machines have no GPU.
    if (verbose && !stats.info.unusedGpu.empty()) fmt::print(stderr, "no GPU is used: {}\n", stats.info.unusedGpu);
}

}  // namespace

void addRenderCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks)
{
    CLI::App* command =
        program.add_subcommand("render", "Draws a scene into a picture, or into several as an animation.");
    const auto state = std::make_shared<RenderCommand>(*command, ranks);
    command->callback([state] { state->run(); });
}

}  // namespace aeolic
