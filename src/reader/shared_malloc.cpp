#include "reader/shared_malloc.h"

#include <fcntl.h>
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <mutex>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

// The allocator of the GNU C library under the names that it has for those who replace malloc().
// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming): the names are the library's.
extern "C" {
void* __libc_malloc(std::size_t bytes);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* memory, std::size_t bytes);
void __libc_free(void* memory);
}
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)

namespace {

constexpr std::size_t kLarge = std::size_t(1) << 20, kPage = 4096;

/// A piece of memory that is a file.
struct Region {
    void* memory = nullptr;
    std::size_t bytes = 0;  // Whole pages.
    int file = -1;
    bool sealed = false;
};

/// All such pieces, by address. It allocates nothing itself.
class Regions {
public:
    void* add(std::size_t wanted)
    {
        if (wanted > SIZE_MAX - 2 * kPage) return nullptr;
        // Vectors may be read a little past their end.
        const std::size_t bytes = (wanted + 64 + kPage - 1) / kPage * kPage;
        const int file = memfd_create("aeolic-memory", MFD_CLOEXEC | MFD_ALLOW_SEALING);
        if (file < 0) return nullptr;
        void* memory = ftruncate(file, off_t(bytes)) != 0
                           ? MAP_FAILED
                           : mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        if (memory != MAP_FAILED) {
            const std::lock_guard lock(mutex_);
            if (put({memory, bytes, file, false})) return memory;
            munmap(memory, bytes);
        }
        close(file);
        return nullptr;
    }

    /// Takes the piece out of the table; its memory is null where there is none.
    Region take(void* memory)
    {
        const std::lock_guard lock(mutex_);
        Region* const found = find(memory);
        if (!found) return {};
        const Region region = *found;
        remove(std::size_t(found - regions_.data()));
        return region;
    }

    std::size_t bytesOf(const void* memory)
    {
        const std::lock_guard lock(mutex_);
        const Region* found = find(memory);
        return found ? found->bytes : 0;
    }

    int seal(const void* memory, std::size_t bytes)
    {
        const std::lock_guard lock(mutex_);
        Region* const region = find(memory);
        if (!region || region->bytes < bytes || region->sealed)
            return -1;  // A sealed file lacks what was written since.
        // A file can be sealed once nobody could write to it. This process goes on with pages of its own.
        if (mmap(region->memory, region->bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_FIXED | MAP_NORESERVE,
                 region->file, 0) == MAP_FAILED)
            return -1;
        region->sealed = true;
        if (fcntl(region->file, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE | F_SEAL_SEAL) != 0) return -1;
        return fcntl(region->file, F_DUPFD_CLOEXEC, 0);
    }

private:
    static constexpr std::size_t kPlaces = 1 << 14, kMost = kPlaces / 2;

    static std::size_t placeOf(const void* memory)
    {
        return std::size_t((reinterpret_cast<std::uintptr_t>(memory) / kPage * 0x9e3779b97f4a7c15U) >> 50) % kPlaces;
    }

    Region* find(const void* memory)
    {
        for (std::size_t i = placeOf(memory); regions_[i].memory; i = (i + 1) % kPlaces)
            if (regions_[i].memory == memory) return &regions_[i];
        return nullptr;
    }

    bool put(const Region& region)
    {
        if (count_ >= kMost) return false;
        std::size_t i = placeOf(region.memory);
        while (regions_[i].memory) i = (i + 1) % kPlaces;
        regions_[i] = region;
        ++count_;
        return true;
    }

    /// Those behind it move up, so that they are still found.
    void remove(std::size_t hole)
    {
        --count_;
        for (std::size_t i = (hole + 1) % kPlaces; regions_[i].memory; i = (i + 1) % kPlaces) {
            const std::size_t home = placeOf(regions_[i].memory);
            const bool stays = hole < i ? home > hole && home <= i : home > hole || home <= i;
            if (stays) continue;
            regions_[hole] = regions_[i];
            hole = i;
        }
        regions_[hole] = {};
    }

    std::mutex mutex_;
    std::size_t count_ = 0;
    std::array<Region, kPlaces> regions_{};
};

constinit Regions regions;

/// Only whole pages are pieces of ours, and the C library seldom begins there.
bool mayBeRegion(const void* memory)
{
    return memory && reinterpret_cast<std::uintptr_t>(memory) % kPage == 0;
}

void release(const Region& region)
{
    munmap(region.memory, region.bytes);
    close(region.file);
}

}  // namespace

extern "C" {

void* malloc(std::size_t bytes)
{
    if (bytes >= kLarge)
        if (void* memory = regions.add(bytes)) return memory;
    return __libc_malloc(bytes);
}

void free(void* memory)
{
    if (mayBeRegion(memory)) {
        const int error = errno;
        const Region region = regions.take(memory);
        if (region.memory) {
            release(region);
            errno = error;
            return;
        }
    }
    __libc_free(memory);
}

void* calloc(std::size_t count, std::size_t bytes)
{
    std::size_t all = 0;
    if (!__builtin_mul_overflow(count, bytes, &all) && all >= kLarge)
        if (void* memory = regions.add(all)) return memory;  // New files are zeros.
    return __libc_calloc(count, bytes);
}

void* realloc(void* memory, std::size_t bytes)
{
    const std::size_t before = mayBeRegion(memory) ? regions.bytesOf(memory) : 0;
    if (before == 0 && (bytes < kLarge || !memory)) return memory ? __libc_realloc(memory, bytes) : malloc(bytes);
    if (before > 0 && bytes >= kLarge && bytes + 64 <= before && bytes + before / 4 >= before) return memory;
    void* const moved = malloc(bytes);
    if (!moved) return nullptr;
    const std::size_t old = before > 0 ? before : malloc_usable_size(memory);
    std::memcpy(moved, memory, std::min(old, bytes));
    free(memory);
    return moved;
}

}  // extern "C"

namespace aeolic {

OwnedFile sealedFileOf(const void* memory, std::size_t bytes)
{
    return OwnedFile(mayBeRegion(memory) ? regions.seal(memory, bytes) : -1);
}

}  // namespace aeolic

#else

namespace aeolic {

OwnedFile sealedFileOf(const void*, std::size_t)
{
    return OwnedFile();
}

}  // namespace aeolic

#endif
