#pragma once

#include <string>

namespace aeolic {

/// Writes `text` to standard output, all of it at once. Throws std::runtime_error where it cannot be written.
void print(const std::string& text);

}  // namespace aeolic
