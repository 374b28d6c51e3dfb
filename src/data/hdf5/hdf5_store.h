#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "data/binary/byte_cursor.h"
#include "data/binary/file_bytes.h"

namespace aeolic {

/// The bytes of the narrowest number that can hold a value.
inline std::size_t bytesFor(std::uint64_t value)
{
    return value == 0 ? 1 : std::size_t((std::bit_width(value) - 1) / 8 + 1);
}

/// The bytes of an HDF5 file, how wide its addresses and lengths are, and where its root is. The sections of [hdf5]
/// that comments name are those of "HDF5 File Format Specification", version 3.0. Throws InputError, which begins with
/// the file's name.
class Hdf5Store {
public:
    /// Reads the superblock (section II).
    explicit Hdf5Store(const std::string& path);

    const std::string& path() const { return file_.path(); }
    std::uint64_t fileSize() const { return file_.size(); }
    std::uint64_t rootAddress() const { return root_; }
    std::size_t addressBytes() const { return addressBytes_; }
    std::size_t lengthBytes() const { return lengthBytes_; }

    /// An address that stands for "nothing there" has all bits set.
    bool isDefined(std::uint64_t address) const { return address != undefined_; }

    std::uint64_t address(ByteCursor& cursor) const { return cursor.whole(addressBytes_); }
    std::uint64_t length(ByteCursor& cursor) const { return cursor.whole(lengthBytes_); }

    /// Bytes at an address of the file. `item`: what they are, for the message.
    std::vector<std::uint8_t> block(std::uint64_t address, std::uint64_t count, const char* item) const;
    void read(std::uint64_t address, std::size_t count, void* to, const char* item) const;

    /// A block whose last four bytes are the checksum of those before them. Throws where they are not.
    std::vector<std::uint8_t> checkedBlock(std::uint64_t address, std::uint64_t count, const char* item) const;

    ByteCursor cursor(std::span<const std::uint8_t> bytes, const char* item) const
    {
        return {bytes, file_.path(), item};
    }

    [[noreturn]] void fail(const std::string& found, const std::string& expected = "a complete, undamaged file") const;

private:
    FileBytes file_;
    std::uint64_t base_ = 0, root_ = 0, undefined_ = ~std::uint64_t{0};
    std::size_t addressBytes_ = 8, lengthBytes_ = 8;
};

/// Jenkins' lookup3, by which HDF5 guards its newer structures.
std::uint32_t hdf5Checksum(std::span<const std::uint8_t> bytes);

/// Whether the file begins, at one of the places where it may, like an HDF5 file.
bool isHdf5File(const std::string& path);

}  // namespace aeolic
