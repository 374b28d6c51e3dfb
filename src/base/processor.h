#pragma once

#include <string>

namespace aeolic {

/// The processor's name as the system gives it, for people; "unknown processor" where it gives none.
std::string processorName();

}  // namespace aeolic
