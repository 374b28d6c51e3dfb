#pragma once

#include <CLI/CLI.hpp>
#include <string>

/// Manual pages and completions, made of the commands and options themselves.
namespace aeolic::manual {

/// A command's page in the language of man(7): the program's own, or that of one of its commands. `version` stands at
/// its foot.
std::string page(const CLI::App& command, const std::string& version);

/// A page's name: "aeolic", "aeolic-render".
std::string pageName(const CLI::App& command);

/// A script for bash-completion: commands, options, and the values of those with a list of them. Where a file may
/// stand, bash's own names of files.
std::string bashCompletion(const CLI::App& program);

/// The same for zsh, with a line about each option.
std::string zshCompletion(const CLI::App& program);

}  // namespace aeolic::manual
