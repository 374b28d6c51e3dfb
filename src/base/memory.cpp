#include "base/memory.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>

#include "aeolic/error.h"

namespace aeolic {
namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

/// What is left of `limit` once `used` is taken; zero rather than a wrapped number when the limit was lowered below it.
std::uint64_t left(std::uint64_t limit, std::uint64_t used)
{
    return limit > used ? limit - used : 0;
}

/// The whole number a file starts with. Empty if it cannot be read or says something else ("max" is cgroup v2's no
/// limit).
std::optional<std::uint64_t> readNumber(const std::string& path)
{
    std::ifstream file(path);
    std::uint64_t number = 0;
    if (!(file >> number)) return std::nullopt;
    return number;
}

/// The number after `key` in a file of "key number" lines.
std::optional<std::uint64_t> readKeyed(const std::string& path, const std::string& key)
{
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string name;
        std::uint64_t number = 0;
        if (words >> name >> number && name == key) return number;
    }
    return std::nullopt;
}

/// The names one generation of control groups gives to the same four numbers.
struct CgroupNames {
    const char* mount;
    const char* limit;
    const char* usage;
    const char* reclaimable;
};
constexpr CgroupNames cgroup1{"/sys/fs/cgroup/memory", "/memory.limit_in_bytes", "/memory.usage_in_bytes",
                              "total_inactive_file"};
constexpr CgroupNames cgroup2{"/sys/fs/cgroup", "/memory.max", "/memory.current", "inactive_file"};

std::uint64_t groupAvailableBytes(const std::string& folder, const CgroupNames& names)
{
    const std::optional<std::uint64_t> limit = readNumber(folder + names.limit);
    const std::optional<std::uint64_t> used = readNumber(folder + names.usage);
    if (!limit || !used) return unlimited;
    const std::uint64_t reclaimable = readKeyed(folder + "/memory.stat", names.reclaimable).value_or(0);
    return left(*limit, left(*used, reclaimable));
}

/// The tightest of a group and its ancestors. In a container the named path may lie outside of the mount: then those
/// files are missing and the walk ends at the mount itself, which is the container's own group.
std::uint64_t hierarchyAvailableBytes(const std::string& mount, std::string group, const CgroupNames& names)
{
    std::uint64_t available = unlimited;
    while (!group.empty() && group != "/") {
        available = std::min(available, groupAvailableBytes(mount + group, names));
        group.resize(group.rfind('/') == std::string::npos ? 0 : group.rfind('/'));
    }
    return std::min(available, groupAvailableBytes(mount, names));
}

bool listsMemory(const std::string& controllers)
{
    return ("," + controllers + ",").find(",memory,") != std::string::npos;
}

std::uint64_t addressSpaceAvailableBytes()
{
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
    const std::uint64_t pages = readNumber("/proc/self/statm").value_or(0);
    return left(limit.rlim_cur, pages * std::uint64_t(sysconf(_SC_PAGESIZE)));
}

std::string inWords(std::uint64_t bytes)
{
    const double mebibytes = double(bytes) / double(1u << 20);
    return mebibytes < 1024 ? fmt::format("{:.0f} MiB", std::ceil(mebibytes))
                            : fmt::format("{:.1f} GiB", mebibytes / 1024);
}

}  // namespace

std::uint64_t cgroupAvailableBytes(const std::string& root)
{
    std::uint64_t available = unlimited;
    std::ifstream file(root + "/proc/self/cgroup");
    // Each line is hierarchy:controllers:path; version 2 is hierarchy 0 without controllers.
    for (std::string line; std::getline(file, line);) {
        const std::size_t first = line.find(':');
        const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        const bool isVersion2 = line.compare(0, first, "0") == 0 && controllers.empty();
        if (!isVersion2 && !listsMemory(controllers)) continue;
        const CgroupNames& names = isVersion2 ? cgroup2 : cgroup1;
        available = std::min(available, hierarchyAvailableBytes(root + names.mount, line.substr(second + 1), names));
    }
    return available;
}

std::uint64_t availableMemoryBytes()
{
    const std::optional<std::uint64_t> kibibytes = readKeyed("/proc/meminfo", "MemAvailable:");
    const std::uint64_t machine = kibibytes ? *kibibytes * 1024 : unlimited;
    return std::min({machine, cgroupAvailableBytes(), addressSpaceAvailableBytes()});
}

void requireMemory(const std::string& option, const std::string& what, std::uint64_t bytes)
{
    const std::uint64_t available = availableMemoryBytes();
    if (bytes <= available) return;
    throw InputError(option, what + " needs " + inWords(bytes),
                     "at most the " + inWords(available) + " of memory that is available");
}

}  // namespace aeolic
