#include "aeolic/error.h"
#include "common/bench_commands.h"
#include "common/options.h"
#include "description/option_help.h"
#include "description/option_table.h"
#include "stages/stages.h"
#include "stages/stages_report.h"

namespace aeolic {
namespace {

StagesBenchPlan::Size parseSize(const std::string& text)
{
    const std::size_t x = text.find('x');
    if (x == std::string::npos || !parseNumber(text.substr(0, x)) || !parseNumber(text.substr(x + 1)))
        throw InputError("--sizes", "found " + inQuotes(text), "WIDTHxHEIGHT in pixels, several separated by commas");
    return {wholeNumber("--sizes width", text.substr(0, x), options::side.lo, options::side.hi),
            wholeNumber("--sizes height", text.substr(x + 1), options::side.lo, options::side.hi)};
}

LicMethod parseMethod(const std::string& text)
{
    const auto method = choiceNamed<LicMethod>(text);
    if (!method || *method == LicMethod::none)
        throw InputError("--methods", "found " + inQuotes(text), "direct, hierarchical or both separated by a comma");
    return *method;
}

struct StagesCommand : BenchOptions {
    explicit StagesCommand(CLI::App& theCommand) : BenchOptions(theCommand)
    {
        // The table takes lists in place of the first three, and shows still pictures.
        remove({"--size", "--lic", "--steps", "--frames", "--orbit", "--time-range"});
        camera = command.get_option("--camera");
        camera->description(
            "as for aeolic render [azimuth=30,elevation=20,roll=0,fov=30 and a zoom that covers most of a picture:\n"
            "1.9 times the root of its sides' ratio]");
        add("--sizes", "WxH,...",
            "pictures in pixels, each " + rangeText(options::side) + " [800x800,1920x1080,3840x2160]", sizes);
        add("--steps", "N,...",
            "integration steps in each direction; " + rangeText(numberRuleOf("--steps")) +
                " [16,32,64,128,256,512,1024]",
            steps);
        add("--methods", "M,...", "direct, hierarchical or both [direct,hierarchical]", methods);
        add("--repeats", "N", "frames of each combination, of which the table shows medians, 1 to 1000 [5]", repeats);
        addJson();
    }

    StagesBenchPlan plan() const;
    void run() const;

    CLI::Option* camera;
    std::string sizes, steps, methods, repeats;
};

StagesBenchPlan StagesCommand::plan() const
{
    StagesBenchPlan plan;
    plan.scene = sceneOptions.scene();
    if (camera->count() == 0 && !hasSceneFile()) {
        plan.scene.camera.zoom = kTeapotZoom;
        plan.fillWide = true;
    }
    const NumberRule range = numberRuleOf("--steps");
    const auto parseSteps = [&](const std::string& text) { return wholeNumber("--steps", text, range.lo, range.hi); };
    if (!sizes.empty()) plan.sizes = parseList(sizes, parseSize);
    if (!steps.empty()) plan.steps = parseList(steps, parseSteps);
    if (!methods.empty()) plan.methods = parseList(methods, parseMethod);
    if (!repeats.empty()) plan.repeats = wholeNumber("--repeats", repeats, 1, 1000);
    return plan;
}

void StagesCommand::run() const
{
    const StagesBenchPlan asked = plan();
    checkJson();
    BenchOptions::run(asked, benchStages, StagesTable(asked), stagesJson);
}

}  // namespace

void addStagesCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks)
{
    addMeasuringCommand<StagesCommand>(
        program, ranks, "stages",
        "Times a frame's stages over picture sizes, LIC methods and steps, in milliseconds, beside how fast this\n"
        "machine fetches scattered words. The whole of the default takes minutes.");
}

}  // namespace aeolic
