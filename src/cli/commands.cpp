#include "cli/commands.h"

#include "aeolic/error.h"
#include "cluster/comm/together.h"

namespace aeolic {
namespace {

/// `bench`, whatever follows it, says in one line where it went. No help shows it.
void addFormerBenchCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks)
{
    CLI::App* bench = program.add_subcommand("bench")->group("")->prefix_command();
    bench->set_help_flag();
    bench->callback([ranks] {
        runTogether(*ranks, [] {
            throw InputError("bench is a program of its own now: aeolic-bench scaling | stages | codecs");
        });
    });
}

}  // namespace

void addCommands(CLI::App& program, const std::shared_ptr<Communicator>& ranks)
{
    addRenderCommand(program, ranks);
    addExtractCommand(program, ranks);
    addProbeCommand(program, ranks);
    addInfoCommand(program, ranks);
    addServeCommand(program, ranks);
    addGrabCommand(program, ranks);
    addFormerBenchCommand(program, ranks);
}

}  // namespace aeolic
