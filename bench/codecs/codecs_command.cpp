#include "aeolic/error.h"
#include "codecs/codecs.h"
#include "codecs/codecs_report.h"
#include "common/bench_commands.h"
#include "common/options.h"
#include "description/option_help.h"

namespace aeolic {
namespace {

constexpr int kDefaultViews = 4;  // A quarter turn apart.

int parseBandRows(const std::string& text)
{
    const int rows = wholeNumber("--band-rows", text, 16, stream::kLongestTileSide);
    if (rows % 16) throw InputError("--band-rows", "found " + text, "a multiple of 16");
    return rows;
}

struct CodecsCommand : BenchOptions {
    explicit CodecsCommand(CLI::App& theCommand) : BenchOptions(theCommand)
    {
        // One process draws, and the colour legend is the viewer's.
        remove({"--balance", "--bricks", "--guard", "--guard-rows", "--scalar-bar"});
        frames = command.get_option("--frames");
        frames->description(
            fmt::format("views, spread over the turn; {} [{}]", rangeText(numberRuleOf("--frames")), kDefaultViews));
        command.get_option("--orbit")->description("the turn over all views [360]");
        add("--qualities", "N,...", "of jpeg, 1 to 100 [50,70,80,90,95]", qualities);
        add("--band-rows", "N", "rows of a band, a multiple of 16 up to 32768 [64]", bandRows);
        add("--repeats", "N", "times each view is encoded and decoded, of which the tables show medians, 1 to 1000 [5]",
            repeats);
        addJson();
    }

    CodecsBenchPlan plan() const;
    void run() const;

    CLI::Option* frames;
    std::string qualities, bandRows, repeats;
};

CodecsBenchPlan CodecsCommand::plan() const
{
    CodecsBenchPlan plan;
    plan.scene = sceneOptions.scene();
    if (frames->count() == 0 && !hasSceneFile()) plan.scene.output.frames = kDefaultViews;
    const auto parseQuality = [](const std::string& text) { return wholeNumber("--qualities", text, 1, 100); };
    if (!qualities.empty()) plan.qualities = parseList(qualities, parseQuality);
    if (!bandRows.empty()) plan.bandRows = parseBandRows(bandRows);
    if (!repeats.empty()) plan.repeats = wholeNumber("--repeats", repeats, 1, 1000);
    return plan;
}

void CodecsCommand::run() const
{
    const CodecsBenchPlan asked = plan();
    checkJson();
    BenchOptions::run(asked, benchCodecs, CodecsTables(asked), codecsJson);
}

}  // namespace

void addCodecsCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks)
{
    addMeasuringCommand<CodecsCommand>(
        program, ranks, "codecs",
        "Measures how pictures travel to a viewer: what each codec makes of some views of a scene, how fast it "
        "encodes\n"
        "and decodes them, and how long a view takes over lines of 10 Mbit/s, 100 Mbit/s and 1 Gbit/s.");
}

}  // namespace aeolic
