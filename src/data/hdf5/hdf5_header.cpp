#include "data/hdf5/hdf5_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace aeolic {
namespace {

constexpr char kObjectHeader[] = "an HDF5 object's header";
constexpr int kShared = 2;                         // A message's flag: it stands elsewhere.
constexpr std::uint64_t kMostBytes = 64ULL << 20;  // Of one object's header.
constexpr int kMostShared = 16;                    // Messages of a header that stand elsewhere; few have more than one.

/// Reads the blocks of one header.
class HeaderReader {
public:
    HeaderReader(const Hdf5Store& store, bool follow) : store_(store), follow_(follow) {}

    std::vector<Hdf5Message> read(std::uint64_t address)
    {
        const auto begin = store_.block(address, 4, kObjectHeader);
        if (std::equal(begin.begin(), begin.end(), "OHDR"))
            readNew(address);
        else if (begin[0] == 1)
            readOld(address);
        else
            store_.fail(fmt::format("{} at {} has no known form", kObjectHeader, address));
        return std::move(messages_);
    }

private:
    struct Place {
        std::uint64_t address, bytes;
    };

    void readOld(std::uint64_t address)
    {
        const auto prefix = store_.block(address, 16, kObjectHeader);
        ByteCursor cursor = store_.cursor(prefix, kObjectHeader);
        cursor.skip(2);
        left_ = cursor.u16();
        cursor.skip(4);
        rest_.push_back({address + 16, cursor.u32()});
        for (std::size_t i = 0; i < rest_.size(); ++i) {
            enter(rest_[i]);
            const auto bytes = store_.block(rest_[i].address, rest_[i].bytes, kObjectHeader);
            ByteCursor messages = store_.cursor(bytes, kObjectHeader);
            while (left_ > 0 && messages.left() >= 8) {
                const int kind = messages.u16();
                const std::size_t size = messages.u16();
                const int flags = messages.u8();
                messages.skip(3);
                take(kind, flags, messages.take(size));
                --left_;
            }
        }
    }

    void readNew(std::uint64_t address)
    {
        constexpr std::uint64_t most = 4 + 2 + 16 + 4 + 8;
        const auto prefix = store_.block(
            address, std::min(most, store_.fileSize() - std::min(store_.fileSize(), address)), kObjectHeader);
        ByteCursor cursor = store_.cursor(prefix, kObjectHeader);
        cursor.skip(4);
        if (cursor.u8() != 2) store_.fail(fmt::format("{} has an unknown version", kObjectHeader));
        const int flags = cursor.u8();
        orderBytes_ = flags & 4 ? 2 : 0;
        if (flags & 0x20) cursor.skip(16);  // Times.
        if (flags & 0x10) cursor.skip(4);
        const std::uint64_t size = cursor.whole(std::size_t{1} << (flags & 3));
        if (size > store_.fileSize()) store_.fail(fmt::format("{} has {} bytes", kObjectHeader, size));
        readNewBlock({address, cursor.at() + size + 4}, cursor.at());
        for (std::size_t i = 0; i < rest_.size(); ++i) {
            const auto sign = store_.block(rest_[i].address, 4, kObjectHeader);
            if (!std::equal(sign.begin(), sign.end(), "OCHK"))
                store_.fail(fmt::format("{} goes on where there is none", kObjectHeader));
            readNewBlock(rest_[i], 4);
        }
    }

    void readNewBlock(const Place& place, std::size_t prefix)
    {
        enter(place);
        const auto bytes = store_.checkedBlock(place.address, place.bytes, kObjectHeader);
        ByteCursor messages = store_.cursor(bytes, kObjectHeader);
        messages.skip(prefix);
        while (messages.left() >= 4 + orderBytes_) {
            const int kind = messages.u8();
            const std::size_t size = messages.u16();
            const int flags = messages.u8();
            messages.skip(orderBytes_);
            take(kind, flags, messages.take(size));
        }
    }

    /// A block may come once.
    void enter(const Place& place)
    {
        bytes_ += place.bytes;
        if (!seen_.insert(place.address).second || place.bytes > kMostBytes || bytes_ > kMostBytes)
            store_.fail(fmt::format("{} goes on for ever", kObjectHeader));
    }

    void take(int kind, int flags, std::span<const std::uint8_t> data)
    {
        if (kind == int(Hdf5MessageKind::continuation)) {
            ByteCursor cursor = store_.cursor(data, kObjectHeader);
            const std::uint64_t address = store_.address(cursor);
            rest_.push_back({address, store_.length(cursor)});
        } else if ((flags & kShared) && follow_) {
            // Each costs the reading of a whole other header.
            if (++shared_ > kMostShared)
                store_.fail(fmt::format("{} has too many messages that stand elsewhere", kObjectHeader),
                            fmt::format("{} at most", kMostShared));
            messages_.push_back(sharedHdf5Message(store_, kind, data));
        } else if (!(flags & kShared)) {
            messages_.push_back({kind, {data.begin(), data.end()}});
        }
    }

    const Hdf5Store& store_;
    bool follow_;
    std::vector<Hdf5Message> messages_;
    std::vector<Place> rest_;
    std::set<std::uint64_t> seen_;
    std::uint64_t bytes_ = 0;
    int left_ = 0, shared_ = 0;
    std::size_t orderBytes_ = 0;
};

}  // namespace

std::vector<Hdf5Message> readHdf5Header(const Hdf5Store& store, std::uint64_t address)
{
    return HeaderReader(store, true).read(address);
}

const Hdf5Message* findMessage(const std::vector<Hdf5Message>& messages, Hdf5MessageKind kind)
{
    for (const Hdf5Message& message : messages)
        if (message.kind == int(kind)) return &message;
    return nullptr;
}

Hdf5Message sharedHdf5Message(const Hdf5Store& store, int kind, std::span<const std::uint8_t> reference)
{
    ByteCursor cursor = store.cursor(reference, "an HDF5 message that stands elsewhere");
    const int version = cursor.u8(), type = cursor.u8();
    if (version < 1 || version > 3 || (version == 3 && type != 2))
        store.fail("it keeps HDF5 messages in a table of their own", "a file without shared object header messages");
    if (version == 1) cursor.skip(6);
    for (Hdf5Message& message : HeaderReader(store, false).read(store.address(cursor)))
        if (message.kind == kind) return std::move(message);
    store.fail("an HDF5 message that stands elsewhere is not there");
}

}  // namespace aeolic
