#pragma once

#include <cstdio>
#include <stdexcept>
#include <string>

namespace aeolic {

/// Writes `text` to standard output, all of it at once. Throws std::runtime_error where it cannot be written.
inline void print(const std::string& text)
{
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        throw std::runtime_error("standard output: cannot be written");
}

}  // namespace aeolic
