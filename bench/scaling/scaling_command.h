#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "cluster/comm/communicator.h"

namespace aeolic {

/// Adds `aeolic bench scaling` to `bench`.
void addScalingCommand(CLI::App& bench, const std::shared_ptr<Communicator>& ranks);

}  // namespace aeolic
