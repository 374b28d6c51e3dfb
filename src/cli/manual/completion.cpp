#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/text.h"
#include "cli/manual/manual.h"
#include "cli/manual/option_words.h"
#include "cli/program.h"

namespace aeolic::manual {
namespace {

std::vector<std::string> allNames(const CLI::App& command)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : namedOptions(command))
        for (const std::string& name : namesOf(*option)) names.push_back(name);
    return names;
}

/// Whether some choices go on, as "zoom=" does.
bool areBeginnings(const std::vector<std::string>& choices)
{
    return std::any_of(choices.begin(), choices.end(), [](const std::string& choice) { return choice.ends_with('='); });
}

/// The lines of bash's case that say what may follow one command's options.
std::string valuesInBash(const CLI::App& command)
{
    std::string text;
    for (const CLI::Option* option : namedOptions(command)) {
        if (!takesValue(*option)) continue;
        const std::vector<std::string> choices = choicesOf(*option);
        const bool file = mayBeFile(*option);
        text += fmt::format("        {})\n", fmt::join(namesOf(*option), "|"));
        if (!choices.empty())
            text += fmt::format("            COMPREPLY=($(compgen -W \"{}\" -- \"$cur\"))\n", fmt::join(choices, " "));
        if (areBeginnings(choices)) text += "            compopt -o nospace\n";
        if (file) text += "            compopt -o default\n";
        text += "            return ;;\n";
    }
    return text;
}

/// Text within zsh's '[…]' within single quotes.
std::string inBrackets(const std::string& text)
{
    std::string out;
    for (const char c : text) {
        if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
        out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return out;
}

std::string optionInZsh(const CLI::Option& option)
{
    const std::vector<std::string> names = namesOf(option);
    std::string about = withSpaces(option.get_description());
    about = about.substr(0, about.find("; "));
    std::string value;
    if (takesValue(option)) {
        const std::vector<std::string> choices = choicesOf(option);
        const bool file = mayBeFile(option), begins = areBeginnings(choices);
        const std::string words = fmt::format("{}", fmt::join(choices, " "));
        const std::string action = choices.empty()  ? std::string(file ? "_files" : " ")
                                   : file || begins ? fmt::format("{{compadd {}-- {}{}}}", begins ? "-S \"\" " : "",
                                                                  words, file ? "; _files" : "")
                                                    : "(" + words + ")";
        value = fmt::format(":{}:{}", inBrackets(option.get_type_name()), action);
    }
    std::string text;
    for (const std::string& name : names)
        text += fmt::format("                '{}[{}]{}' \\\n", name, inBrackets(about), value);
    return text;
}

}  // namespace

std::string bashCompletion(const CLI::App& program)
{
    const std::string& name = program.get_name();
    std::string text = fmt::format("# Completion of {0} for bash. Made of its options.\n_{0}()\n{{\n", name);
    text +=
        "    local cur=\"${COMP_WORDS[COMP_CWORD]}\" previous=\"${COMP_WORDS[COMP_CWORD-1]}\" "
        "command=\"${COMP_WORDS[1]}\"\n";
    text += fmt::format(
        "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n        COMPREPLY=($(compgen -W \"{} {}\" -- \"$cur\"))\n        "
        "return\n    fi\n",
        fmt::join(commandNames(program), " "), fmt::join(allNames(program), " "));
    text += "    case \"$command\" in\n";
    for (const CLI::App* command : commandsOf(program)) {
        text += fmt::format("    {})\n        case \"$previous\" in\n{}        esac\n", command->get_name(),
                            valuesInBash(*command));
        text += fmt::format(
            "        case \"$cur\" in -*) COMPREPLY=($(compgen -W \"{}\" -- \"$cur\")); return ;; esac ;;\n",
            fmt::join(allNames(*command), " "));
    }
    text += fmt::format("    esac\n    compopt -o default\n}}\ncomplete -F _{0} {0}\n", name);
    return text;
}

std::string zshCompletion(const CLI::App& program)
{
    const std::string& name = program.get_name();
    std::string text = fmt::format(
        "#compdef {0}\n# Completion of {0} for zsh. Made of its options.\n_{0}()\n{{\n    local -a commands=(\n", name);
    for (const CLI::App* command : commandsOf(program))
        text +=
            fmt::format("        '{}:{}'\n", command->get_name(), inBrackets(withSpaces(command->get_description())));
    text +=
        "    )\n    if (( CURRENT == 2 )); then\n        _describe command commands\n        return\n    fi\n    case "
        "$words[2] in\n";
    for (const CLI::App* command : commandsOf(program)) {
        text += fmt::format(
            "        {})\n            shift words\n            (( CURRENT-- ))\n            _arguments \\\n",
            command->get_name());
        for (const CLI::Option* option : namedOptions(*command)) text += optionInZsh(*option);
        text += "                '*:file:_files' ;;\n";
    }
    text += fmt::format("    esac\n}}\n_{0} \"$@\"\n", name);
    return text;
}

}  // namespace aeolic::manual
