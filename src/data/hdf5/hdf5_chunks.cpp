#include "data/hdf5/hdf5_chunks.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "data/hdf5/hdf5_tree.h"

namespace aeolic {
namespace {

constexpr char kChunkIndex[] = "an HDF5 index of chunks";

class ChunkFinder {
public:
    ChunkFinder(const Hdf5Store& store, const Hdf5Layout& layout, const Hdf5Space& space, std::uint32_t elementBytes,
                bool filtered, const std::string& name)
        : store_(store), layout_(layout), space_(space), filtered_(filtered), name_(name), chunkBytes_(elementBytes)
    {
        for (std::size_t i = 0; i < rank(); ++i) {
            const std::uint64_t size = layout.chunk[i], length = space.shape[i], most = std::max(space.most[i], length);
            if (size > (std::uint64_t{1} << 40) / chunkBytes_)
                store.fail(fmt::format("'{}' has chunks of too many elements", name));
            chunkBytes_ *= size;
            across_.push_back(length / size + (length % size > 0));
            mostAcross_.push_back(most / size + (most % size > 0));
            count_ *= across_.back();  // Not more than there are elements.
        }
    }

    std::vector<Hdf5Chunk> find()
    {
        if (!store_.isDefined(layout_.address) || count_ == 0) return {};
        switch (layout_.index) {
            case Hdf5Index::oldTree:
                walkOldHdf5Tree(store_, layout_.address, 1, 8 * (rank() + 2),
                                [&](std::span<const std::uint8_t> key, std::uint64_t child) { takeOld(key, child); });
                break;
            case Hdf5Index::single:
                add(std::vector<std::uint64_t>(rank(), 0), layout_.address,
                    filtered_ ? layout_.singleBytes : chunkBytes_, layout_.singleMask);
                break;
            case Hdf5Index::implicit:
                takeImplicit();
                break;
            case Hdf5Index::fixedArray:
                walkHdf5FixedArray(store_, layout_.address, [&](std::uint64_t index, auto entry) {
                    takeEntry(placeOf(index, rank()), entry, 0);
                });
                break;
            case Hdf5Index::extensibleArray: {
                const std::size_t grows = growing();
                walkHdf5ExtensibleArray(
                    store_, layout_.address, mostIndex(grows),
                    [&](std::uint64_t index, auto entry) { takeEntry(placeOf(index, grows), entry, 0); });
                break;
            }
            case Hdf5Index::newTree:
                walkNewHdf5Tree(store_, layout_.address, [&](auto record) { takeRecord(record); });
                break;
        }
        return std::move(chunks_);
    }

private:
    std::size_t rank() const { return layout_.chunk.size(); }

    void takeOld(std::span<const std::uint8_t> key, std::uint64_t child)
    {
        ByteCursor cursor = store_.cursor(key, kChunkIndex);
        const std::uint64_t bytes = cursor.u32();
        const std::uint32_t skipped = cursor.u32();
        std::vector<std::uint64_t> first;
        for (std::size_t i = 0; i < rank(); ++i) {
            first.push_back(cursor.u64());
            if (first[i] % layout_.chunk[i] != 0)
                store_.fail(fmt::format("'{}' has a chunk between two others", name_));
        }
        add(std::move(first), child, bytes, skipped);
    }

    void takeImplicit()
    {
        requireStored(count_);
        for (std::uint64_t index = 0; index < count_; ++index) {
            std::vector<std::uint64_t> first(rank());
            std::uint64_t rest = index, place = 0, width = 1;
            for (std::size_t i = rank(); i-- > 0; rest /= across_[i]) first[i] = rest % across_[i];
            for (std::size_t i = rank(); i-- > 0; width *= mostAcross_[i]) place += first[i] * width;
            for (std::size_t i = 0; i < rank(); ++i) first[i] *= layout_.chunk[i];
            add(std::move(first), layout_.address + place * chunkBytes_, chunkBytes_, 0);
        }
    }

