#include "cli/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include "aeolic/aeolic.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "cluster/comm/together.h"
#include "data/named_file.h"
#include "data/reading/reader_pool.h"
#include "output/print.h"
#include "version.h"

namespace aeolic {
namespace {

constexpr int exitDone = 0, exitFailed = 1, exitWrongInput = 2;

int complain(const char* program, const std::string& message, int exitCode)
{
    std::fprintf(stderr, "%s: %s\n", program, withoutControls(message).c_str());
    return exitCode;
}

/// The program and the innermost command that was typed: "aeolic", "aeolic render".
std::string typedCommand(const CLI::App& program, const CLI::App** innermost = nullptr)
{
    const CLI::App* command = &program;
    std::string typed = program.get_name();
    while (!command->get_subcommands().empty()) {
        command = command->get_subcommands().front();
        typed += " " + command->get_name();
    }
    if (innermost) *innermost = command;
    return typed;
}

std::vector<std::string> optionNames(const CLI::App& command)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

/// What to type for a file in the place of a command; empty where it is none, or nothing reads it.
std::string hintOnFile(const std::string& typed, const CLI::App& program)
{
    const FileKind* kind = typed.empty() ? nullptr : namedKind(typed);
    const std::vector<std::string> known = commandNames(program);
    if (!kind || std::find(known.begin(), known.end(), "info") == known.end()) return "";
    const std::string& name = program.get_name();
    if (kind->holdsData() || kind->use == FileUse::list)
        return fmt::format("'{0} info {1}', which tells what it holds and how '{0} render' draws it", name, typed);
    return lowerExtension(typed) == ".json" ? fmt::format("'{} render {} -o OUT.png' for a scene file", name, typed)
                                            : "";
}

/// What to say about an error that CLI11 found, in this program's words.
std::string optionComplaint(const CLI::ParseError& error, const CLI::App& program)
{
    const CLI::App* command = nullptr;
    const std::string help = "'" + typedCommand(program, &command) + " --help'";
    const auto extras = program.remaining(true);
    const std::string extra = extras.empty() ? "" : extras.front();
    const auto unknown = [&](const char* what, const std::string& nearest) {
        return extra + what + (nearest.empty() ? "; expected one of those in " + help : nearest);
    };
    if (extra.starts_with('-'))
        return unknown(": unknown option", didYouMean(extra.substr(0, extra.find('=')), optionNames(*command)));
    if (const std::string hint = hintOnFile(extra, program); command->get_require_subcommand_min() > 0 && !hint.empty())
        return extra + ": a file, not a command; expected " + hint;
    if (command->get_require_subcommand_min() > 0)
        return extra.empty() ? "no command; expected one of those in " + help
                             : unknown(": unknown command", didYouMean(extra, commandNames(*command)));
    if (!extra.empty()) return extra + ": one argument too many; expected the arguments in " + help;
    std::string message = error.what();
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error))
        return message.substr(0, message.find(": ")) + ": no value; expected the arguments in " + help;
    if (dynamic_cast<const CLI::RequiredError*>(&error))
        return message.substr(0, message.find(' ')) + ": missing; expected the arguments in " + help;
    // "Could not convert: --port = x"
    const std::string conversion = "Could not convert: ";
    const std::size_t equals = message.find(" = ");
    if (message.starts_with(conversion) && equals != message.npos)
        return message.substr(conversion.size(), equals - conversion.size()) + ": found '" +
               message.substr(equals + 3) + "'; expected a number";
    return message;
}

/// Collective. Ranks may have been started with different arguments. Throws on all ranks where any has a `complaint`
/// about its own arguments, and where ranks do different things: one would wait for another forever.
void agreeOnCommand(Communicator& ranks, const std::string& complaint, const std::string& command)
{
    runTogether(ranks, [&] {
        if (!complaint.empty()) throw InputError(complaint);
    });
    requireSame(ranks, "the command", command);
}

/// What `--version` prints.
std::string versionAndLicence(const std::string& program)
{
    std::string text = program + " " + versionText;
    if (builtWithLzo)
        text += "\nbuilt with LZO: this program is under the GNU General Public License, version 3 or later";
    return text;
}

/// The arguments, from the last to the first, as CLI11 takes them. "help COMMAND" means "COMMAND --help".
std::vector<std::string> argumentsOf(const CLI::App& program, int argc, char** argv)
{
    std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
    if (!arguments.empty() && arguments.front() == "help") {
        arguments.erase(arguments.begin());
        const std::vector<std::string> known = commandNames(program);
        const bool isKnown =
            arguments.empty() || std::find(known.begin(), known.end(), arguments.front()) != known.end();
        if (isKnown) arguments.emplace_back("--help");
    }
    std::reverse(arguments.begin(), arguments.end());
    return arguments;
}

int parseAndRun(CLI::App& program, int argc, char** argv, Communicator& ranks)
{
    // Called before the command's own callback.
    program.parse_complete_callback([&] { agreeOnCommand(ranks, "", typedCommand(program)); });
    try {
        program.parse(argumentsOf(program, argc, argv));
    } catch (const CLI::Success& help) {
        agreeOnCommand(ranks, "", "help");
        std::ostringstream text;
        program.exit(help, text, text);
        if (ranks.isRoot()) print(text.str());
        return exitDone;
    } catch (const CLI::ParseError& error) {
        agreeOnCommand(ranks, optionComplaint(error, program), "");
    }
    return exitDone;
}

/// What a rank does about an error. If all ranks have it, rank 0 says so and all leave; else the whole job is ended.
int fail(const char* program, const std::exception& error, const std::string& message, int exitCode,
         Communicator* ranks)
{
    if (!ranks || ranks->size() == 1) return complain(program, message, exitCode);
    if (!dynamic_cast<const Agreed*>(&error)) ranks->abortJob(withoutControls(message), exitCode);
    if (ranks->isRoot()) complain(program, message, exitCode);
    ranks->barrier();  // The first rank to leave with an error makes the launcher end the others: rank 0 speaks first.
    return exitCode;
}

}  // namespace

std::vector<const CLI::App*> commandsOf(const CLI::App& program)
{
    return program.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

std::vector<std::string> commandNames(const CLI::App& program)
{
    std::vector<std::string> names;
    for (const CLI::App* command : commandsOf(program)) names.push_back(command->get_name());
    return names;
}

void addProgramOptions(CLI::App& program)
{
    program.set_version_flag("--version", versionAndLicence(program.get_name()), "prints the version");
    program.set_help_flag("-h,--help", "prints this help");
    program.require_subcommand(1);
}

int runProgram(const ProgramText& text, int argc, char** argv,
               void (*addCommands)(CLI::App& program, const std::shared_ptr<Communicator>& ranks))
{
    std::signal(SIGXFSZ, SIG_IGN);        // A file larger than `ulimit -f` is an error to report, not a sudden end.
    std::shared_ptr<Communicator> ranks;  // Outlives exceptions: an error has to reach the other ranks.
    try {
        ranks = joinRanks();
        const KeptReaders readers;  // One for all files that are looked at.
        CLI::App program(text.description, text.name);
        addProgramOptions(program);
        program.get_formatter()->column_width(34);
        addCommands(program, ranks);
        return parseAndRun(program, argc, argv, *ranks);
    } catch (const InputError& error) {
        return fail(text.name, error, error.what(), exitWrongInput, ranks.get());
    } catch (const std::bad_alloc& error) {
        return fail(text.name, error, "out of memory", exitFailed, ranks.get());
    } catch (const std::exception& error) {
        return fail(text.name, error, error.what(), exitFailed, ranks.get());
    }
}

}  // namespace aeolic
