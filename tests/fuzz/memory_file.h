#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace aeolic::fuzz {

/// A file that is in memory alone, for readers that take a path.
class MemoryFile {
public:
    MemoryFile(const std::uint8_t* data, std::size_t size) : file_(memfd_create("fuzz", 0))
    {
        if (file_ < 0 || write(file_, data, size) != ssize_t(size)) __builtin_trap();
    }
    ~MemoryFile() { close(file_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

private:
    int file_;
};

/// A message is one line, whatever the file holds.
inline void requireOneLine(const std::string& message)
{
    if (message.find('\n') != std::string::npos) __builtin_trap();
}

}  // namespace aeolic::fuzz
