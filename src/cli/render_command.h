#pragma once

#include <CLI/CLI.hpp>

namespace aeolic {

/// Adds `aeolic render`: draws a scene into PNG files.
void addRenderCommand(CLI::App& program);

}  // namespace aeolic
