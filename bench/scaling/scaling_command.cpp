#include <algorithm>

#include "aeolic/error.h"
#include "common/bench_commands.h"
#include "common/options.h"
#include "description/choices.h"
#include "description/option_help.h"
#include "scaling/scaling.h"
#include "scaling/scaling_report.h"

namespace aeolic {
namespace {

constexpr int kDefaultFrames = 18;                                          // Twenty degrees apart.
constexpr double kLeastGbit = 1e-3, kMostGbit = 1e5, kMostMessageUs = 1e5;  // From a modem to what nobody has yet.
constexpr int kMostRanks = 256;  // Threads of one process, each with a backend of its own.

std::vector<int> parseRanks(const std::string& text)
{
    const std::vector<int> given =
        parseList(text, [](const std::string& item) { return wholeNumber("--ranks", item, 1, kMostRanks); });
    std::vector<int> ranks = given;
    if (given.size() == 1)
        for (int n = 1; n < given[0]; ++n) ranks.push_back(n);
    std::sort(ranks.begin(), ranks.end());
    ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
    return ranks;
}

std::string parseBalancer(const std::string& text)
{
    if (!choiceNamed<Balance>(text))
        throw InputError("--balance", "found " + inQuotes(text),
                         "static, timing, pixels or hybrid, several separated by commas");
    return text;
}

ScalingPart parsePart(const std::string& text)
{
    if (text == "nodes") return ScalingPart::nodes;
    if (text == "bricks") return ScalingPart::bricks;
    if (text == "mesh") return ScalingPart::mesh;
    throw InputError("--parts", "found " + inQuotes(text), "nodes, bricks or mesh, several separated by commas");
}

NetworkModel parseNetwork(const std::string& text)
{
    const std::vector<std::string> items = listItems(text);
    const auto number = [&](std::size_t i) { return i < items.size() ? parseNumber(items[i]) : std::nullopt; };
    const auto gbit = number(0), us = number(1);
    const bool inRange = gbit && us && *gbit >= kLeastGbit && *gbit <= kMostGbit && *us >= 0 && *us <= kMostMessageUs;
    if (items.size() != 2 || !inRange)
        throw InputError("--network", "found " + inQuotes(text),
                         fmt::format("gigabits a second from {:g} to {:g} and microseconds a message from 0 to {:g}, "
                                     "as in 100,2",
                                     kLeastGbit, kMostGbit, kMostMessageUs));
    return {*gbit * 1e9 / 8, *us};
}

struct ScalingCommand : BenchOptions {
    explicit ScalingCommand(CLI::App& theCommand) : BenchOptions(theCommand)
    {
        // Every rank is measured on one core of the processor, and under several balancers.
        remove({"--backend", "--threads", "--device", "--balance", "--bricks", "--time-range"});
        lic = command.get_option("--lic");
        lic->description("method [direct, as in the paper]");
        frames = command.get_option("--frames");
        frames->description(fmt::format("pictures of the rotation, of which tables show medians; {} [{}]",
                                        rangeText(numberRuleOf("--frames")), kDefaultFrames));
        command.get_option("--orbit")->description("the turn over the whole rotation [360]");
        camera = command.get_option("--camera");
        camera->description(
            "as for aeolic render [azimuth=30,elevation=20,roll=0,fov=30 and the whole surface in view; in wide "
            "pictures\n"
            "zoomed by the root of their sides' ratio]");
        add("--ranks", "N|N,...", "1 to the number given, or a list, each up to 256 [8]", ranks);
        add("--balance", "B,...", "balancers [static,timing,pixels,hybrid]", balance);
        add("--parts", "P,...",
            "nodes: Table 1; bricks: the field on every node, in bricks, and a large one in bricks; mesh: a finer\n"
            "surface in the large one [nodes,bricks,mesh]",
            parts);
        add("--large-field", "FIELD", "of bricks and mesh, as for --field [the built-in flow, on 512,512,512 samples]",
            largeField);
        add("--mesh", "SURFACE", "of mesh, as for --surface [torus:25000]", mesh);
        add("--repeats", "N",
            "times each picture is measured, of which the least time of each rank and stage counts, 1 to 100 [3]",
            repeats);
        add("--network", "GBIT,US",
            "the network modelled: gigabits a second, microseconds a message [100,2]; the paper's,\n6.4,5, comes with "
            "it",
            network);
        command.add_flag("--simulate", simulate, "also up to 1024 ranks, and 16384x16384, from the costs measured")
            ->group("Measurement");
        addJson();
        add("--svg", "FILE", "writes a plot: speedup against ranks, beside the paper's", svgPath);
    }

    ScalingBenchPlan plan() const;
    void run() const;

    CLI::Option *lic, *frames, *camera;
    std::string ranks, balance, parts, largeField, mesh, repeats, network, svgPath;
    bool simulate = false;
};

ScalingBenchPlan ScalingCommand::plan() const
{
    ScalingBenchPlan plan;
    plan.scene = sceneOptions.scene();
    const bool fromFile = hasSceneFile();
    if (lic->count() == 0 && !fromFile) plan.scene.lic.method = LicMethod::direct;
    if (frames->count() == 0) plan.scene.output.frames = kDefaultFrames;
    plan.fillWide = camera->count() == 0 && !fromFile;
    plan.simulate = simulate;
    if (!repeats.empty()) plan.repeats = wholeNumber("--repeats", repeats, 1, 100);
    if (!ranks.empty()) plan.ranks = parseRanks(ranks);
    if (!balance.empty()) plan.balancers = parseList(balance, parseBalancer);
    if (!parts.empty()) plan.parts = parseList(parts, parsePart);
    if (!network.empty()) plan.network = parseNetwork(network);
    if (!mesh.empty()) plan.mesh = mesh;
    plan.largeField = largeField.empty() ? defaultLargeField(plan.scene.field.spec) : largeField;
    return plan;
}

void ScalingCommand::run() const
{
    const ScalingBenchPlan asked = plan();
    checkJson();
    if (!svgPath.empty()) {
        if (std::find(asked.parts.begin(), asked.parts.end(), ScalingPart::nodes) == asked.parts.end())
            throw InputError("--svg", "a plot without --parts nodes", "that part, which is what it shows");
        checkWritable(svgPath);
    }
    const ScalingBench bench = BenchOptions::run(asked, benchScaling, ScalingTables(asked), scalingJson);
    if (!svgPath.empty()) writeTextFile(svgPath, scalingPlot(asked, bench));
}

}  // namespace

void addScalingCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks)
{
    addMeasuringCommand<ScalingCommand>(
        program, ranks, "scaling",
        "Repeats the measurements of Bachthaler et al. 2006 on any machine: every rank's CPU time in every stage, "
        "what\n"
        "it sends, and from them the frame rate on as many nodes, modelled. The whole of the default takes minutes.");
}

}  // namespace aeolic
