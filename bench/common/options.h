#pragma once

#include <fmt/format.h>

#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/progress_line.h"
#include "cli/scene_options.h"
#include "cluster/comm/communicator.h"
#include "common/measuring.h"
#include "output/output_check.h"
#include "output/print.h"

namespace aeolic {

/// "a,b,c" to its items; an empty text is one empty item.
std::vector<std::string> listItems(const std::string& text);

/// The whole of `text` as a whole number. Throws InputError naming `option` where it is not from `least` to `most`.
int wholeNumber(const std::string& option, std::string_view text, double least, double most);

/// Every item of a list as `parse` reads it.
template <class Parse>
auto parseList(const std::string& text, const Parse& parse)
{
    std::vector<decltype(parse(text))> values;
    for (const std::string& item : listItems(text)) values.push_back(parse(item));
    return values;
}

/// What all measuring commands share: a scene, options of their own in one group, and numbers as tables or as JSON.
struct BenchOptions {
    explicit BenchOptions(CLI::App& theCommand) : command(theCommand), sceneOptions(theCommand) {}

    void remove(std::initializer_list<const char*> options);
    void add(const char* option, const char* value, const std::string& text, std::string& given);
    void addJson();

    bool hasSceneFile() const { return command.get_option("SCENE.json")->count() > 0; }

    /// To be called before anything is measured. Throws InputError.
    void checkJson() const
    {
        if (writesJson()) checkWritable(jsonPath);
    }

    /// Runs `measure(asked, watch)`. Prints what `tables` makes of it as soon as it is known, or where --json says so
    /// `json(asked, measured)` alone, at the end. Progress is shown on a terminal.
    template <class Measured, class Plan, class Tables>
    Measured run(const Plan& asked, Measured (*measure)(const Plan&, const Watch<Measured>&), Tables tables,
                 std::string (*json)(const Plan&, const Measured&)) const
    {
        const bool printsTables = jsonPath != "-";
        ProgressLine line;
        std::size_t warned = 0;
        const auto more = [&](const Measured& soFar) {
            line.clear();
            for (; warned < soFar.warnings.size(); ++warned) warn(soFar.warnings[warned]);
            if (printsTables) print(tables.next(soFar));
        };
        const auto progress = [&](const std::string& what, double fraction) { line.show(what, fraction); };
        const Measured measured = measure(asked, {progress, more});
        line.clear();
        if (writesJson()) writeTextFile(jsonPath, json(asked, measured));
        print(printsTables ? tables.notes(measured) : json(asked, measured));
        return measured;
    }

    CLI::App& command;
    SceneOptions sceneOptions;

private:
    static void warn(const std::string& warning);
    bool writesJson() const { return !jsonPath.empty() && jsonPath != "-"; }

    std::string jsonPath;
};

/// Adds `aeolic-bench NAME`, which Options, a kind of BenchOptions, describes and measures.
template <class Options>
void addMeasuringCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks, const char* name,
                         const char* description)
{
    CLI::App* command = program.add_subcommand(name, description);
    const auto options = std::make_shared<Options>(*command);
    command->callback([options, ranks] {
        if (ranks->isRoot()) options->run();
    });
}

}  // namespace aeolic
