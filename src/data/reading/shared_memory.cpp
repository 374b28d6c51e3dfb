#include "data/reading/shared_memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <new>
#include <stdexcept>

namespace aeolic {

SharedMemory::SharedMemory(const OwnedFile& file)
{
    constexpr int needed = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE;
    struct stat status {};
    const int seals = fcntl(file.get(), F_GET_SEALS);
    if (seals < 0 || (seals & needed) != needed || fstat(file.get(), &status) != 0 || status.st_size <= 0)
        throw std::runtime_error("memory that could still change");
    size_ = std::size_t(status.st_size);
    // Pages are there already. To find them all at once takes a tenth of what finding each at its first use does.
    void* const memory = mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_NORESERVE, file.get(), 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    data_ = static_cast<std::byte*>(memory);
#ifdef MADV_POPULATE_READ
    madvise(memory, size_, MADV_POPULATE_READ);
#endif
}

SharedMemory::~SharedMemory()
{
    if (data_) munmap(data_, size_);
}

}  // namespace aeolic
