#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "data/hdf5/hdf5_chunks.h"

namespace aeolic {
namespace {

constexpr char kFixed[] = "an HDF5 fixed array", kExtensible[] = "an HDF5 extensible array";

std::uint64_t divideUp(std::uint64_t a, std::uint64_t b)
{
    return a / b + (a % b > 0);
}

/// Bits from the highest of the first byte on.
bool bitAt(std::span<const std::uint8_t> bits, std::uint64_t i)
{
    return bits[i / 8] >> (7 - i % 8) & 1;
}

/// The blocks of one array. A sound one has each block once, so no more than the file's bytes are read in all, however
/// blocks refer to each other.
class ArrayBlocks {
public:
    ArrayBlocks(const Hdf5Store& store, const char* item) : store_(store), item_(item) {}

    std::vector<std::uint8_t> read(std::uint64_t address, std::uint64_t count)
    {
        auto bytes = store_.checkedBlock(address, count, item_);
        read_ += count;
        if (read_ > store_.fileSize()) store_.fail(fmt::format("{} goes on for ever", item_));
        return bytes;
    }

private:
    const Hdf5Store& store_;
    const char* item_;
    std::uint64_t read_ = 0;
};

/// Entries one after the other in a block that begins with a prefix and ends with a checksum.
void takeEntries(std::span<const std::uint8_t> bytes, std::uint64_t first, std::uint64_t count, std::size_t entryBytes,
                 const Hdf5ArrayEntry& take)
{
    for (std::uint64_t i = 0; i < count; ++i) take(first + i, bytes.subspan(i * entryBytes, entryBytes));
}

/// Blocks of many entries are cut into pages, each with a checksum of its own. Pages that were never written are not
/// there to be read.
void takePages(ArrayBlocks& blocks, std::uint64_t address, std::uint64_t first, std::uint64_t count,
               std::uint64_t pageEntries, std::size_t entryBytes, std::span<const std::uint8_t> written,
               const Hdf5ArrayEntry& take)
{
    for (std::uint64_t page = 0; page * pageEntries < count; ++page) {
        const std::uint64_t entries = std::min(pageEntries, count - page * pageEntries);
        if (bitAt(written, page))
            takeEntries(blocks.read(address + page * (pageEntries * entryBytes + 4), entries * entryBytes + 4),
                        first + page * pageEntries, entries, entryBytes, take);
    }
}

/// Blocks of 2^k entries for growing k (section VII.C).
class ExtensibleArray {
public:
    ExtensibleArray(const Hdf5Store& store, std::uint64_t wanted, const Hdf5ArrayEntry& take)
        : store_(store), wanted_(wanted), take_(take), blocks_(store, kExtensible)
    {
    }

    void walk(std::uint64_t address)
    {
        const auto head = blocks_.read(address, 16 + 6 * store_.lengthBytes() + store_.addressBytes());
        ByteCursor cursor = store_.cursor(head, kExtensible);
        cursor.expect("EAHD");
        cursor.skip(2);
        entryBytes_ = cursor.u8();
        const std::size_t indexBits = cursor.u8();
        const std::uint64_t inIndex = cursor.u8();
        leastEntries_ = cursor.u8();
        const std::size_t leastPointers = cursor.u8(), pageBits = cursor.u8();
        cursor.skip(6 * store_.lengthBytes());
        const std::uint64_t index = store_.address(cursor);
        if (!std::has_single_bit(leastEntries_) || !std::has_single_bit(leastPointers) || entryBytes_ == 0 ||
            indexBits > 64 || pageBits > 32 || indexBits < std::size_t(std::countr_zero(leastEntries_)))
            store_.fail(fmt::format("{} is damaged", kExtensible));
        if (!store_.isDefined(index)) return;
        pageEntries_ = std::uint64_t{1} << pageBits;
        offsetBytes_ = (indexBits + 7) / 8;
        const std::size_t levels = 1 + indexBits - std::size_t(std::countr_zero(leastEntries_)),
                          direct = 2 * std::size_t(std::countr_zero(leastPointers)),
                          directBlocks = 2 * (leastPointers - 1);
        const std::size_t secondary = levels > direct ? levels - direct : 0;
        const std::size_t prefix = 6 + store_.addressBytes();
        const auto all = blocks_.read(
            index, prefix + inIndex * entryBytes_ + (directBlocks + secondary) * store_.addressBytes() + 4);
        ByteCursor body = store_.cursor(all, kExtensible);
        body.expect("EAIB");
        body.skip(prefix - 4);
        takeEntries(body.take(inIndex * entryBytes_), 0, std::min(inIndex, wanted_), entryBytes_, take_);
        std::uint64_t first = inIndex;
        for (std::size_t level = 0; level < levels && first < wanted_; ++level) {
            const std::uint64_t blocks = std::uint64_t{1} << (level / 2), entries = leastEntries_ << ((level + 1) / 2);
            if (level < direct) {
                for (std::uint64_t i = 0; i < blocks; ++i, first += entries)
                    dataBlock(store_.address(body), first, entries, {});
            } else {
                secondaryBlock(store_.address(body), first, blocks, entries);
                first += blocks * entries;
            }
        }
    }

private:
    void secondaryBlock(std::uint64_t address, std::uint64_t first, std::uint64_t blocks, std::uint64_t entries)
    {
        if (!store_.isDefined(address)) return;
        const std::size_t prefix = 6 + store_.addressBytes() + offsetBytes_;
        const std::uint64_t bitBytes = entries > pageEntries_ ? divideUp(entries / pageEntries_, 8) : 0;
        const auto all = blocks_.read(address, prefix + blocks * (bitBytes + store_.addressBytes()) + 4);
        ByteCursor cursor = store_.cursor(all, kExtensible);
        cursor.expect("EASB");
        cursor.skip(prefix - 4);
        const auto bits = cursor.take(blocks * bitBytes);
        for (std::uint64_t i = 0; i < blocks && first < wanted_; ++i, first += entries)
            dataBlock(store_.address(cursor), first, entries, bits.subspan(i * bitBytes, bitBytes));
    }

