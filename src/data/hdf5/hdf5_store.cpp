#include "data/hdf5/hdf5_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace aeolic {
namespace {

constexpr std::array<std::uint8_t, 8> kSign{0x89, 'H', 'D', 'F', '\r', '\n', 0x1a, '\n'};
constexpr char kSuperblock[] = "the HDF5 superblock";

/// At 0, 512, 1024, 2048 …: a program may keep bytes of its own in front.
std::optional<std::uint64_t> signPlace(const FileBytes& file)
{
    for (std::uint64_t at = 0; at + kSign.size() <= file.size(); at = at == 0 ? 512 : 2 * at) {
        const auto bytes = file.read(at, kSign.size(), kSuperblock);
        if (std::equal(kSign.begin(), kSign.end(), bytes.begin())) return at;
    }
    return std::nullopt;
}

}  // namespace

bool isHdf5File(const std::string& path)
{
    return signPlace(FileBytes(path)).has_value();
}

Hdf5Store::Hdf5Store(const std::string& path) : file_(path)
{
    const auto at = signPlace(file_);
    if (!at) fail("it does not begin like an HDF5 file", "an HDF5 file");
    constexpr std::uint64_t most = 128;
    const auto bytes = file_.read(*at, std::min(most, file_.size() - *at), kSuperblock);
    ByteCursor cursor(bytes, this->path(), kSuperblock);
    cursor.skip(kSign.size());
    const int version = cursor.u8();
    if (version > 3) fail(fmt::format("its superblock has the version {}", version), "version 0 to 3");
    if (version < 2) cursor.skip(4);
    addressBytes_ = cursor.u8();
    lengthBytes_ = cursor.u8();
    const auto fits = [](std::size_t width) { return width == 2 || width == 4 || width == 8; };
    if (!fits(addressBytes_) || !fits(lengthBytes_))
        fail(fmt::format("its addresses have {} bytes and its lengths {}", addressBytes_, lengthBytes_), "2, 4 or 8");
    if (addressBytes_ < 8) undefined_ = (std::uint64_t{1} << (8 * addressBytes_)) - 1;
    if (version < 2) cursor.skip(version == 0 ? 9 : 13);  // Widths of trees, and flags.
    if (version >= 2) cursor.skip(1);
    base_ = address(cursor);
    address(cursor);  // Free space, or the superblock's extension: neither says how data are kept.
    const std::uint64_t end = address(cursor);
    if (version < 2) {
        address(cursor);  // What a driver of several files says.
        address(cursor);  // The root's name.
    }
    root_ = address(cursor);
    if (version >= 2) {
        const std::size_t covered = cursor.at();
        if (hdf5Checksum(std::span<const std::uint8_t>(bytes).first(covered)) != cursor.u32())
            fail("its superblock is damaged");
    }
    if (base_ != *at && base_ != 0) fail(fmt::format("its base address is {}", base_), fmt::format("{}", *at));
    base_ = *at;  // Bytes may have been put in front of a file afterwards.
    if (end > file_.size())
        fail(fmt::format("the file is cut off: it holds {} bytes", file_.size()), fmt::format("{}", end));
}

void Hdf5Store::fail(const std::string& found, const std::string& expected) const
{
    throw InputError(path(), found, expected);
}

std::vector<std::uint8_t> Hdf5Store::block(std::uint64_t address, std::uint64_t count, const char* item) const
{
    if (!isDefined(address) || address > fileSize()) fail(fmt::format("{} is not there", item));
    return file_.read(base_ + address, count, item);
}

void Hdf5Store::read(std::uint64_t address, std::size_t count, void* to, const char* item) const
{
    if (!isDefined(address) || address > fileSize()) fail(fmt::format("{} is not there", item));
    file_.read(base_ + address, count, to, item);
}

std::vector<std::uint8_t> Hdf5Store::checkedBlock(std::uint64_t address, std::uint64_t count, const char* item) const
{
    auto bytes = block(address, count, item);
    if (bytes.size() < 4) fail(fmt::format("{} is damaged", item));
    ByteCursor tail(std::span<const std::uint8_t>(bytes).last(4), path(), item);
    bytes.resize(bytes.size() - 4);
    if (hdf5Checksum(bytes) != tail.u32()) fail(fmt::format("{} is damaged: its checksum is wrong", item));
    return bytes;
}

}  // namespace aeolic
