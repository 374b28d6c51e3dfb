#include <lzo/lzo1x.h>

#include <memory>
#include <stdexcept>

#include "stream/codec/codec_kinds.h"
#include "stream/codec/codec_scratch.h"
#include "stream/codec/row_filter.h"
#include "stream/wire.h"

// LZO is under the GNU General Public License, and so is every build that compiles this file (docs/decisions).
namespace aeolic::stream {
namespace {

/// LZO refuses to work where it was compiled for another machine than it runs on.
void startLzo()
{
    static const bool started = lzo_init() == LZO_E_OK;
    if (!started) throw std::runtime_error("LZO does not start on this machine");
}

}  // namespace

void encodeLzo(const Pixels& pixels, int, std::vector<std::uint8_t>& out)
{
    startLzo();
    const std::size_t mostEncoded = pixels.bytes() + pixels.bytes() / 16 + 64 + 3;  // Of data that does not shrink.
    const Scratch scratch(pixels.bytes() + mostEncoded);
    std::uint8_t *filtered = scratch.data(), *block = filtered + pixels.bytes();
    const auto work = std::make_unique_for_overwrite<lzo_align_t[]>(LZO1X_1_MEM_COMPRESS / sizeof(lzo_align_t) + 1);
    filterRows(pixels.data, pixels.width, pixels.rows, pixels.channels, filtered);
    lzo_uint encoded = 0;
    if (lzo1x_1_compress(filtered, pixels.bytes(), block, &encoded, work.get()) != LZO_E_OK)
        throw std::runtime_error("LZO could not encode a tile");
    out.insert(out.end(), block, block + encoded);
}

void decodeLzo(std::span<const std::uint8_t> encoded, const PixelRoom& out)
{
    startLzo();
    if (encoded.empty()) throw ProtocolError("tile: an LZO block of no bytes");
    lzo_uint decoded = out.bytes();
    // The safe variant: checks every length, and that the block ends where the bytes do.
    const int result = lzo1x_decompress_safe(encoded.data(), encoded.size(), out.data, &decoded, nullptr);
    if (result != LZO_E_OK) throw ProtocolError("tile: a damaged LZO block");
    if (decoded != out.bytes()) throw ProtocolError("tile: an LZO block of fewer pixels");
    unfilterRows(out.data, out.width, out.rows, out.channels);
}

}  // namespace aeolic::stream
