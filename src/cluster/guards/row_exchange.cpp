#include "cluster/guards/row_exchange.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace aeolic {
namespace {

constexpr std::ptrdiff_t kCacheLine = 64;

/// A row of those pixels, before it is copied: no hardware foresees where it begins.
[[gnu::always_inline]] inline void prefetch(const ImageRows& image, const Extent& pixels, int y, bool toWrite)
{
    const std::byte* from = image.at(pixels.x0, y);
    const std::ptrdiff_t bytes = std::ptrdiff_t(pixels.width()) * image.pixelBytes;
    for (std::ptrdiff_t i = 0; i < bytes; i += kCacheLine)
        toWrite ? __builtin_prefetch(from + i, 1) : __builtin_prefetch(from + i);
}

/// Calls copy(in an image, in the room, bytes) row by row. Returns where in the room the next rows go.
template <class Byte, class Copy>
Byte* copyRows(const std::vector<RowLoad>& loads, Byte* room, const Copy& copy)
{
    for (const RowLoad& load : loads)
        for (const ImageRows& image : *load.images)
            for (auto pixels = load.pixels.begin(); pixels != load.pixels.end(); ++pixels) {
                const Extent next = pixels + 1 == load.pixels.end() ? Extent{} : pixels[1];
                const std::size_t bytes = std::size_t(pixels->width()) * std::size_t(image.pixelBytes);
                for (int row = 0; row < pixels->height(); ++row, room += bytes) {
                    if (row < next.height()) prefetch(image, next, next.y0 + row, std::is_const_v<Byte>);
                    copy(image.at(pixels->x0, pixels->y0 + row), room, bytes);
                }
            }
    return room;
}

std::size_t bytesOfAll(const std::vector<std::vector<RowLoad>>& loads)
{
    std::size_t bytes = 0;
    for (const std::vector<RowLoad>& some : loads) bytes += bytesOf(some);
    return bytes;
}

}  // namespace

std::size_t bytesOf(const std::vector<RowLoad>& loads)
{
    std::size_t bytes = 0;
    for (const RowLoad& load : loads) {
        std::size_t pixels = 0, pixelBytes = 0;
        for (const Extent& some : load.pixels) pixels += std::size_t(some.width()) * std::size_t(some.height());
        for (const ImageRows& image : *load.images) pixelBytes += std::size_t(image.pixelBytes);
        bytes += pixels * pixelBytes;
    }
    return bytes;
}

void exchangeRows(Communicator& communicator, const std::vector<std::vector<RowLoad>>& toRank,
                  const std::vector<std::vector<RowLoad>>& fromRank, Bytes& room)
{
    const std::size_t bytes = bytesOfAll(toRank) + bytesOfAll(fromRank);
    if (room.size() < bytes) room.resize(bytes);
    std::byte* free = room.data();
    std::vector<OutgoingBytes> outgoing;
    std::vector<IncomingBytes> incoming;
    for (std::size_t r = 0; r < toRank.size(); ++r) {
        const std::byte* const first = free;
        free = copyRows(toRank[r], free, [](std::byte* inImage, std::byte* inRoom, std::size_t count) {
            std::memcpy(inRoom, inImage, count);
        });
        outgoing.push_back({int(r), {first, free}});
    }
    const std::byte* from = free;
    for (std::size_t r = 0; r < fromRank.size(); ++r) {
        incoming.push_back({int(r), {free, bytesOf(fromRank[r])}});
        free += incoming.back().bytes.size();
    }
    communicator.exchangeInPlace(std::move(outgoing), std::move(incoming));
    for (const std::vector<RowLoad>& loads : fromRank)
        from = copyRows(loads, from, [](std::byte* inImage, const std::byte* inRoom, std::size_t count) {
            std::memcpy(inImage, inRoom, count);
        });
}

void allGatherRows(Communicator& communicator, const Stripes& stripes, std::span<std::byte> whole,
                   std::size_t bytesPerRow)
{
    std::vector<std::size_t> bytes;
    bytes.reserve(std::size_t(stripes.ranks()));
    for (int r = 0; r < stripes.ranks(); ++r) bytes.push_back(std::size_t(stripes.rows(r)) * bytesPerRow);
    communicator.allGatherInPlace(whole, bytes);
}

std::vector<RowFlow> gatherRowFlow(Communicator& communicator, const Stripes& stripes, const std::vector<RowFlow>& own)
{
    const int rank = communicator.rank();
    if (int(own.size()) != stripes.rows(rank))
        throw std::runtime_error("rank " + std::to_string(rank) + " has another stripe than it should");
    std::vector<RowFlow> whole(std::size_t(stripes.height()));
    std::copy(own.begin(), own.end(), whole.begin() + stripes.firstRow[std::size_t(rank)]);
    allGatherRows(communicator, stripes, std::as_writable_bytes(std::span(whole)), sizeof(RowFlow));
    return whole;
}

}  // namespace aeolic
