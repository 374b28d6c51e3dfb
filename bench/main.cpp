#include "cli/program.h"
#include "common/bench_commands.h"

namespace {

void addCommands(CLI::App& program, const std::shared_ptr<aeolic::Communicator>& ranks)
{
    aeolic::addScalingCommand(program, ranks);
    aeolic::addStagesCommand(program, ranks);
    aeolic::addCodecsCommand(program, ranks);
}

}  // namespace

int main(int argc, char** argv)
{
    return aeolic::runProgram({"aeolic-bench", "Measures how fast this machine draws, and how its pictures travel."},
                              argc, argv, addCommands);
}
