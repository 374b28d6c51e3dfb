#include "data/hdf5/hdf5_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <vector>

namespace aeolic {
namespace {

constexpr char kOld[] = "an HDF5 tree", kNew[] = "an HDF5 tree of version 2";

class OldTree {
public:
    OldTree(const Hdf5Store& store, int kind, std::size_t keyBytes, const Hdf5OldLeaf& leaf)
        : store_(store), kind_(kind), keyBytes_(keyBytes), leaf_(leaf)
    {
    }

    /// `level`: what the node must have; the root has any.
    void walk(std::uint64_t address, int level)
    {
        const std::size_t prefix = 8 + 2 * store_.addressBytes();
        const auto head = store_.block(address, prefix, kOld);
        ByteCursor cursor = store_.cursor(head, kOld);
        cursor.expect("TREE");
        const int kind = cursor.u8(), found = cursor.u8();
        const std::size_t entries = cursor.u16();
        if (kind != kind_ || (level >= 0 && found != level)) store_.fail(fmt::format("{} is damaged", kOld));
        // A node is read once. So no more than the file's bytes are read in all, however nodes refer to each other.
        const std::uint64_t bytes = entries * (keyBytes_ + store_.addressBytes());
        read_ += prefix + bytes;
        if (read_ > store_.fileSize()) store_.fail(fmt::format("{} goes on for ever", kOld));
        const auto all = store_.block(address + prefix, bytes, kOld);
        ByteCursor body = store_.cursor(all, kOld);
        for (std::size_t i = 0; i < entries; ++i) {
            const auto key = body.take(keyBytes_);
            const std::uint64_t child = store_.address(body);
            if (found > 0)
                walk(child, found - 1);
            else
                leaf_(key, child);
        }
    }

private:
    const Hdf5Store& store_;
    int kind_;
    std::size_t keyBytes_;
    const Hdf5OldLeaf& leaf_;
    std::uint64_t read_ = 0;
};

class NewTree {
public:
    NewTree(const Hdf5Store& store, const Hdf5Record& take) : store_(store), take_(take) {}

    void walk(std::uint64_t address)
    {
        const std::size_t bytes = 22 + store_.addressBytes() + store_.lengthBytes();
        const auto head = store_.checkedBlock(address, bytes, kNew);
        ByteCursor cursor = store_.cursor(head, kNew);
        cursor.expect("BTHD");
        cursor.skip(2);
        nodeBytes_ = cursor.u32();
        recordBytes_ = cursor.u16();
        const std::size_t depth = cursor.u16();
        cursor.skip(2);
        const std::uint64_t root = store_.address(cursor), records = cursor.u16();
        if (recordBytes_ == 0 || nodeBytes_ < kPrefix + recordBytes_ || depth > 16)
            store_.fail(fmt::format("{} is damaged", kNew));
        // How many records fit into nodes of each level says how wide the counts in the level above are.
        std::uint64_t fit = (nodeBytes_ - kPrefix) / recordBytes_, below = fit;
        countBytes_ = bytesFor(fit);
        totalBytes_ = {0};
        for (std::size_t level = 1; level <= depth; ++level) {
            const std::size_t pointer = store_.addressBytes() + countBytes_ + totalBytes_[level - 1];
            fit = (nodeBytes_ - std::min<std::uint64_t>(nodeBytes_, kPrefix + pointer)) / (recordBytes_ + pointer);
            below = (fit + 1) * below + fit;
            totalBytes_.push_back(bytesFor(below));
        }
        if (records > 0) node(root, records, depth);
    }

private:
    static constexpr std::size_t kPrefix = 10;  // Sign, version, type and checksum.

    void node(std::uint64_t address, std::uint64_t records, std::size_t level)
    {
        const std::size_t pointer = store_.addressBytes() + countBytes_ + (level > 0 ? totalBytes_[level - 1] : 0);
        const std::uint64_t bytes = kPrefix + records * recordBytes_ + (level > 0 ? (records + 1) * pointer : 0);
        read_ += bytes;
        if (read_ > store_.fileSize()) store_.fail(fmt::format("{} goes on for ever", kNew));
        const auto all = store_.checkedBlock(address, bytes, kNew);
        ByteCursor cursor = store_.cursor(all, kNew);
        cursor.expect(level > 0 ? "BTIN" : "BTLF");
        cursor.skip(2);
        std::vector<std::span<const std::uint8_t>> own;
        for (std::uint64_t i = 0; i < records; ++i) own.push_back(cursor.take(recordBytes_));
        for (std::uint64_t i = 0; i <= records; ++i) {
            if (level > 0) {
                const std::uint64_t child = store_.address(cursor), count = cursor.whole(countBytes_);
                if (totalBytes_[level - 1] > 0) cursor.skip(totalBytes_[level - 1]);
                node(child, count, level - 1);
            }
            if (i < records) take_(own[i]);
        }
    }

    const Hdf5Store& store_;
    const Hdf5Record& take_;
    std::uint64_t nodeBytes_ = 0, read_ = 0;
    std::size_t recordBytes_ = 0, countBytes_ = 0;
    std::vector<std::size_t> totalBytes_;  // Of each level: how wide the number of all records below it is.
};

}  // namespace

void walkOldHdf5Tree(const Hdf5Store& store, std::uint64_t address, int kind, std::size_t keyBytes,
                     const Hdf5OldLeaf& leaf)
{
    OldTree(store, kind, keyBytes, leaf).walk(address, -1);
}

void walkNewHdf5Tree(const Hdf5Store& store, std::uint64_t address, const Hdf5Record& take)
{
    NewTree(store, take).walk(address);
}

}  // namespace aeolic
