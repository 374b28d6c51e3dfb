#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "cluster/comm/communicator.h"

namespace aeolic {

/// Adds `aeolic info`: says what a data file holds.
void addInfoCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);

}  // namespace aeolic
