#include "cluster/picture_gather.h"

#include <bit>
#include <cstring>
#include <span>
#include <stdexcept>

namespace aeolic {
namespace {

/// The background's four bytes, and of every row the first painted column and the one after the last.
using Words = std::vector<std::int32_t>;

Words wordsOf(const PaintedPixels& pixels)
{
    Words words{std::bit_cast<std::int32_t>(pixels.background)};
    words.reserve(1 + 2 * pixels.painted.size());
    for (const ColumnSpan& columns : pixels.painted) words.insert(words.end(), {columns.x0, columns.x1});
    return words;
}

/// Whether `sent` says what `pixels`, whose extent is known, are.
bool understand(const Bytes& sent, PaintedPixels& pixels)
{
    const Extent& rows = pixels.extent;
    if (std::int64_t(sent.size()) != paintedColumnsBytes(rows.height())) return false;
    Words words(sent.size() / sizeof(std::int32_t));
    std::memcpy(words.data(), sent.data(), sent.size());
    pixels.background = std::bit_cast<std::array<std::uint8_t, 4>>(words.front());
    pixels.painted.resize(std::size_t(rows.height()));
    for (std::size_t row = 0; row < pixels.painted.size(); ++row) {
        const ColumnSpan columns{words[2 * row + 1], words[2 * row + 2]};
        if (!columns.empty() && (columns.x0 < rows.x0 || columns.x1 > rows.x1)) return false;
        pixels.painted[row] = columns;
    }
    return true;
}

}  // namespace

void sendPainted(Communicator& communicator, const Tile& stripe, PaintedPixels& packed, BusyClock& busy)
{
    pack(stripe, packed);
    const Words words = wordsOf(packed);
    busy.stop();
    communicator.gather(std::as_bytes(std::span(words)));
    communicator.exchangeInPlace({{0, std::as_bytes(std::span(packed.bytes))}}, {});
    busy.start();
}

void receivePainted(Communicator& communicator, const Stripes& stripes, int width, std::vector<PaintedPixels>& others,
                    BusyClock& busy)
{
    busy.stop();
    const std::vector<Bytes> sent = communicator.gather({});
    busy.start();
    others.resize(sent.size() - 1);
    std::vector<IncomingBytes> incoming;
    for (int r = 1; r < communicator.size(); ++r) {
        PaintedPixels& pixels = others[std::size_t(r) - 1];
        pixels.extent = stripes.extent(r, width);
        if (!understand(sent[std::size_t(r)], pixels))
            throw std::runtime_error("rank 0: the picture: rank " + std::to_string(r) +
                                     " sends rows that are not its own");
        pixels.bytes.clear();
        pixels.bytes.resize(pixels.allBytes());
        incoming.push_back({r, std::as_writable_bytes(std::span(pixels.bytes))});
    }
    busy.stop();
    communicator.exchangeInPlace({}, std::move(incoming));
    busy.start();
}

}  // namespace aeolic
