#include "reader/answer_files.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <new>

#include "reader/shared_malloc.h"

namespace aeolic {
namespace {

OwnedFile sealedCopy(const void* bytes, std::size_t count)
{
    OwnedFile file(memfd_create("aeolic-copy", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!file || ftruncate(file.get(), off_t(count)) != 0) throw std::bad_alloc();
    void* const memory = mmap(nullptr, count, PROT_READ | PROT_WRITE, MAP_SHARED, file.get(), 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    std::memcpy(memory, bytes, count);
    munmap(memory, count);
    if (fcntl(file.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE | F_SEAL_SEAL) != 0)
        throw std::bad_alloc();
    return file;
}

}  // namespace

std::uint32_t AnswerFiles::place(const void* bytes, std::size_t count)
{
    const auto [at, isNew] = placed_.try_emplace({bytes, count}, std::uint32_t(files_.size()));
    if (!isNew) return at->second;
    OwnedFile file = sealedFileOf(bytes, count);
    files_.push_back(file ? std::move(file) : sealedCopy(bytes, count));
    return at->second;
}

std::vector<int> AnswerFiles::descriptors() const
{
    std::vector<int> all;
    for (const OwnedFile& file : files_) all.push_back(file.get());
    return all;
}

}  // namespace aeolic
