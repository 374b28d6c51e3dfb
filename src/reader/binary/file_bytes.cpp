#include "reader/binary/file_bytes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "aeolic/error.h"

namespace aeolic {

FileBytes::FileBytes(const std::string& path) : path_(path), descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC))
{
    struct stat facts {};
    if (descriptor_ < 0 || fstat(descriptor_, &facts) != 0) {
        const std::string why = std::strerror(errno);
        if (descriptor_ >= 0) close(descriptor_);
        throw InputError(path, why, "a file that can be read");
    }
    if (!S_ISREG(facts.st_mode)) {
        close(descriptor_);
        throw InputError(path, "it is not a plain file", "a file that can be read");
    }
    size_ = std::uint64_t(facts.st_size);
}

FileBytes::~FileBytes()
{
    close(descriptor_);
}

void FileBytes::require(std::uint64_t begin, std::uint64_t count, const char* item) const
{
    if (begin > size_ || count > size_ - begin)
        throw InputError(path_,
                         fmt::format("{} should have {} bytes at {}, and the file has {}", item, count, begin, size_),
                         "a complete, undamaged file");
}

void FileBytes::read(std::uint64_t begin, std::size_t count, void* to, const char* item) const
{
    require(begin, count, item);
    constexpr std::size_t most = std::size_t{1} << 30;  // Linux reads no more than 2 GiB at once.
    for (std::size_t done = 0; done < count;) {
        const ssize_t got = pread(descriptor_, static_cast<char*>(to) + done, std::min(most, count - done),
                                  static_cast<off_t>(begin + done));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0)
            throw InputError(path_, got < 0 ? std::strerror(errno) : "it has become shorter while it was read",
                             "a file that can be read");
        done += std::size_t(got);
    }
}

std::vector<std::uint8_t> FileBytes::read(std::uint64_t begin, std::uint64_t count, const char* item) const
{
    require(begin, count, item);
    std::vector<std::uint8_t> bytes(count);
    read(begin, bytes.size(), bytes.data(), item);
    return bytes;
}

}  // namespace aeolic
