#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "cluster/comm/communicator.h"

namespace aeolic {

/// What a program says of itself.
struct ProgramText {
    const char* name;  ///< As it is typed; errors begin with it.
    const char* description;
};

/// The options of the program itself, beside its commands.
void addProgramOptions(CLI::App& program);

/// The commands that people type. Those without a group are not for people.
std::vector<const CLI::App*> commandsOf(const CLI::App& program);
std::vector<std::string> commandNames(const CLI::App& program);

/// Parses the command line and runs the command that it names, which `addCommands(program, ranks)` has added with the
/// others. An error becomes one line on standard error, said by one rank. Returns the exit code: 0 done, 1 failed, 2
/// wrong input.
int runProgram(const ProgramText& text, int argc, char** argv,
               void (*addCommands)(CLI::App& program, const std::shared_ptr<Communicator>& ranks));

}  // namespace aeolic
