#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "description/option_rules.h"

namespace aeolic {

/// An option of the command line as `--help` shows it.
struct OptionHelp {
    std::string name;      ///< "--steps"
    std::string value;     ///< "N", "box|hann"
    std::string heading;   ///< What it stands under.
    std::string text;      ///< What it does, its range and its default. Items of a compound option are a line each.
    bool repeats = false;  ///< It may be given several times.
};

/// Every option of a scene, in the order of the table.
std::vector<OptionHelp> optionsHelp();

/// The words that the value of the option `name` ("--colormap") may be; of a compound option those that its items begin
/// with: "zoom=". Empty where it is no word.
std::vector<std::string> optionWords(std::string_view name);

/// The rule of the option `name` ("--steps"), for programs that take several values of it. Throws std::logic_error
/// where its value is no number.
NumberRule numberRuleOf(std::string_view name);

}  // namespace aeolic
