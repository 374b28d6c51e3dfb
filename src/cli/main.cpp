#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <memory>
#include <new>
#include <string>

#include "aeolic/aeolic.h"
#include "cli/grab_command.h"
#include "cli/info_command.h"
#include "cli/render_command.h"
#include "cli/serve_command.h"
#include "cluster/comm/agreement.h"
#include "common/bench_command.h"
#include "version.h"

namespace {

constexpr int exitDone = 0, exitFailed = 1, exitWrongInput = 2;

/// One line, whatever a message holds.
std::string oneLine(std::string message)
{
    for (char& c : message)
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    return message;
}

int complain(const std::string& message, int exitCode)
{
    std::fprintf(stderr, "aeolic: %s\n", oneLine(message).c_str());
    return exitCode;
}

/// The innermost command that was typed: "aeolic", "aeolic render", "aeolic bench stages".
std::string typedCommand(const CLI::App& program, const CLI::App** innermost = nullptr)
{
    const CLI::App* command = &program;
    std::string typed = "aeolic";
    while (!command->get_subcommands().empty()) {
        command = command->get_subcommands().front();
        typed += " " + command->get_name();
    }
    if (innermost) *innermost = command;
    return typed;
}

/// CLI11's errors in the words of ours.
std::string optionComplaint(const CLI::ParseError& error, const CLI::App& program)
{
    const CLI::App* command = nullptr;
    const std::string help = "'" + typedCommand(program, &command) + " --help'";
    const auto extras = program.remaining(true);
    if (command->get_require_subcommand_min() > 0 && (extras.empty() || !extras.front().starts_with('-')))
        return (extras.empty() ? "no command" : extras.front() + ": unknown command") + "; expected one of those in " +
               help;
    if (!extras.empty())
        return extras.front() +
               (extras.front().starts_with('-') ? ": unknown option; expected one of those in "
                                                : ": one argument too many; expected what is in ") +
               help;
    std::string message = error.what();
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error))
        return message.substr(0, message.find(": ")) + ": no value; expected what is in " + help;
    if (dynamic_cast<const CLI::RequiredError*>(&error))
        return message.substr(0, message.find(' ')) + ": missing; expected what is in " + help;
    return message;
}

/// Collective. Ranks may have been started with different arguments. Throws on all where any has a `complaint` about
/// its own, and where they do different things: one would wait for another forever.
void agreeOnCommand(aeolic::Communicator& ranks, const std::string& complaint, const std::string& command)
{
    aeolic::runTogether(ranks, [&] {
        if (!complaint.empty()) throw aeolic::InputError(complaint);
    });
    aeolic::requireSame(ranks, "the command", command);
}

/// What `--version` prints.
std::string versionAndLicence()
{
    std::string text = std::string("aeolic ") + aeolic::versionText;
    if (aeolic::builtWithLzo)
        text += "\nbuilt with LZO: this program is under the GNU General Public License, version 3 or later";
    return text;
}

int runProgram(int argc, char** argv, const std::shared_ptr<aeolic::Communicator>& ranks)
{
    CLI::App program("Flow drawn on surfaces: line integral convolution, fast and the same everywhere.", "aeolic");
    program.set_version_flag("--version", versionAndLicence(), "prints the version");
    program.set_help_flag("-h,--help", "prints this help");
    program.require_subcommand(1);
    program.get_formatter()->column_width(34);
    aeolic::addRenderCommand(program, ranks);
    aeolic::addInfoCommand(program, ranks);
    aeolic::addBenchCommand(program, ranks);
    aeolic::addServeCommand(program, ranks);
    aeolic::addGrabCommand(program, ranks);
    program.parse_complete_callback([&] { agreeOnCommand(*ranks, "", typedCommand(program)); });  // Before its own.
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& help) {
        agreeOnCommand(*ranks, "", "help");
        return !ranks->isRoot() || program.exit(help) == 0 ? exitDone : exitFailed;
    } catch (const CLI::ParseError& error) {
        agreeOnCommand(*ranks, optionComplaint(error, program), "");
    }
    return exitDone;
}

/// What a rank does about an error: where all ranks have it, rank 0 says so and everyone leaves; else the job is ended.
int fail(const std::exception& error, const std::string& message, int exitCode, aeolic::Communicator* ranks)
{
    if (!ranks || ranks->size() == 1) return complain(message, exitCode);
    if (!dynamic_cast<const aeolic::Agreed*>(&error)) ranks->abortJob(oneLine(message), exitCode);
    if (ranks->isRoot()) complain(message, exitCode);
    ranks->barrier();  // The first to leave with an error makes the launcher end the others: not before it is said.
    return exitCode;
}

}  // namespace

int main(int argc, char** argv)
{
    std::signal(SIGXFSZ, SIG_IGN);  // A file larger than `ulimit -f` is an error to report, not a sudden end.
    std::shared_ptr<aeolic::Communicator> ranks;  // Outlives what is thrown: an error has to reach the other ranks.
    try {
        ranks = aeolic::joinRanks();
        return runProgram(argc, argv, ranks);
    } catch (const aeolic::InputError& error) {
        return fail(error, error.what(), exitWrongInput, ranks.get());
    } catch (const std::bad_alloc& error) {
        return fail(error, "out of memory", exitFailed, ranks.get());
    } catch (const std::exception& error) {
        return fail(error, error.what(), exitFailed, ranks.get());
    }
}
