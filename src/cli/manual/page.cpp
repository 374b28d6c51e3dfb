#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "cli/manual/manual.h"
#include "cli/manual/option_words.h"
#include "cli/program.h"

namespace aeolic::manual {
namespace {

/// Text as roff shows it: nothing in it is a command, and '-' stays the sign that people type.
std::string escaped(const std::string& text)
{
    std::string out;
    for (const char c : text) {
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else
            out += c;
    }
    if (!out.empty() && (out.front() == '.' || out.front() == '\'')) out.insert(0, "\\&");
    return out;
}

std::string headline(const CLI::App& command)
{
    std::string text = withSpaces(command.get_description());
    return text.substr(0, text.find(": "));
}

std::string optionEntry(const CLI::Option& option)
{
    std::string names;
    for (const std::string& name : namesOf(option))
        names += (names.empty() ? "\\fB" : ", \\fB") + escaped(name) + "\\fR";
    if (takesValue(option)) names += " \\fI" + escaped(option.get_type_name()) + "\\fR";
    const std::string usual = option.get_default_str();
    return ".TP\n" + names + "\n" +
           escaped(withSpaces(option.get_description()) + (usual.empty() ? "" : " [" + usual + "]")) + "\n";
}

/// Options by their headings, in the order of the help.
std::string options(const CLI::App& command)
{
    std::vector<std::string> headings;
    for (const CLI::Option* option : namedOptions(command))
        if (std::find(headings.begin(), headings.end(), option->get_group()) == headings.end())
            headings.push_back(option->get_group());
    std::string text;
    for (const std::string& heading : headings) {
        text += fmt::format(".SS {}\n", escaped(heading));
        for (const CLI::Option* option : namedOptions(command))
            if (option->get_group() == heading) text += optionEntry(*option);
    }
    return text;
}

}  // namespace

std::string pageName(const CLI::App& command)
{
    return command.get_parent() ? command.get_parent()->get_name() + "-" + command.get_name() : command.get_name();
}

std::string page(const CLI::App& command, const std::string& version)
{
    const CLI::App* program = command.get_parent();
    const std::string typed = program ? program->get_name() + " " + command.get_name() : command.get_name();
    std::string title = pageName(command);
    std::transform(title.begin(), title.end(), title.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? char(c - 32) : c; });
    std::string text = fmt::format(".TH {} 1 \"\" \"Aeolic {}\" \"Aeolic\"\n", escaped(title), version);
    text += fmt::format(".SH NAME\n{} \\- {}\n", escaped(pageName(command)), escaped(headline(command)));
    text += fmt::format(".SH SYNOPSIS\n.B {}\n", escaped(typed));
    const auto commands = commandsOf(command);
    if (!commands.empty()) text += ".I COMMAND\n";
    text += "[\\fIOPTION\\fR]...\n";
    for (const CLI::Option* option : command.get_options())
        if (!option->nonpositional()) {
            const std::string name = "\\fI" + escaped(option->get_name(true)) + "\\fR";
            text += (option->get_required() ? name : "[" + name + "]") + "\n";
        }
    text += fmt::format(".SH DESCRIPTION\n{}\n", escaped(withSpaces(command.get_description())));
    if (!commands.empty()) text += ".SH COMMANDS\n";
    for (const CLI::App* one : commands)
        text += fmt::format(".TP\n\\fB{}\\fR(1)\n{}\n", escaped(pageName(*one)),
                            escaped(withSpaces(one->get_description())));
    text += ".SH OPTIONS\n" + options(command);
    text +=
        ".SH EXIT STATUS\n0: done. 1: failed. 2: the input or the command line is wrong; one line on standard error "
        "says what.\n";
    if (program) text += fmt::format(".SH SEE ALSO\n.BR {} (1)\n", program->get_name());
    return text;
}

}  // namespace aeolic::manual
