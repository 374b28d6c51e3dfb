#include "description/option_help.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <type_traits>

#include "description/file_kinds.h"
#include "description/option_table.h"
#include "description/scene_text.h"

namespace aeolic {
namespace {

std::string choicesOf(const NumberRule& rule)
{
    return rangeText(rule);
}
std::string choicesOf(const NameRule& rule)
{
    return fmt::format("{}{}{}", fmt::join(rule.names, ", "), rule.isOther ? ", or " : "", rule.others);
}
std::string choicesOf(const TextRule&)
{
    return "";
}
std::string choicesOf(const SwitchRule&)
{
    return "on, off";
}

/// "integration steps in each direction; from 1 to 65536 [128]". What the option's value already shows is left out.
std::string describe(const Option& option, const std::string& choices, const std::string& initial)
{
    const bool inValue = option.value[0] == '\0' && std::string_view(option.name).find(' ') == std::string_view::npos;
    std::string text = withFileKinds(option.help);
    if (!inValue && !choices.empty()) text += (text.empty() ? "" : "; ") + choices;
    return fmt::format("{} [{}]", text, initial.empty() ? option.unset : initial);
}

/// The option of the command line that `name` is an item of; null where it stands by itself.
const TypedOption* compoundOf(std::string_view name)
{
    const auto* const found =
        std::find_if(std::begin(compoundOptions), std::end(compoundOptions),
                     [&](const TypedOption& compound) { return name.starts_with(std::string(compound.name) + " "); });
    return found == std::end(compoundOptions) ? nullptr : found;
}

}  // namespace

std::vector<OptionHelp> optionsHelp()
{
    std::vector<OptionHelp> all;
    const SceneDescription defaults;
    forEachOption(defaults, [&](const Option& option, const auto&, const auto& rule) {
        const std::string choices = choicesOf(rule),
                          text = describe(option, choices, optionText(defaults, option.name));
        const TypedOption* const compound = compoundOf(option.name);
        if (std::string_view(option.name).ends_with(wordSuffix)) return;  // They stand in the value of another row.
        if (!compound) {
            std::string value = option.value;
            if (value.empty())
                for (const char c : choices) value += c == ',' ? "|" : c == ' ' ? "" : std::string(1, c);
            const bool isSurface = std::string_view(option.name) == "--surface";
            all.push_back({option.name, value, option.group.heading, text, isSurface});
            if (isSurface)
                all.push_back(
                    {contextOption.name, contextOption.value, contextOption.heading, contextOption.help, true});
            return;
        }
        if (all.empty() || all.back().name != compound->name)
            all.push_back({compound->name, compound->value, compound->heading, compound->help, false});
        all.back().text +=
            fmt::format("\n{}: {}", std::string_view(option.name).substr(all.back().name.size() + 1), text);
    });
    return all;
}

std::vector<std::string> optionWords(std::string_view name)
{
    std::vector<std::string> words;
    forEachOption(SceneDescription{}, [&](const Option& option, const auto&, const auto& rule) {
        if constexpr (std::is_same_v<std::decay_t<decltype(rule)>, NameRule>)
            if (option.name == name || option.name == std::string(name).append(wordSuffix))
                words.assign(rule.names.begin(), rule.names.end());
        const TypedOption* const compound = compoundOf(option.name);
        if (compound && compound->hasItems && compound->name == name)
            words.push_back(std::string(std::string_view(option.name).substr(name.size() + 1)) + "=");
    });
    if (name == "--camera")
        for (const NamedView& view : namedViews) words.emplace_back(view.name);
    return words;
}

NumberRule numberRuleOf(std::string_view name)
{
    std::optional<NumberRule> found;
    forEachOption(SceneDescription{}, [&](const Option& option, const auto&, const auto& rule) {
        if constexpr (std::is_same_v<std::decay_t<decltype(rule)>, NumberRule>)
            if (option.name == name) found = rule;
    });
    if (!found) throw std::logic_error(std::string(name) + " has no range");
    return *found;
}

}  // namespace aeolic
