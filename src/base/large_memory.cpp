#include "base/large_memory.h"

#include <sys/mman.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

namespace aeolic {
namespace {

constexpr std::size_t kHugePage = std::size_t(2) << 20, kVector = 128;

// Memory that nobody wrote must not show in pictures. Zeros and NaN would hide a mistake; ordinary numbers make the
// tests that compare bytes fail.
#if !defined(NDEBUG) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kFill = true;
#else
constexpr bool kFill = false;
#endif
constexpr int kOrdinary = 0x42;  // 0x42424242: as a float 48.6.

}  // namespace

void* allocateLarge(std::size_t bytes)
{
    const bool huge = bytes >= kHugePage;
    const std::size_t alignment = huge ? kHugePage : kVector;
    const std::size_t rounded = (bytes / alignment + (bytes % alignment != 0 || bytes == 0)) * alignment;
    void* memory = rounded < bytes ? nullptr : std::aligned_alloc(alignment, rounded);
    if (!memory) throw std::bad_alloc();
    if (huge) wishForHugePages(memory, rounded);
    if (kFill) std::memset(memory, kOrdinary, rounded);
    return memory;
}

void wishForHugePages(void* memory, std::size_t bytes) noexcept
{
    const auto address = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t begin = (address + kHugePage - 1) / kHugePage * kHugePage,
                         end = (address + bytes) / kHugePage * kHugePage;
    if (begin < end)  // Nothing depends on what the system answers.
        madvise(static_cast<char*>(memory) + (begin - address), end - begin, MADV_HUGEPAGE);
}

}  // namespace aeolic
