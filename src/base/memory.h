#pragma once

#include <cstdint>
#include <string>

namespace aeolic {

/// Bytes this process may still allocate without swapping or being killed: the smallest of the memory that the
/// kernel calls available, the rest of every control group (v1 or v2) that it is in, and the rest of its address space
/// limit (`ulimit -v`). Never throws; the largest value where nothing is known. Cost: a few reads from /proc and /sys.
std::uint64_t availableMemoryBytes();

/// What is left of the memory limits of the control groups that `root`/proc/self/cgroup names, and of their parents,
/// under `root`/sys/fs/cgroup. Cache that the kernel would drop counts as free. The largest value where there is no
/// limit. `root` is empty for this machine; tests give a folder of their own.
std::uint64_t cgroupAvailableBytes(const std::string& root = "");

/// Throws InputError naming `option` and `what` ("a field of 4096 x 4096 x 4096") if `bytes` is more than is available:
/// called before a large allocation, because Linux grants it and ends the process later.
void requireMemory(const std::string& option, const std::string& what, std::uint64_t bytes);

}  // namespace aeolic
