#include "base/large_memory.h"

#include <sys/mman.h>

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
    if (huge) madvise(memory, rounded, MADV_HUGEPAGE);  // A wish only: nothing depends on it.
    if (kFill) std::memset(memory, kOrdinary, rounded);
    return memory;
}

void freeLarge(void* memory) noexcept
{
    std::free(memory);
}

}  // namespace aeolic
