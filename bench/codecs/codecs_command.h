#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "cluster/comm/communicator.h"

namespace aeolic {

/// Adds `aeolic bench codecs` to `bench`.
void addCodecsCommand(CLI::App& bench, const std::shared_ptr<Communicator>& ranks);

}  // namespace aeolic
