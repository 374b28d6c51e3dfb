#include <fmt/format.h>

#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "aeolic/aeolic.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/progress_line.h"
#include "cli/scene_options.h"
#include "cluster/comm/together.h"
#include "engine/picture_warnings.h"
#include "engine/renderer_internals.h"
#include "output/flow_files.h"
#include "output/output_check.h"

namespace aeolic {
namespace {

struct ExtractCommand {
    ExtractCommand(CLI::App& command, std::shared_ptr<Communicator> theRanks)
        : what(addFirstWord(
              command, "WHAT",
              "topology: critical points, and the lines of separation and attachment that begin at saddles; "
              "separation: such lines that begin at none; streamlines: evenly spaced ones, as --overlay "
              "streamlines:PX says")),
          sceneOptions(command),
          ranks(std::move(theRanks))
    {
        command
            .add_option("-o,--output", outputPath,
                        wrapped("the file to write: .vtp (VTK polydata of vertices and lines), or .csv (a row for each "
                                "point, and for each place of a line)"))
            ->type_name("OUT.vtp")
            ->take_last();
    }

    void run() const;

    std::shared_ptr<std::string> what;
    SceneOptions sceneOptions;
    std::shared_ptr<Communicator> ranks;
    std::string outputPath;
};

struct Extracted {
    std::string text, warning;
};

Extracted topologyText(Renderer& renderer, bool asVtp)
{
    const FlowTopology topology = renderer.topology();
    return {asVtp ? topologyVtp(topology) : topologyCsv(topology),
            topology.points.empty() ? "the flow has no critical point on this surface" : ""};
}

Extracted separationText(Renderer& renderer, bool asVtp)
{
    const FlowTopology lines = renderer.separation();
    return {asVtp ? topologyVtp(lines) : topologyCsv(lines),
            lines.lines.empty() ? "streamlines gather at no line on this surface" : ""};
}

Extracted streamlinesText(Renderer& renderer, bool asVtp)
{
    const EvenSurfaceLines lines = renderer.streamlines();
    return {asVtp ? streamlinesVtp(lines) : streamlinesCsv(lines),
            lines.lines.empty() ? "the flow has no streamline on this surface that is long enough" : ""};
}

void ExtractCommand::run() const
{
    static const std::map<std::string, Extracted (*)(Renderer&, bool)> kinds = {
        {"topology", topologyText}, {"separation", separationText}, {"streamlines", streamlinesText}};
    const bool root = ranks->isRoot();
    SceneDescription scene;
    const std::string ending = lowerExtension(outputPath);
    runTogether(*ranks, [&] {
        if (!kinds.contains(*what)) {
            std::vector<std::string> names;
            for (const auto& [name, _] : kinds) names.push_back(name);
            throw InputError("WHAT", "found '" + *what + "'",
                             "topology, separation or streamlines" + didYouMean(*what, names));
        }
        scene = sceneOptions.scene();
        if (ending != ".vtp" && ending != ".csv")
            throw InputError("-o", "found '" + outputPath + "'", "a name ending in .vtp or .csv");
        if (root) checkWritable(outputPath);
    });
    ProgressLine progress;
    Renderer renderer(scene, ranks, [&](const std::string& work, double fraction) {
        if (root) progress.show(work, fraction);
    });
    progress.clear();
    const bool asVtp = ending == ".vtp";
    const Extracted found = kinds.at(*what)(renderer, asVtp);
    if (!root) return;
    for (std::size_t i = 0; i < renderer.info().dataWarnings; ++i)
        fmt::print(stderr, "aeolic: warning: {}\n", renderer.info().warnings[i]);
    if (const std::string against = againstFlowWarning(RendererInternals::scene(renderer)); !against.empty())
        fmt::print(stderr, "aeolic: warning: {}\n", against);
    if (!found.warning.empty()) fmt::print(stderr, "aeolic: warning: {}\n", found.warning);
    writeTextFile(outputPath, found.text);
}

}  // namespace

void addExtractCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks)
{
    CLI::App* command = program.add_subcommand("extract",
                                               "Writes what the flow on a surface has, as points and lines: its "
                                               "topology, open lines of separation, streamlines.");
    const auto state = std::make_shared<ExtractCommand>(*command, ranks);
    command->callback([state] { state->run(); });
}

}  // namespace aeolic
