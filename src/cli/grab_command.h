#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "cluster/comm/communicator.h"

namespace aeolic {

/// Adds `aeolic grab`: a picture from a running server.
void addGrabCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);

}  // namespace aeolic
