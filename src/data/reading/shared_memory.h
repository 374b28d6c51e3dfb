#pragma once

#include <cstddef>
#include <memory>

#include "data/reading/owned_file.h"

namespace aeolic {

/// Memory of an answer. The reader has written and sealed it; the caller maps it without a copy. Nobody can change what
/// others see of it; a process that writes into it gets pages of its own.
class SharedMemory {
public:
    /// Maps a memory file. Throws LostPeer where it is not sealed against writing and changes of its size.
    explicit SharedMemory(const OwnedFile& file);
    SharedMemory(const SharedMemory&) = delete;
    SharedMemory& operator=(const SharedMemory&) = delete;
    ~SharedMemory();

    /// So many bytes will be used. Their pages are there already: to find them all at once takes a tenth of what
    /// finding each at its first use does. Behind them the file may have holes, which are left alone.
    void expectUse(std::size_t bytes) const;

    std::byte* data() const { return data_; }
    std::size_t size() const { return size_; }

private:
    std::byte* data_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace aeolic
