#include "data/hdf5/hdf5_heap.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace aeolic {
namespace {

constexpr char kGlobal[] = "an HDF5 global heap", kFractal[] = "an HDF5 fractal heap";

}  // namespace

std::vector<std::uint8_t> readGlobalHeap(const Hdf5Store& store, std::uint64_t address, std::uint32_t index,
                                         std::uint64_t count)
{
    const auto head = store.block(address, 8 + store.lengthBytes(), kGlobal);
    ByteCursor cursor = store.cursor(head, kGlobal);
    cursor.expect("GCOL");
    cursor.skip(4);
    const auto bytes = store.block(address, store.length(cursor), kGlobal);
    ByteCursor objects = store.cursor(bytes, kGlobal);
    objects.skip(head.size());
    while (objects.left() >= 8 + store.lengthBytes()) {
        const std::uint32_t number = objects.u16();
        objects.skip(6);
        const std::uint64_t size = store.length(objects);
        if (number == 0) break;  // What is left is free.
        const auto data = objects.take(std::size_t(std::min<std::uint64_t>(size, bytes.size() + 1)));
        if (number == index && count <= data.size()) return {data.begin(), data.begin() + std::ptrdiff_t(count)};
        objects.skip(std::min<std::size_t>(objects.left(), (8 - size % 8) % 8));
    }
    store.fail(fmt::format("{} has no object {} of {} bytes", kGlobal, index, count));
}

Hdf5FractalHeap::Hdf5FractalHeap(const Hdf5Store& store, std::uint64_t address) : store_(store)
{
    const std::size_t bytes = 26 + 12 * store.lengthBytes() + 3 * store.addressBytes();
    const auto head = store.block(address, bytes, kFractal);
    ByteCursor cursor = store.cursor(head, kFractal);
    cursor.expect("FRHP");
    if (cursor.u8() != 0) store.fail(fmt::format("{} has an unknown version", kFractal));
    idBytes_ = cursor.u16();
    if (cursor.u16() != 0) store.fail(fmt::format("{} is compressed", kFractal), "links and attributes as they are");
    store.checkedBlock(address, bytes, kFractal);
    cursor.skip(1);
    const std::uint64_t largestObject = cursor.u32();
    cursor.skip(store.lengthBytes() + store.addressBytes());  // Objects too large for the heap.
    cursor.skip(store.lengthBytes() + store.addressBytes());  // Free space.
    cursor.skip(8 * store.lengthBytes());                     // Sizes and counts.
    width_ = cursor.u16();
    firstBlock_ = store.length(cursor);
    largestDirect_ = store.length(cursor);
    const std::size_t offsetBits = cursor.u16();
    cursor.skip(2);
    root_ = store.address(cursor);
    rows_ = cursor.u16();
    const auto isSize = [](std::uint64_t size) { return std::has_single_bit(size) && size <= (1ULL << 40); };
    if (width_ == 0 || !isSize(firstBlock_) || !isSize(largestDirect_) || largestDirect_ < firstBlock_ ||
        offsetBits > 64 || idBytes_ < 2 || rows_ > 64)
        store.fail(fmt::format("{} is damaged", kFractal));
    offsetBytes_ = (offsetBits + 7) / 8;
    lengthBytes_ = std::min((std::size_t(std::countr_zero(largestDirect_)) + 7) / 8, bytesFor(largestObject));
    directRows_ = std::uint64_t(std::countr_zero(largestDirect_) - std::countr_zero(firstBlock_)) + 2;
}

std::vector<std::uint8_t> Hdf5FractalHeap::object(std::span<const std::uint8_t> id) const
{
    ByteCursor cursor = store_.cursor(id, kFractal);
    const int first = cursor.u8(), kind = first >> 4 & 3;
    if (kind == 0) {
        const std::uint64_t offset = cursor.whole(offsetBytes_);
        return managed(offset, cursor.whole(lengthBytes_));
    }
    if (kind == 2 && idBytes_ <= 18) {
        const auto data = cursor.take(std::size_t(first & 15) + 1);
        return {data.begin(), data.end()};
    }
    store_.fail(fmt::format("{} has an object that is too large for it", kFractal),
                "links and attributes of 64 kB or less");
}

std::uint64_t Hdf5FractalHeap::blockBytes(std::uint64_t row) const
{
    return row == 0 ? firstBlock_ : firstBlock_ << (row - 1);
}

/// Walks down the table in which each row has blocks twice as large as the row before.
std::vector<std::uint8_t> Hdf5FractalHeap::managed(std::uint64_t offset, std::uint64_t length) const
{
    std::uint64_t table = root_, rows = rows_;
    if (rows == 0) return store_.block(root_ + offset, length, kFractal);
    for (int depth = 0; depth < 64; ++depth) {
        std::uint64_t row = 0, begin = 0;
        while (row < rows && offset - begin >= width_ * blockBytes(row)) begin += width_ * blockBytes(row++);
        if (row >= rows) break;
        const std::uint64_t column = (offset - begin) / blockBytes(row), entry = row * width_ + column;
        const std::uint64_t at = table + 5 + store_.addressBytes() + offsetBytes_ + entry * store_.addressBytes();
        const auto sign = store_.block(table, 4, kFractal);
        if (!std::equal(sign.begin(), sign.end(), "FHIB")) break;
        const auto bytes = store_.block(at, store_.addressBytes(), kFractal);
        ByteCursor cursor = store_.cursor(bytes, kFractal);
        const std::uint64_t child = store_.address(cursor);
        offset -= begin + column * blockBytes(row);
        if (row < directRows_) {
            if (length > blockBytes(row) || offset > blockBytes(row) - length) break;
            return store_.block(child + offset, length, kFractal);
        }
        const std::uint64_t smallest = firstBlock_ * width_;
        if (!std::has_single_bit(smallest) || smallest > blockBytes(row)) break;
        table = child;
        rows = std::uint64_t(std::countr_zero(blockBytes(row)) - std::countr_zero(smallest)) + 1;
    }
    store_.fail(fmt::format("{} has no object at {}", kFractal, offset));
}

}  // namespace aeolic
