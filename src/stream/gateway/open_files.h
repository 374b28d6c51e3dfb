#pragma once

#include <cstdint>

namespace aeolic::stream {

/// How many connections of viewers a server of so many ranks takes at once, if it may have `files` files open. Each
/// rank's link is one. Throws InputError where there are too few: it says how many ranks are possible.
int webConnections(std::uint64_t files, int ranks);

/// Raises this process's limit of open files to what it may be and what such a server can use, and returns
/// webConnections() for it. The limit goes no further, because programs that are started close all files below it one
/// by one. Throws InputError.
int provideOpenFiles(int ranks);

}  // namespace aeolic::stream
