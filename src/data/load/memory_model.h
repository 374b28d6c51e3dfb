#pragma once

#include <cstdint>

#include "base/memory.h"

namespace aeolic {

/// How many steps of a series are in memory at once: two, the moment between them, and one that is read ahead.
constexpr std::uint64_t kStepsInMemory = 4;

/// Reading takes some more memory than the data kept: values are converted, and readers hold the file's own bytes.
constexpr double kReadingOverhead = 1.3;

/// Local. Whether there is memory to read data of which `keptBytes` are kept, by `readers` ranks of this host at once.
inline bool hasMemoryToRead(std::uint64_t keptBytes, int readers = 1)
{
    return kReadingOverhead * double(keptBytes) * readers <= double(availableMemoryBytes());
}

}  // namespace aeolic
