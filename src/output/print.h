#pragma once

#include <string>

namespace aeolic {

/// Standard output, whole and at once. Throws std::runtime_error where it cannot be written.
void print(const std::string& text);

}  // namespace aeolic