    /// A chunk's address and, where there are filters, its size and mask; behind them `behind` bytes more.
    void takeEntry(std::vector<std::uint64_t> first, std::span<const std::uint8_t> entry, std::size_t behind)
    {
        ByteCursor cursor = store_.cursor(entry, kChunkIndex);
        const std::uint64_t address = store_.address(cursor);
        if (!store_.isDefined(address)) return;
        std::uint64_t bytes = chunkBytes_;
        std::uint32_t skipped = 0;
        if (filtered_) {
            if (cursor.left() < behind + 5) store_.fail(fmt::format("{} is damaged", kChunkIndex));
            bytes = cursor.whole(cursor.left() - behind - 4);
            skipped = cursor.u32();
        }
        add(std::move(first), address, bytes, skipped);
    }

    void takeRecord(std::span<const std::uint8_t> record)
    {
        const std::size_t behind = 8 * rank();
        if (record.size() < behind) store_.fail(fmt::format("{} is damaged", kChunkIndex));
        const auto tail = record.last(behind);
        ByteCursor cursor = store_.cursor(tail, kChunkIndex);
        std::vector<std::uint64_t> first;
        for (std::size_t i = 0; i < rank(); ++i) {
            const std::uint64_t place = cursor.u64();
            first.push_back(place < across_[i] ? place * layout_.chunk[i] : ~std::uint64_t{0});
        }
        takeEntry(std::move(first), record, behind);
    }

    /// Which dimension may grow without limit: an array's index runs over it slowest.
    std::size_t growing() const
    {
        const auto found = std::find(space_.most.begin(), space_.most.end(), ~std::uint64_t{0});
        if (found == space_.most.end()) store_.fail(fmt::format("'{}' cannot grow, but its index can", name_));
        return std::size_t(found - space_.most.begin());
    }

    /// An index counts the chunks that there may be, not those that there are.
    std::uint64_t mostIndex(std::size_t grows) const
    {
        std::uint64_t count = across_[grows];
        for (std::size_t i = 0; i < rank(); ++i) {
            if (i == grows) continue;
            if (mostAcross_[i] > (std::uint64_t{1} << 40) / std::max<std::uint64_t>(count, 1))
                store_.fail(fmt::format("'{}' may have too many chunks", name_));
            count *= mostAcross_[i];
        }
        return count;
    }

    std::vector<std::uint64_t> placeOf(std::uint64_t index, std::size_t slowest) const
    {
        std::vector<std::uint64_t> first(rank());
        for (std::size_t i = rank(); i-- > 0;) {
            if (i == slowest) continue;
            first[i] = index % mostAcross_[i];
            index /= mostAcross_[i];
        }
        if (slowest < rank()) first[slowest] = index;
        for (std::size_t i = 0; i < rank(); ++i)
            first[i] = first[i] < across_[i] ? first[i] * layout_.chunk[i] : ~std::uint64_t{0};
        return first;
    }

    void requireStored(std::uint64_t count) const
    {
        if (count > store_.fileSize())
            store_.fail(fmt::format("'{}' has {} chunks, and the file {} bytes", name_, count, store_.fileSize()));
    }

    void add(std::vector<std::uint64_t> first, std::uint64_t address, std::uint64_t bytes, std::uint32_t skipped)
    {
        for (std::size_t i = 0; i < rank(); ++i)
            if (first[i] >= space_.shape[i]) return;  // It has become smaller since.
        if (chunks_.size() >= count_ || !seen_.insert(first).second)
            store_.fail(fmt::format("'{}' has a chunk more than once", name_));
        if (!filtered_ && bytes != chunkBytes_)
            store_.fail(fmt::format("a chunk of '{}' has {} bytes", name_, bytes), fmt::format("{}", chunkBytes_));
        chunks_.push_back({std::move(first), address, bytes, skipped});
    }

    const Hdf5Store& store_;
    const Hdf5Layout& layout_;
    const Hdf5Space& space_;
    bool filtered_;
    const std::string& name_;
    std::uint64_t chunkBytes_, count_ = 1;
    std::vector<std::uint64_t> across_, mostAcross_;  // Chunks in each dimension: now, and at most.
    std::vector<Hdf5Chunk> chunks_;
    std::set<std::vector<std::uint64_t>> seen_;
};

}  // namespace

std::vector<Hdf5Chunk> findHdf5Chunks(const Hdf5Store& store, const Hdf5Layout& layout, const Hdf5Space& space,
                                      std::uint32_t elementBytes, bool filtered, const std::string& name)
{
    return ChunkFinder(store, layout, space, elementBytes, filtered, name).find();
}

}  // namespace aeolic
