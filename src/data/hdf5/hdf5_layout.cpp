#include "data/hdf5/hdf5_layout.h"

#include <fmt/format.h>

#include <algorithm>

namespace aeolic {
namespace {

constexpr char kLayoutItem[] = "an HDF5 layout", kFilters[] = "HDF5 filters";

void parseOldChunks(const Hdf5Store& store, ByteCursor& cursor, std::size_t rank, Hdf5Layout& layout)
{
    const std::size_t dimensions = cursor.u8();
    layout.address = store.address(cursor);
    if (dimensions != rank + 1)
        store.fail(fmt::format("{} has {} dimensions of {}", kLayoutItem, dimensions, rank + 1));
    for (std::size_t i = 0; i < rank; ++i) layout.chunk.push_back(cursor.u32());
}

void parseNewChunks(const Hdf5Store& store, ByteCursor& cursor, std::size_t rank, Hdf5Layout& layout)
{
    const int flags = cursor.u8();
    layout.rawEdges = flags & 1;
    const std::size_t dimensions = cursor.u8(), width = cursor.u8();
    if (dimensions != rank + 1)
        store.fail(fmt::format("{} has {} dimensions of {}", kLayoutItem, dimensions, rank + 1));
    for (std::size_t i = 0; i < rank; ++i) layout.chunk.push_back(cursor.whole(width));
    cursor.skip(width);  // Bytes of an element.
    const int index = cursor.u8();
    if (index < 1 || index > 5) store.fail(fmt::format("{} has the unknown index {}", kLayoutItem, index));
    layout.index = Hdf5Index(index);
    if (layout.index == Hdf5Index::single && (flags & 2)) {
        layout.singleBytes = store.length(cursor);
        layout.singleMask = cursor.u32();
    }
    // What follows stands once more where the index begins.
    constexpr std::size_t known[] = {0, 0, 0, 1, 5, 6};
    cursor.skip(known[index]);
    layout.address = store.address(cursor);
}

}  // namespace

Hdf5Layout parseHdf5Layout(const Hdf5Store& store, std::span<const std::uint8_t> message, std::size_t rank,
                           const std::string& name)
{
    ByteCursor cursor = store.cursor(message, kLayoutItem);
    const int version = cursor.u8();
    if (version != 3 && version != 4)
        store.fail(fmt::format("'{}' is laid out in the form {} of HDF5", name, version),
                   "forms 3 and 4 (h5repack writes them)");
    const int kind = cursor.u8();
    Hdf5Layout layout;
    if (kind == 0) {
        layout.kind = Hdf5Layout::Kind::compact;
        const auto data = cursor.take(cursor.u16());
        layout.compact.assign(data.begin(), data.end());
    } else if (kind == 1) {
        layout.address = store.address(cursor);
        layout.bytes = store.length(cursor);
    } else if (kind == 2) {
        layout.kind = Hdf5Layout::Kind::chunked;
        version == 3 ? parseOldChunks(store, cursor, rank, layout) : parseNewChunks(store, cursor, rank, layout);
        if (std::count(layout.chunk.begin(), layout.chunk.end(), std::uint64_t{0}) > 0)
            store.fail(fmt::format("{} has chunks without elements", kLayoutItem));
    } else {
        store.fail(fmt::format("'{}' is put together of other data sets", name), "data that the file holds itself");
    }
    return layout;
}

std::vector<Hdf5Filter> parseHdf5Filters(const Hdf5Store& store, std::span<const std::uint8_t> message)
{
    ByteCursor cursor = store.cursor(message, kFilters);
    const int version = cursor.u8();
    const std::size_t count = cursor.u8();
    if ((version != 1 && version != 2) || count > 32) store.fail(fmt::format("{} are damaged", kFilters));
    if (version == 1) cursor.skip(6);
    std::vector<Hdf5Filter> filters;
    for (std::size_t i = 0; i < count; ++i) {
        Hdf5Filter filter;
        filter.id = cursor.u16();
        const bool named = version == 1 || filter.id >= 256;
        const std::size_t nameBytes = named ? cursor.u16() : 0;
        cursor.skip(2);
        const std::size_t values = cursor.u16();
        filter.name = cursor.text(nameBytes);
        filter.name.erase(std::min(filter.name.find('\0'), filter.name.size()));
        for (std::size_t k = 0; k < values; ++k) {
            const std::uint32_t value = cursor.u32();
            if (k == 0) filter.size = value;
        }
        if (version == 1 && values % 2 == 1) cursor.skip(4);
        filters.push_back(std::move(filter));
    }
    return filters;
}

}  // namespace aeolic
