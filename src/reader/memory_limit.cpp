#include "reader/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <fstream>

#include "base/memory.h"

namespace aeolic {

void limitMemory([[maybe_unused]] std::uint64_t most)
{
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    // Threads' stacks and the libraries' own files take address space, but no memory to speak of.
    constexpr std::uint64_t besides = std::uint64_t(4) << 30;
    rlimit limit{};
    getrlimit(RLIMIT_AS, &limit);
    static const rlim_t given = limit.rlim_cur;  // By who started the caller.
    limit.rlim_cur = given;                      // What is available is counted without the limit of the file before.
    setrlimit(RLIMIT_AS, &limit);
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const std::uint64_t taken = pages * std::uint64_t(sysconf(_SC_PAGESIZE)), available = availableMemoryBytes();
    const std::uint64_t allowed = std::min(available, most);
    if (allowed >= UINT64_MAX - taken - besides) return;
    limit.rlim_cur = std::min<rlim_t>(taken + allowed + besides, given);
    setrlimit(RLIMIT_AS, &limit);
#endif
}

}  // namespace aeolic
