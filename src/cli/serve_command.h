#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "cluster/comm/communicator.h"

namespace aeolic {

/// Adds `aeolic serve`, the page and stream of a scene, and `aeolic render-job`, the process it draws with.
void addServeCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);

}  // namespace aeolic
