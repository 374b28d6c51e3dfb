#include "data/hdf5/hdf5_links.h"

#include <fmt/format.h>

#include <algorithm>

#include "data/hdf5/hdf5_heap.h"
#include "data/hdf5/hdf5_tree.h"

namespace aeolic {
namespace {

constexpr char kGroupLinks[] = "an HDF5 group's links", kInfo[] = "what an HDF5 group says of its links";

/// "LINK" messages and the objects of a group's heap have this form (section IV.A.2.g).
Hdf5Link parseLink(const Hdf5Store& store, std::span<const std::uint8_t> message)
{
    ByteCursor cursor = store.cursor(message, kGroupLinks);
    if (cursor.u8() != 1) store.fail(fmt::format("{} have an unknown version", kGroupLinks));
    const int flags = cursor.u8(), kind = flags & 8 ? cursor.u8() : 0;
    Hdf5Link link;
    if (flags & 4) link.order = cursor.u64();
    if (flags & 16) cursor.skip(1);
    const std::uint64_t length = cursor.whole(std::size_t{1} << (flags & 3));
    if (length > cursor.left()) store.fail(fmt::format("{} have a name of {} bytes", kGroupLinks, length));
    link.name = cursor.text(length);
    if (kind == 0) {
        link.address = store.address(cursor);
        return link;
    }
    const std::string value = cursor.text(cursor.u16());
    if (kind == 1) {
        link.target = value;
    } else if (const std::size_t end = value.find('\0', 1); kind == 64 && end != std::string::npos) {
        link.file = value.substr(1, end - 1);
        link.target = value.substr(end + 1, value.find('\0', end + 1) - end - 1);
    } else {
        store.fail(fmt::format("the HDF5 link '{}' is of the unknown kind {}", link.name, kind));
    }
    return link;
}

/// A group of the first form: a tree over nodes of names, which stand in a heap of their own (sections III.B to III.D).
std::vector<Hdf5Link> oldLinks(const Hdf5Store& store, std::span<const std::uint8_t> symbolTable)
{
    ByteCursor places = store.cursor(symbolTable, kInfo);
    const std::uint64_t tree = store.address(places), heap = store.address(places);
    const auto head = store.block(heap, 8 + 2 * store.lengthBytes() + store.addressBytes(), kGroupLinks);
    ByteCursor heapCursor = store.cursor(head, kGroupLinks);
    heapCursor.expect("HEAP");
    heapCursor.skip(4);
    const std::uint64_t heapBytes = store.length(heapCursor);
    store.length(heapCursor);
    const auto names = store.block(store.address(heapCursor), heapBytes, kGroupLinks);
    const auto nameAt = [&](std::uint64_t offset) {
        if (offset >= names.size()) store.fail(fmt::format("{} have a name that is not there", kGroupLinks));
        ByteCursor cursor = store.cursor(std::span(names).subspan(offset), kGroupLinks);
        return cursor.textToZero();
    };
    std::vector<Hdf5Link> links;
    std::uint64_t read = 0;
    walkOldHdf5Tree(store, tree, 0, store.lengthBytes(), [&](std::span<const std::uint8_t>, std::uint64_t child) {
        const std::size_t entryBytes = 2 * store.addressBytes() + 24;
        const auto prefix = store.block(child, 8, kGroupLinks);
        ByteCursor cursor = store.cursor(prefix, kGroupLinks);
        cursor.expect("SNOD");
        cursor.skip(2);
        const std::size_t count = cursor.u16();
        read += 8 + count * entryBytes;
        if (read > store.fileSize()) store.fail(fmt::format("{} go on for ever", kGroupLinks));
        const auto entries = store.block(child + 8, count * entryBytes, kGroupLinks);
        ByteCursor entry = store.cursor(entries, kGroupLinks);
        for (std::size_t i = 0; i < count; ++i) {
            Hdf5Link link;
            link.name = nameAt(store.address(entry));
            link.address = store.address(entry);
            const std::uint32_t kind = entry.u32();
            entry.skip(4);
            const std::uint32_t target = entry.u32();
            entry.skip(12);
            if (kind == 2) link.target = nameAt(target);
            links.push_back(std::move(link));
        }
    });
    return links;
}

/// Takes the links of a group that has many: from the heap and the tree over it. `idAt`: where in a record the heap's
/// ID stands.
template <class Take>
void takeFromHeap(const Hdf5Store& store, std::uint64_t heapAddress, std::uint64_t tree, std::size_t idAt,
                  const Take& take)
{
    if (!store.isDefined(heapAddress) || !store.isDefined(tree)) return;
    const Hdf5FractalHeap heap(store, heapAddress);
    walkNewHdf5Tree(store, tree, [&](std::span<const std::uint8_t> record) {
        if (record.size() < idAt + heap.idBytes()) store.fail("an HDF5 tree has records that are too short");
        take(heap.object(record.subspan(idAt, heap.idBytes())));
    });
}

}  // namespace

std::vector<Hdf5Link> readHdf5Links(const Hdf5Store& store, const std::vector<Hdf5Message>& header)
{
    if (const Hdf5Message* table = findMessage(header, Hdf5MessageKind::symbolTable))
        return oldLinks(store, table->data);
    std::vector<Hdf5Link> links;
    for (const Hdf5Message& message : header)
        if (message.kind == int(Hdf5MessageKind::link)) links.push_back(parseLink(store, message.data));
    bool ordered = false;
    if (const Hdf5Message* info = findMessage(header, Hdf5MessageKind::linkInfo)) {
        ByteCursor cursor = store.cursor(info->data, kInfo);
        cursor.skip(1);
        ordered = cursor.u8() & 1;
        if (ordered) cursor.skip(8);
        const std::uint64_t heap = store.address(cursor), tree = store.address(cursor);
        takeFromHeap(store, heap, tree, 4,
                     [&](const std::vector<std::uint8_t>& link) { links.push_back(parseLink(store, link)); });
    }
    std::stable_sort(links.begin(), links.end(), [&](const Hdf5Link& a, const Hdf5Link& b) {
        return ordered ? a.order < b.order : a.name < b.name;
    });
    return links;
}

std::vector<std::vector<std::uint8_t>> readHdf5Attributes(const Hdf5Store& store,
                                                          const std::vector<Hdf5Message>& header)
{
    std::vector<std::vector<std::uint8_t>> attributes;
    for (const Hdf5Message& message : header)
        if (message.kind == int(Hdf5MessageKind::attribute)) attributes.push_back(message.data);
    if (const Hdf5Message* info = findMessage(header, Hdf5MessageKind::attributeInfo)) {
        ByteCursor cursor = store.cursor(info->data, "what an HDF5 object says of its attributes");
        cursor.skip(1);
        if (cursor.u8() & 1) cursor.skip(2);
        const std::uint64_t heap = store.address(cursor), tree = store.address(cursor);
        takeFromHeap(store, heap, tree, 0,
                     [&](const std::vector<std::uint8_t>& attribute) { attributes.push_back(attribute); });
    }
    return attributes;
}

}  // namespace aeolic
