#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <vector>

namespace aeolic {

/// Local. Memory for arrays that kernels read all over: aligned for any vector, and large ones on huge pages where the
/// system has them. On pages of 4 KB a scattered read costs more for finding the page than for the data, above all in
/// virtual machines. Not initialised. Throws std::bad_alloc.
void* allocateLarge(std::size_t bytes);

/// Local. Asks for huge pages for memory that was allocated elsewhere and not touched yet, where the system has them
/// and whole ones fit in. To write for the first time into pages of 4 KB takes ten times as long as the writing, in
/// virtual machines. What the memory holds stays the same.
void wishForHugePages(void* memory, std::size_t bytes) noexcept;

struct FreeLarge {
    void operator()(void* memory) const noexcept { std::free(memory); }
};

template <class T>
using LargeArray = std::unique_ptr<T[], FreeLarge>;

/// An array of a trivial type in such memory; not initialised.
template <class T>
LargeArray<T> makeLargeArray(std::size_t count)
{
    return LargeArray<T>(static_cast<T*>(allocateLarge(count * sizeof(T))));
}

template <class T>
struct LargeAllocator {
    using value_type = T;
    LargeAllocator() = default;
    template <class U>
    LargeAllocator(const LargeAllocator<U>&) noexcept
    {
    }
    T* allocate(std::size_t count) { return static_cast<T*>(allocateLarge(count * sizeof(T))); }
    void deallocate(T* memory, std::size_t) noexcept { std::free(memory); }
    bool operator==(const LargeAllocator&) const = default;
};

template <class T>
using LargeVector = std::vector<T, LargeAllocator<T>>;

}  // namespace aeolic
