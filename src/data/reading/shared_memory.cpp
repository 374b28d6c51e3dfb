#include "data/reading/shared_memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <algorithm>
#include <new>

#include "data/reading/packet_socket.h"

namespace aeolic {

SharedMemory::SharedMemory(const OwnedFile& file)
{
    constexpr int needed = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE;
    struct stat status {};
    const int seals = fcntl(file.get(), F_GET_SEALS);
    if (seals < 0 || (seals & needed) != needed || fstat(file.get(), &status) != 0 || status.st_size <= 0)
        throw LostPeer();
    size_ = std::size_t(status.st_size);
    void* const memory = mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_NORESERVE, file.get(), 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    data_ = static_cast<std::byte*>(memory);
}

void SharedMemory::expectUse(std::size_t bytes) const
{
#ifdef MADV_POPULATE_READ
    madvise(data_, std::min(bytes, size_), MADV_POPULATE_READ);
#endif
}

SharedMemory::~SharedMemory()
{
    if (data_) munmap(data_, size_);
}

}  // namespace aeolic
