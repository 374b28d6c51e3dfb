#include "data/hdf5/hdf5_dataset.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <thread>

#include "base/memory.h"
#include "base/parallel.h"

namespace aeolic {
namespace {

constexpr std::uint64_t kUnwritten = 64ULL << 20;  // Bytes of what the file does not hold, and may be asked for.

std::vector<std::uint8_t> parseFill(const Hdf5Store& store, std::span<const std::uint8_t> message)
{
    ByteCursor cursor = store.cursor(message, "an HDF5 fill value");
    const int version = cursor.u8();
    bool defined = false;
    if (version == 3) {
        defined = cursor.u8() & 0x20;
    } else {
        cursor.skip(2);
        defined = cursor.u8() == 1;
    }
    if (!defined || cursor.left() < 4) return {};
    const auto data = cursor.take(cursor.u32());
    return {data.begin(), data.end()};
}

}  // namespace

Hdf5DataSet::Hdf5DataSet(const Hdf5Store& store, const std::vector<Hdf5Message>& header, const std::string& name)
    : store_(store), name_(name)
{
    const auto get = [&](Hdf5MessageKind kind) {
        const Hdf5Message* message = findMessage(header, kind);
        if (!message) store.fail(fmt::format("'{}' has no HDF5 type, shape or layout", name));
        return std::span<const std::uint8_t>(message->data);
    };
    type_ = parseHdf5Type(store, get(Hdf5MessageKind::datatype));
    space_ = parseHdf5Space(store, get(Hdf5MessageKind::dataspace));
    if (findMessage(header, Hdf5MessageKind::externalFiles))
        store.fail(fmt::format("'{}' has its values in another file", name), "a file that holds its values itself");
    layout_ = parseHdf5Layout(store, get(Hdf5MessageKind::layout), space_.shape.size(), name);
    if (const Hdf5Message* filters = findMessage(header, Hdf5MessageKind::filters))
        filters_ = parseHdf5Filters(store, filters->data);
    if (const Hdf5Message* fill = findMessage(header, Hdf5MessageKind::fillValue)) {
        fill_ = parseFill(store, fill->data);
        if (fill_.size() != type_.bytes) fill_.clear();
    }
}

template <class Number>
std::vector<Number> Hdf5DataSet::read(const Slab& slab) const
{
    if (type_.kind != Hdf5Type::Kind::number)
        store_.fail(fmt::format("'{}' has elements of the kind {}", name_, type_.name),
                    "whole numbers or IEEE floating-point numbers");
    require(slab);
    const std::uint64_t count = space_.none ? 0 : productOf(slab.count);
    if (count == 0) return {};
    const std::vector<Hdf5Chunk> chunks = chunksIn(slab);
    requireStored(count, chunks, sizeof(Number));
    Number fill{};
    if (!fill_.empty()) convertNumbers<Number>(fill_.data(), type_.number, type_.swapped, {&fill, 1});
    std::vector<Number> values(count, fill);
    readInto(slab, chunks, [&](std::uint64_t at, std::uint64_t n, const std::uint8_t* bytes) {
        convertNumbers<Number>(bytes, type_.number, type_.swapped, {values.data() + at, n});
    });
    return values;
}

std::vector<std::uint8_t> Hdf5DataSet::bytes() const
{
    const Slab all = wholeSlab(space_.shape);
    const std::uint64_t count = space_.count();
    if (count == 0) return {};
    const std::vector<Hdf5Chunk> chunks = chunksIn(all);
    requireStored(count, chunks, type_.bytes);
    std::vector<std::uint8_t> values(count * type_.bytes);
    readInto(all, chunks, [&](std::uint64_t at, std::uint64_t n, const std::uint8_t* bytes) {
        std::memcpy(values.data() + at * type_.bytes, bytes, n * type_.bytes);
    });
    return values;
}

void Hdf5DataSet::require(const Slab& slab) const
{
    if (!isWithin(slab, space_.shape))
        store_.fail(fmt::format("'{}' has {} elements", name_, fmt::join(space_.shape, " x ")),
                    "more, by what refers to them");
}

/// A count is no more than the file can hold: packed by deflate, or a little that was never written.
void Hdf5DataSet::requireStored(std::uint64_t count, const std::vector<Hdf5Chunk>& chunks,
                                std::size_t bytesInMemory) const
{
    const std::uint64_t stored = storedBytes(chunks);
    const std::uint64_t most = filters_.empty() ? stored : stored * kMostRatio;
    if (count > (most + kUnwritten) / type_.bytes)
        store_.fail(fmt::format("'{}' has {} elements, and {} bytes for them", name_, count, stored));
    // Each thread has a chunk as it stands in the file, and the chunk unpacked and unshuffled.
    std::uint64_t largest = 0;
    for (const Hdf5Chunk& chunk : chunks) largest = std::max(largest, std::min(chunk.bytes, store_.fileSize()));
    const std::uint64_t atOnce =
        std::min<std::uint64_t>(chunks.size(), std::max(1u, std::thread::hardware_concurrency()));
    const std::uint64_t unpacked = chunks.empty() || filters_.empty() ? 0 : productOf(layout_.chunk) * type_.bytes;
    requireMemory(
        store_.path(), fmt::format("reading '{}'", name_),
        count * (bytesInMemory + type_.bytes) + atOnce * (largest + 2 * std::min(unpacked, largest * kMostRatio)));
}

std::vector<Hdf5Chunk> Hdf5DataSet::chunksIn(const Slab& slab) const
{
    if (layout_.kind != Hdf5Layout::Kind::chunked) return {};
    requireKnownFilters(store_, filters_, name_);
    auto chunks = findHdf5Chunks(store_, layout_, space_, type_.bytes, !filters_.empty(), name_);
    std::erase_if(chunks, [&](const Hdf5Chunk& chunk) {
        for (std::size_t i = 0; i < chunk.first.size(); ++i)
            if (chunk.first[i] >= slab.first[i] + slab.count[i] || chunk.first[i] + layout_.chunk[i] <= slab.first[i])
                return true;
        return false;
    });
    return chunks;
}

std::uint64_t Hdf5DataSet::storedBytes(const std::vector<Hdf5Chunk>& chunks) const
{
    if (layout_.kind == Hdf5Layout::Kind::compact) return layout_.compact.size();
    std::uint64_t sum =
        layout_.kind == Hdf5Layout::Kind::contiguous && store_.isDefined(layout_.address) ? layout_.bytes : 0;
    for (const Hdf5Chunk& chunk : chunks) sum += std::min(chunk.bytes, store_.fileSize());
    return std::min(sum, store_.fileSize());
}

void Hdf5DataSet::readInto(const Slab& slab, const std::vector<Hdf5Chunk>& chunks, const Take& take) const
{
    const Slab all = wholeSlab(space_.shape);
    if (layout_.kind == Hdf5Layout::Kind::compact) {
        if (layout_.compact.size() / type_.bytes < space_.count())
            store_.fail(fmt::format("'{}' has {} bytes", name_, layout_.compact.size()));
        forEachRun(all, slab, [&](std::uint64_t source, std::uint64_t target, std::uint64_t count) {
            take(target, count, layout_.compact.data() + source * type_.bytes);
        });
    } else if (layout_.kind == Hdf5Layout::Kind::contiguous) {
        if (store_.isDefined(layout_.address)) readContiguous(slab, take);
    } else {
        parallelFor(chunks.size(), [&](std::size_t i) { readChunk(chunks[i], slab, take); });
    }
}

void Hdf5DataSet::readContiguous(const Slab& slab, const Take& take) const
{
    if (layout_.bytes / type_.bytes < space_.count())
        store_.fail(fmt::format("'{}' has {} elements, and {} bytes for them", name_, space_.count(), layout_.bytes));
    const Slab all = wholeSlab(space_.shape);
    const std::uint64_t most = std::max<std::uint64_t>(1, (1U << 20) / type_.bytes);
    std::vector<std::uint8_t> buffer;
    forEachRun(all, slab, [&](std::uint64_t source, std::uint64_t target, std::uint64_t count) {
        for (std::uint64_t done = 0; done < count;) {
            const std::uint64_t n = std::min(most, count - done);
            buffer.resize(n * type_.bytes);
            store_.read(layout_.address + (source + done) * type_.bytes, buffer.size(), buffer.data(), name_.c_str());
            take(target + done, n, buffer.data());
            done += n;
        }
    });
}

void Hdf5DataSet::readChunk(const Hdf5Chunk& chunk, const Slab& slab, const Take& take) const
{
    auto data = store_.block(chunk.address, chunk.bytes, name_.c_str());
    bool edge = false;
    for (std::size_t i = 0; i < chunk.first.size(); ++i)
        edge = edge || layout_.chunk[i] > space_.shape[i] - chunk.first[i];
    const std::uint64_t bytes = productOf(layout_.chunk) * type_.bytes;
    if (!filters_.empty() && !(edge && layout_.rawEdges))
        data = unfiltered(store_, std::move(data), filters_, chunk.skipped, bytes, name_);
    if (data.size() < bytes)
        store_.fail(fmt::format("a chunk of '{}' has {} bytes", name_, data.size()), fmt::format("{}", bytes));
    forEachRun({chunk.first, layout_.chunk}, slab,
               [&](std::uint64_t source, std::uint64_t target, std::uint64_t count) {
                   take(target, count, data.data() + source * type_.bytes);
               });
}

template std::vector<float> Hdf5DataSet::read(const Slab&) const;
template std::vector<double> Hdf5DataSet::read(const Slab&) const;
template std::vector<std::int8_t> Hdf5DataSet::read(const Slab&) const;
template std::vector<std::int32_t> Hdf5DataSet::read(const Slab&) const;
template std::vector<std::int64_t> Hdf5DataSet::read(const Slab&) const;

}  // namespace aeolic
