#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <sstream>
#include <string>

#include "aeolic/error.h"
#include "base/text.h"
#include "cli/commands.h"
#include "data/load/file_info.h"
#include "data/reading/reader_words.h"
#include "output/print.h"

namespace aeolic {
namespace {

/// A line each, without the control characters that names in files may hold.
void printWords(const std::string& path, const std::string& words)
{
    std::istringstream lines(words);
    for (std::string line; std::getline(lines, line);)
        fmt::print(stderr, "aeolic-reader: {}: {}\n", withoutControls(path), withoutControls(line));
}

}  // namespace

void addInfoCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks)
{
    CLI::App* command = program.add_subcommand(
        "info",
        "Says what a data file holds: kind, size, parts, bounds, time steps, arrays, and the render command to try "
        "first.");
    const auto path = std::make_shared<std::string>();
    const auto verbose = std::make_shared<bool>(false);
    command->add_option("FILE", *path, "a surface or a field that render can read; of an OpenFOAM case its folder")
        ->required()
        ->type_name("");
    command->add_flag("--verbose", *verbose, "also what the library that reads the file says of it, on standard error");
    command->callback([path, verbose, ranks] {
        if (!ranks->isRoot()) return;
        if (path->empty()) throw InputError("FILE", "found ''", "a surface or a field");
        if (*verbose) hearReaderWords(printWords);
        std::string text = describeFile(*path);
        if (!text.ends_with('\n')) text += '\n';
        print(text);
    });
}

}  // namespace aeolic
