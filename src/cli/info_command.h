#pragma once

#include <CLI/CLI.hpp>

namespace aeolic {

/// Adds `aeolic info`: says what a data file holds.
void addInfoCommand(CLI::App& program);

}  // namespace aeolic
