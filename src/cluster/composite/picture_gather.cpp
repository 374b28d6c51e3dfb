#include "cluster/composite/picture_gather.h"

#include <bit>
#include <cstring>
#include <span>
#include <stdexcept>

namespace aeolic {
namespace {

/// The background's four bytes, then for every row the first painted column and the one after the last.
using Words = std::vector<std::int32_t>;

Words wordsOf(const PaintedPixels& pixels)
{
    Words words{std::bit_cast<std::int32_t>(pixels.background)};
    words.reserve(1 + 2 * pixels.painted.size());
    for (const ColumnSpan& columns : pixels.painted) words.insert(words.end(), {columns.x0, columns.x1});
    return words;
}

/// The end of the message says where its pixels belong within their extent, which is known. Reads that; false if it
/// is not about rows of that extent.
bool understand(PaintedPixels& pixels)
{
    const Extent& rows = pixels.extent;
    const auto tail = std::size_t(paintedColumnsBytes(rows.height()));
    if (pixels.bytes.size() < tail) return false;
    Words words(tail / sizeof(std::int32_t));
    std::memcpy(words.data(), pixels.bytes.data() + (pixels.bytes.size() - tail), tail);
    pixels.background = std::bit_cast<std::array<std::uint8_t, 4>>(words.front());
    pixels.painted.resize(std::size_t(rows.height()));
    for (std::size_t row = 0; row < pixels.painted.size(); ++row) {
        const ColumnSpan columns{words[2 * row + 1], words[2 * row + 2]};
        if (!columns.empty() && (columns.x0 < rows.x0 || columns.x1 > rows.x1)) return false;
        pixels.painted[row] = columns;
    }
    return pixels.bytes.size() == pixels.allBytes() + tail;
}

}  // namespace

void sendPainted(Communicator& communicator, const Tile& stripe, PaintedPixels& packed)
{
    pack(stripe, packed);
    const Words words = wordsOf(packed);
    const ByteSpan tail = std::as_bytes(std::span(words));
    packed.bytes.insert(packed.bytes.end(), tail.begin(), tail.end());
    std::vector<Bytes> nothing;
    communicator.gatherInto(nothing, packed.bytes);
}

void receivePainted(Communicator& communicator, const Stripes& stripes, int width, std::vector<PaintedPixels>& others)
{
    const auto ranks = std::size_t(communicator.size());
    others.resize(ranks - 1);
    std::vector<Bytes> sent(ranks);
    for (std::size_t r = 1; r < ranks; ++r) sent[r].swap(others[r - 1].bytes);
    communicator.gatherInto(sent, {});
    for (std::size_t r = 1; r < ranks; ++r) {
        PaintedPixels& pixels = others[r - 1];
        pixels.bytes.swap(sent[r]);
        pixels.extent = stripes.extent(int(r), width);
        if (!understand(pixels))
            throw std::runtime_error("rank 0: the picture: rank " + std::to_string(r) +
                                     " sends rows that are not its own");
    }
}

}  // namespace aeolic
