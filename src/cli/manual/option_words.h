#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// What manual pages and completions need of a command.
namespace aeolic::manual {

/// The options that begin with '-'.
std::vector<const CLI::Option*> namedOptions(const CLI::App& command);

/// "-o", "--output".
std::vector<std::string> namesOf(const CLI::Option& option);

bool takesValue(const CLI::Option& option);

/// The words that an option takes: "euler", "rk2" and "rk4" of "euler|rk2|rk4"; of "auto|LENGTH" only the first. Words
/// that end in '=' are beginnings.
std::vector<std::string> choicesOf(const CLI::Option& option);

/// Whether a file's name may stand there: its value is not only a choice, and neither a number nor a colour.
bool mayBeFile(const CLI::Option& option);

}  // namespace aeolic::manual
