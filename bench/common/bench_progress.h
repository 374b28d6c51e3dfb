#pragma once

#include <functional>
#include <string>

namespace aeolic {

/// Called before each piece of a measurement with what comes and how far the whole is, 0 to 1.
using BenchProgress = std::function<void(const std::string& what, double fraction)>;

}  // namespace aeolic
