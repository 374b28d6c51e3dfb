#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "cluster/comm/communicator.h"

namespace aeolic {

/// Adds `aeolic render`: draws a scene into PNG files.
void addRenderCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);

/// Adds `aeolic info`: says what a data file holds.
void addInfoCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);

/// Adds `aeolic serve`, the page and stream of a scene, and `aeolic render-job`, the process it draws with.
void addServeCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);

/// Adds `aeolic grab`: a picture from a running server.
void addGrabCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);

}  // namespace aeolic
