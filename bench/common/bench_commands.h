#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "cluster/comm/communicator.h"

namespace aeolic {

/// The commands of `aeolic-bench`. Under a launcher rank 0 measures, and the others wait.
void addScalingCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);
void addStagesCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);
void addCodecsCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);

}  // namespace aeolic
