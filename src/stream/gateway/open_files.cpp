#include "stream/gateway/open_files.h"

#include <sys/resource.h>

#include <algorithm>
#include <string>

#include "aeolic/error.h"

namespace aeolic::stream {
namespace {

constexpr std::uint64_t kMostWeb = 1024, kLeastWeb = 16;
constexpr std::uint64_t kOthers = 16 + 64;  // The process's own, and clients that wait at the port for ranks.

}  // namespace

int webConnections(std::uint64_t files, int ranks)
{
    const std::uint64_t left = files > kOthers ? files - kOthers : 0;
    if (left < std::uint64_t(ranks) + kLeastWeb)
        throw InputError(
            "--ranks",
            std::to_string(ranks) + ", and this process may have " + std::to_string(files) + " files open (ulimit -n)",
            left > kLeastWeb ? "at most " + std::to_string(left - kLeastWeb) + " ranks, or a higher limit"
                             : "a higher limit");
    return int(std::min((left - std::uint64_t(ranks)) / 2, kMostWeb));  // Half stays free for starting the job.
}

int provideOpenFiles(int ranks)
{
    rlimit files{};
    if (getrlimit(RLIMIT_NOFILE, &files) != 0) return int(kLeastWeb);
    const rlim_t useful = kOthers + rlim_t(ranks) + 2 * kMostWeb;
    if (files.rlim_cur < useful && files.rlim_cur < files.rlim_max) {
        rlimit more = files;
        more.rlim_cur = std::min(useful, files.rlim_max);
        if (setrlimit(RLIMIT_NOFILE, &more) == 0) files = more;
    }
    return webConnections(files.rlim_cur, ranks);
}

}  // namespace aeolic::stream
