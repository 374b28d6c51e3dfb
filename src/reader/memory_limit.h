#pragma once

#include <cstdint>

namespace aeolic {

/// Lets this process take no more memory than the machine has, and no more than `most` bytes beside what it has now.
/// Comes before each file, which begins with all of it. With sanitizers it does nothing.
void limitMemory(std::uint64_t most);

}  // namespace aeolic
