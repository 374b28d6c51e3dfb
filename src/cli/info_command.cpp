#include <memory>
#include <string>

#include "aeolic/error.h"
#include "cli/commands.h"
#include "data/load/file_info.h"
#include "output/print.h"

namespace aeolic {

void addInfoCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks)
{
    CLI::App* command = program.add_subcommand(
        "info",
        "Says what a data file holds: kind, size, parts, bounds, time steps, arrays, and the render command to try "
        "first.");
    const auto path = std::make_shared<std::string>();
    command->add_option("FILE", *path, "a surface or a field that render can read; of an OpenFOAM case its folder")
        ->required()
        ->type_name("");
    command->callback([path, ranks] {
        if (!ranks->isRoot()) return;
        if (path->empty()) throw InputError("FILE", "found ''", "a surface or a field");
        std::string text = describeFile(*path);
        if (!text.ends_with('\n')) text += '\n';
        print(text);
    });
}

}  // namespace aeolic
