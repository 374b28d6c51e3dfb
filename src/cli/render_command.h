#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "cluster/comm/communicator.h"

namespace aeolic {

/// Adds `aeolic render`: draws a scene into PNG files.
void addRenderCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);

}  // namespace aeolic
