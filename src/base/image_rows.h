#pragma once

#include <cstddef>

namespace aeolic {

/// Local. Zeros in the first `left` and the last `right` bytes of each of `count` rows, which follow each other. On all
/// threads of the current arena where the rows are large: to touch new memory takes longer than the writing.
void clearSides(void* rows, std::size_t rowBytes, std::size_t count, std::size_t left, std::size_t right);

/// Local. std::memmove. On all threads of the current arena where there is much to move, and farther than it is long.
void moveBytes(void* to, const void* from, std::size_t bytes);

}  // namespace aeolic
