#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace aeolic {

/// The bytes of a file, read at any place. Several threads may read at the same time. Every failure is an InputError
/// that begins with the file's name.
class FileBytes {
public:
    explicit FileBytes(const std::string& path);
    ~FileBytes();
    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;

    const std::string& path() const { return path_; }
    std::uint64_t size() const { return size_; }  ///< When it was opened.

    /// Throws unless the file has `count` bytes from `begin` on. `item`: names the item that is read, for the message.
    void require(std::uint64_t begin, std::uint64_t count, const char* item) const;

    void read(std::uint64_t begin, std::size_t count, void* to, const char* item) const;
    std::vector<std::uint8_t> read(std::uint64_t begin, std::uint64_t count, const char* item) const;

private:
    std::string path_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

}  // namespace aeolic
