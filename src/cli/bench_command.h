#pragma once

#include <CLI/CLI.hpp>

namespace aeolic {

/// Adds `aeolic bench` and what it can measure: `stages`.
void addBenchCommand(CLI::App& program);

}  // namespace aeolic
