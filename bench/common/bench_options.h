#pragma once

#include <fmt/format.h>

#include <initializer_list>
#include <string>

#include "cli/progress_line.h"
#include "cli/scene_options.h"
#include "output/output_check.h"
#include "output/print.h"

namespace aeolic {

/// What all benches share: a scene, options of their own in one group, and numbers as tables or as JSON.
struct BenchOptions {
    explicit BenchOptions(CLI::App& theCommand) : command(theCommand), sceneOptions(theCommand) {}

    void remove(std::initializer_list<const char*> options)
    {
        for (const char* option : options) command.remove_option(command.get_option(option));
    }
    void add(const char* option, const char* value, const std::string& text, std::string& given)
    {
        command.add_option(option, given, text)->type_name(value)->group("Measurement")->take_last();
    }
    /// `instead`: what JSON on standard output takes the place of.
    void addJson(const char* instead)
    {
        add("--json", "FILE",
            fmt::format("writes the numbers as JSON too; - is standard output, instead of the {}", instead), jsonPath);
    }

    bool writesJson() const { return !jsonPath.empty() && jsonPath != "-"; }
    /// Before anything is measured. Throws InputError.
    void checkJson() const
    {
        if (writesJson()) checkWritable(jsonPath);
    }

    /// What `bench(asked, progress)` measures, with its progress on a line that then goes, and its warnings.
    template <class Plan, class Bench>
    static auto measure(const Plan& asked, const Bench& bench)
    {
        ProgressLine progress;
        auto measured = bench(asked, [&](const std::string& what, double fraction) { progress.show(what, fraction); });
        progress.clear();
        for (const std::string& warning : measured.warnings) fmt::print(stderr, "aeolic: warning: {}\n", warning);
        return measured;
    }

    /// Writes and prints what was asked for; each is made only where it is.
    template <class Json, class Tables>
    void show(const Json& json, const Tables& tables) const
    {
        if (writesJson()) writeTextFile(jsonPath, json());
        print(jsonPath == "-" ? json() : tables());
    }

    CLI::App& command;
    SceneOptions sceneOptions;
    std::string jsonPath;
};

}  // namespace aeolic
