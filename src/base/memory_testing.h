#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

namespace aeolic::test {

/// Leaves this process so much more address space, as `ulimit -v` does, while it lives.
class TightAddressSpace {
public:
    explicit TightAddressSpace(std::uint64_t roomBytes)
    {
        getrlimit(RLIMIT_AS, &before_);
        char text[64] = {};  // No stream, whose buffer would count as the process's and be gone afterwards.
        const int statm = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
        if (statm < 0 || read(statm, text, sizeof text - 1) <= 0) text[0] = '\0';
        if (statm >= 0) close(statm);
        const std::uint64_t pages = std::strtoull(text, nullptr, 10);
        rlimit limited = before_;
        limited.rlim_cur = rlim_t(pages * 4096 + roomBytes);
        set_ = limited.rlim_cur < before_.rlim_cur && setrlimit(RLIMIT_AS, &limited) == 0;
    }
    TightAddressSpace(const TightAddressSpace&) = delete;
    TightAddressSpace& operator=(const TightAddressSpace&) = delete;
    ~TightAddressSpace() { setrlimit(RLIMIT_AS, &before_); }

    bool set() const { return set_; }  ///< Else a tighter limit, or a sanitizer's shadow, is in the way.

private:
    rlimit before_{};
    bool set_ = false;
};

}  // namespace aeolic::test
