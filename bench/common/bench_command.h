#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "cluster/comm/communicator.h"

namespace aeolic {

/// Adds `aeolic bench` and what it can measure: `stages`, `scaling`, `codecs`.
void addBenchCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);

}  // namespace aeolic
