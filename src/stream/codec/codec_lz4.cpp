#include <lz4.h>

#include <stdexcept>

#include "stream/codec/codec_kinds.h"
#include "stream/codec/codec_scratch.h"
#include "stream/codec/row_filter.h"
#include "stream/wire.h"

namespace aeolic::stream {

static_assert(kLargestTileBytes <= LZ4_MAX_INPUT_SIZE);

void encodeLz4(const Pixels& pixels, int, std::vector<std::uint8_t>& out)
{
    const int size = int(pixels.bytes()), bound = LZ4_compressBound(size);
    const Scratch scratch(pixels.bytes() + std::size_t(bound));
    std::uint8_t *filtered = scratch.data(), *block = filtered + size;
    filterRows(pixels.data, pixels.width, pixels.rows, pixels.channels, filtered);
    const int encoded =
        LZ4_compress_default(reinterpret_cast<const char*>(filtered), reinterpret_cast<char*>(block), size, bound);
    if (encoded <= 0) throw std::runtime_error("LZ4 could not encode a tile");
    out.insert(out.end(), block, block + encoded);
}

void decodeLz4(std::span<const std::uint8_t> encoded, const PixelRoom& out)
{
    // A valid block is never larger; more would not fit LZ4's int.
    const int size = int(out.bytes());
    if (encoded.size() > std::size_t(LZ4_compressBound(size)))
        throw ProtocolError("tile: an LZ4 block that is too long");
    const int decoded = LZ4_decompress_safe(reinterpret_cast<const char*>(encoded.data()),
                                            reinterpret_cast<char*>(out.data), int(encoded.size()), size);
    if (decoded != size)
        throw ProtocolError(decoded < 0 ? "tile: a damaged LZ4 block" : "tile: an LZ4 block of fewer pixels");
    unfilterRows(out.data, out.width, out.rows, out.channels);
}

}  // namespace aeolic::stream
