#include "cli/manual/option_words.h"

#include <algorithm>
#include <array>

#include "base/text.h"
#include "description/option_help.h"

namespace aeolic::manual {

std::vector<const CLI::Option*> namedOptions(const CLI::App& command)
{
    std::vector<const CLI::Option*> options;
    for (const CLI::Option* option : command.get_options())
        if (option->nonpositional() && !option->get_group().empty()) options.push_back(option);
    return options;
}

std::vector<std::string> namesOf(const CLI::Option& option)
{
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

bool takesValue(const CLI::Option& option)
{
    return option.get_expected_max() > 0 && !option.get_type_name().empty();
}

std::vector<std::string> choicesOf(const CLI::Option& option)
{
    std::vector<std::string> choices;
    const std::string text = option.get_type_name();
    for (const std::string& name : namesOf(option))
        if (choices.empty()) choices = optionWords(name);
    if (!choices.empty() || text.find('|') == std::string::npos) return choices;
    for (const std::string_view word : splitText(text, '|'))
        if (!word.empty() && word.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == word.npos)
            choices.emplace_back(word);
    return choices;
}

bool mayBeFile(const CLI::Option& option)
{
    const std::string text = option.get_type_name();
    constexpr std::array<const char*, 7> files{"FILE", "SURFACE", "FIELD", "OUT", "FOLDER", "SCENE", "NAME"};
    return std::any_of(files.begin(), files.end(),
                       [&](const char* word) { return text.find(word) != std::string::npos; });
}

}  // namespace aeolic::manual
