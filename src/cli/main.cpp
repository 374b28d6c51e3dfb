#include <CLI/CLI.hpp>
#include <cstdio>
#include <new>
#include <string>

#include "aeolic/error.h"
#include "cli/bench_command.h"
#include "cli/info_command.h"
#include "cli/render_command.h"
#include "version.h"

namespace {

constexpr int exitDone = 0, exitFailed = 1, exitWrongInput = 2;

/// One line, whatever a message holds.
int complain(std::string message, int exitCode)
{
    for (char& c : message)
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    std::fprintf(stderr, "aeolic: %s\n", message.c_str());
    return exitCode;
}

/// CLI11's errors in the words of ours.
std::string optionComplaint(const CLI::ParseError& error, const CLI::App& program)
{
    // The innermost command that was typed: "aeolic", "aeolic render", "aeolic bench stages".
    const CLI::App* command = &program;
    std::string typed = "aeolic";
    while (!command->get_subcommands().empty()) {
        command = command->get_subcommands().front();
        typed += " " + command->get_name();
    }
    const std::string help = "'" + typed + " --help'";
    const auto extras = program.remaining(true);
    if (command->get_require_subcommand_min() > 0 && (extras.empty() || !extras.front().starts_with('-')))
        return (extras.empty() ? "no command" : extras.front() + ": unknown command") + "; expected one of those in " +
               help;
    if (!extras.empty())
        return extras.front() +
               (extras.front().starts_with('-') ? ": unknown option; expected one of those in "
                                                : ": one argument too many; expected what is in ") +
               help;
    const std::string message = error.what();
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error))
        return message.substr(0, message.find(": ")) + ": no value; expected what is in " + help;
    if (dynamic_cast<const CLI::RequiredError*>(&error))
        return message.substr(0, message.find(' ')) + ": missing; expected what is in " + help;
    return message;
}

int runProgram(int argc, char** argv)
{
    CLI::App program("Flow drawn on surfaces: line integral convolution, fast and the same everywhere.", "aeolic");
    program.set_version_flag("--version", std::string("aeolic ") + aeolic::versionText, "prints the version");
    program.set_help_flag("-h,--help", "prints this help");
    program.require_subcommand(1);
    program.get_formatter()->column_width(34);
    aeolic::addRenderCommand(program);
    aeolic::addInfoCommand(program);
    aeolic::addBenchCommand(program);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return program.exit(help) == 0 ? exitDone : exitFailed;
    } catch (const CLI::ParseError& error) {
        return complain(optionComplaint(error, program), exitWrongInput);
    }
    return exitDone;
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        return runProgram(argc, argv);
    } catch (const aeolic::InputError& error) {
        return complain(error.what(), exitWrongInput);
    } catch (const std::bad_alloc&) {
        return complain("out of memory", exitFailed);
    } catch (const std::exception& error) {
        return complain(error.what(), exitFailed);
    }
}
