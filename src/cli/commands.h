#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/program.h"
#include "cluster/comm/communicator.h"

namespace aeolic {

/// Adds `aeolic render`: draws a scene into PNG files.
void addRenderCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);

/// Adds `aeolic extract`: writes what the flow has as points and lines.
void addExtractCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);

/// Adds `aeolic probe`: tells what a picture shows at a pixel.
void addProbeCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);

/// Adds `aeolic info`: says what a data file holds.
void addInfoCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);

/// Adds `aeolic serve`, the page and stream of a scene, and `aeolic render-job`, the process it draws with.
void addServeCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);

/// Adds `aeolic grab`: a picture from a running server.
void addGrabCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks);

/// All of them, and `bench`, which says where it went.
void addCommands(CLI::App& program, const std::shared_ptr<Communicator>& ranks);

inline constexpr ProgramText programText{
    "aeolic", "Flow drawn on surfaces: line integral convolution, fast and the same everywhere."};

}  // namespace aeolic