    void dataBlock(std::uint64_t address, std::uint64_t first, std::uint64_t entries,
                   std::span<const std::uint8_t> written)
    {
        if (!store_.isDefined(address) || first >= wanted_) return;
        const std::size_t prefix = 6 + store_.addressBytes() + offsetBytes_;
        const std::uint64_t shown = std::min(entries, wanted_ - first);
        if (entries > pageEntries_) {
            if (written.empty()) store_.fail(fmt::format("{} is damaged", kExtensible));
            blocks_.read(address, prefix + 4);
            takePages(blocks_, address + prefix + 4, first, entries, pageEntries_, entryBytes_, written,
                      [&](std::uint64_t i, auto entry) {
                          if (i < wanted_) take_(i, entry);
                      });
            return;
        }
        const auto all = blocks_.read(address, prefix + entries * entryBytes_ + 4);
        ByteCursor cursor = store_.cursor(all, kExtensible);
        cursor.expect("EADB");
        cursor.skip(prefix - 4);
        takeEntries(std::span(all).subspan(prefix), first, shown, entryBytes_, take_);
    }

    const Hdf5Store& store_;
    std::uint64_t wanted_;
    const Hdf5ArrayEntry& take_;
    ArrayBlocks blocks_;
    std::size_t entryBytes_ = 0, offsetBytes_ = 0;
    std::uint64_t leastEntries_ = 1, pageEntries_ = 1;
};

}  // namespace

void walkHdf5FixedArray(const Hdf5Store& store, std::uint64_t address, const Hdf5ArrayEntry& take)
{
    ArrayBlocks blocks(store, kFixed);
    const auto head = blocks.read(address, 12 + store.lengthBytes() + store.addressBytes());
    ByteCursor cursor = store.cursor(head, kFixed);
    cursor.expect("FAHD");
    cursor.skip(2);
    const std::size_t entryBytes = cursor.u8(), pageBits = cursor.u8();
    const std::uint64_t entries = store.length(cursor), data = store.address(cursor);
    if (entryBytes == 0 || pageBits > 32 || entries > store.fileSize())
        store.fail(fmt::format("{} is damaged", kFixed));
    if (!store.isDefined(data)) return;
    const std::uint64_t pageEntries = std::uint64_t{1} << pageBits;
    const std::size_t prefix = 6 + store.addressBytes();
    if (entries > pageEntries) {
        const std::uint64_t bits = divideUp(divideUp(entries, pageEntries), 8);
        const auto all = blocks.read(data, prefix + bits + 4);
        takePages(blocks, data + prefix + bits + 4, 0, entries, pageEntries, entryBytes, std::span(all).subspan(prefix),
                  take);
        return;
    }
    const auto all = blocks.read(data, prefix + entries * entryBytes + 4);
    ByteCursor body = store.cursor(all, kFixed);
    body.expect("FADB");
    takeEntries(std::span(all).subspan(prefix), 0, entries, entryBytes, take);
}

void walkHdf5ExtensibleArray(const Hdf5Store& store, std::uint64_t address, std::uint64_t count,
                             const Hdf5ArrayEntry& take)
{
    ExtensibleArray(store, count, take).walk(address);
}

}  // namespace aeolic
