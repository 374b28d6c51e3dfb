#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>

#include "cli/commands.h"
#include "cli/manual/manual.h"
#include "version.h"

/// Writes the manual pages and the completions of `aeolic` into a folder: the build runs it, and nobody else.
namespace {

void write(const std::string& path, const std::string& text)
{
    std::ofstream file(path, std::ios::binary);
    file << text;
    if (!file.flush()) throw std::runtime_error(path + ": it cannot be written");
}

}  // namespace

int main(int argc, char** argv)
{
    using namespace aeolic;
    if (argc != 2) return std::fprintf(stderr, "usage: aeolic_manual FOLDER\n"), 2;
    try {
        const std::string folder = argv[1];
        CLI::App program(programText.description, programText.name);
        addProgramOptions(program);
        addCommands(program, nullptr);
        write(folder + "/" + manual::pageName(program) + ".1", manual::page(program, versionText));
        for (const CLI::App* command : commandsOf(program))
            write(folder + "/" + manual::pageName(*command) + ".1", manual::page(*command, versionText));
        write(folder + "/aeolic.bash", manual::bashCompletion(program));
        write(folder + "/_aeolic", manual::zshCompletion(program));
    } catch (const std::exception& error) {
        return std::fprintf(stderr, "aeolic_manual: %s\n", error.what()), 1;
    }
    return 0;
}
