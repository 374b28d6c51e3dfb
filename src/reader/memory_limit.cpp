#include "reader/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <thread>

#include "base/memory.h"

namespace aeolic {

void limitMemory([[maybe_unused]] std::uint64_t most)
{
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    // The libraries' own files take address space, but no memory to speak of, and so does each thread: 8 MiB for its
    // stack, and twice 64 MiB where malloc() begins to keep memory for it.
    constexpr std::uint64_t ofThread = std::uint64_t(136) << 20, ofLibraries = std::uint64_t(4) << 30;
    const std::uint64_t besides = ofLibraries + std::thread::hardware_concurrency() * ofThread;
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
