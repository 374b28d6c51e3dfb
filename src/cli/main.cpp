#include "aeolic/error.h"
#include "cli/commands.h"
#include "cli/program.h"
#include "cluster/comm/agreement.h"

namespace {

using aeolic::Communicator;

/// `bench`, whatever follows it, says in one line where it went. No help shows it.
void addFormerBenchCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks)
{
    CLI::App* bench = program.add_subcommand("bench")->group("")->prefix_command();
    bench->set_help_flag();
    bench->callback([ranks] {
        aeolic::runTogether(*ranks, [] {
            throw aeolic::InputError("bench is a program of its own now: aeolic-bench scaling | stages | codecs");
        });
    });
}

void addCommands(CLI::App& program, const std::shared_ptr<Communicator>& ranks)
{
    aeolic::addRenderCommand(program, ranks);
    aeolic::addInfoCommand(program, ranks);
    aeolic::addServeCommand(program, ranks);
    aeolic::addGrabCommand(program, ranks);
    addFormerBenchCommand(program, ranks);
}

}  // namespace

int main(int argc, char** argv)
{
    return aeolic::runProgram(
        {"aeolic", "Flow drawn on surfaces: line integral convolution, fast and the same everywhere."}, argc, argv,
        addCommands);
}
