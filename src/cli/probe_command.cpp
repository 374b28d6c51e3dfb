#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "aeolic/aeolic.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/progress_line.h"
#include "cli/scene_options.h"
#include "cluster/comm/together.h"

namespace aeolic {
namespace {

struct Pixel {
    int x = 0, y = 0;
};

/// "400,300". Throws InputError.
Pixel pixelOf(const std::string& text)
{
    const auto parts = splitText(text, ',');
    const auto x = wholeTextAs<int>(parts.front()), y = wholeTextAs<int>(parts.back());
    if (parts.size() != 2 || !x || !y)
        throw InputError("PIXEL", "found '" + text + "'", "X,Y, counted from the upper left: 400,300");
    return {*x, *y};
}

std::string numbers(const Vec3& v)
{
    return fmt::format("{:.9g} {:.9g} {:.9g}", v[0], v[1], v[2]);
}

struct ProbeCommand {
    ProbeCommand(CLI::App& command, std::shared_ptr<Communicator> theRanks)
        : pixel(addFirstWord(command, "PIXEL", "X,Y, counted from the upper left of the picture: 400,300")),
          sceneOptions(command),
          ranks(std::move(theRanks))
    {
    }

    void run() const;

    std::shared_ptr<std::string> pixel;
    SceneOptions sceneOptions;
    std::shared_ptr<Communicator> ranks;
};

void tell(const PickedPlace& place, const SceneInfo& info)
{
    const auto line = [](const std::string& name, const std::string& value) { fmt::print("{:<18}{}\n", name, value); };
    line("position", numbers(place.position));
    line("depth", fmt::format("{:.9g}", place.depth));
    line("surface", place.surface);
    line("triangle", fmt::format("{}", place.triangle));
    line("normal", numbers(place.normal));
    if (!info.times.empty()) line("time", fmt::format("{:.9g}", info.time));
    line("vector", place.vector ? numbers(*place.vector) : "none");
    if (place.vector) {
        const auto& [x, y, z] = *place.vector;
        line("its length", fmt::format("{:.9g}", std::hypot(x, y, z)));
        line("along the surface", numbers(*place.tangential));
    }
    if (!place.scalarName.empty()) line(place.scalarName, place.scalar ? fmt::format("{:.9g}", *place.scalar) : "none");
}

void ProbeCommand::run() const
{
    const bool root = ranks->isRoot();
    SceneDescription scene;
    Pixel at;
    runTogether(*ranks, [&] {
        at = pixelOf(*pixel);
        scene = sceneOptions.scene();
    });
    ProgressLine progress;
    Renderer renderer(scene, ranks, [&](const std::string& work, double fraction) {
        if (root) progress.show(work, fraction);
    });
    progress.clear();
    const auto place = renderer.pick(at.x, at.y);
    if (!root) return;
    for (std::size_t i = 0; i < renderer.info().dataWarnings; ++i)
        fmt::print(stderr, "aeolic: warning: {}\n", renderer.info().warnings[i]);
    if (place)
        tell(*place, renderer.info());
    else
        fmt::print("background\n");
}

}  // namespace

void addProbeCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks)
{
    CLI::App* command = program.add_subcommand("probe", "Tells what a picture shows at a pixel, in the data's units.");
    const auto state = std::make_shared<ProbeCommand>(*command, ranks);
    command->callback([state] { state->run(); });
}

}  // namespace aeolic
