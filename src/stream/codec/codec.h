#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace aeolic::stream {

/// How a tile's pixels travel (docs/protocol.md, Tile; docs/codecs.md for what each is good for). The numbers are those
/// on the wire.
enum class Codec : std::uint8_t { raw = 0, jpeg = 1, png = 2, lz4 = 3, lzo = 4 };

inline constexpr int kLongestTileSide = 32768;                           ///< Pixels.
inline constexpr std::size_t kLargestTileBytes = std::size_t(64) << 20;  ///< Pixels that are not encoded.

/// Full rows of a picture, top to bottom, no padding: width * rows * channels bytes, sRGB values.
template <class Byte>
struct PixelRows {
    Byte* data;
    int width, rows;  ///< Each 1 … kLongestTileSide; all bytes together at most kLargestTileBytes.
    int channels;     ///< 3 RGB, 4 RGBA (not premultiplied).

    std::size_t bytes() const { return std::size_t(width) * std::size_t(rows) * std::size_t(channels); }
};
using Pixels = PixelRows<const std::uint8_t>;

/// Whether this build has the codec. `lzo` needs AEOLIC_LZO. False for numbers that are no codec.
bool available(Codec codec);

/// The codec's name: "raw", "jpeg", "png", "lz4", "lzo", or "unknown" for other numbers.
std::string_view codecName(Codec codec);

/// The codec of that name, available or not.
std::optional<Codec> codecFromName(std::string_view name);

/// Appends the encoded bytes to `out`, whose bytes stay; its memory is reused. All codecs but jpeg are lossless; jpeg
/// leaves alpha out. Only jpeg has a `quality`, 1 … 100: below kFullColorQuality, colour has half the resolution of
/// brightness. Takes memory for about two times the pixels; each thread keeps up to 16 MiB of it. Thread-safe. Throws
/// std::invalid_argument for a codec that is not available and for sizes or qualities out of range, and std::bad_alloc.
/// After an exception `out` is as it was.
void encode(Codec codec, const Pixels& pixels, int quality, std::vector<std::uint8_t>& out);

/// Quality from which jpeg keeps colour at full resolution.
inline constexpr int kFullColorQuality = 90;

/// Decodes into `out`, which then has exactly width * rows * channels bytes; jpeg fills alpha with 255. Nothing about
/// `encoded` is trusted: no byte out of bounds is read or written, and no more memory is taken than `out` needs, plus a
/// constant. Thread-safe. Throws ProtocolError where `encoded` is anything but a whole picture of that size, where that
/// size is out of range (see Pixels), and for a codec that is not available. `out` may then hold anything.
void decode(Codec codec, std::span<const std::uint8_t> encoded, int width, int rows, int channels,
            std::vector<std::uint8_t>& out);

/// The checksum that zlib and PNG use.
std::uint32_t crc32(std::span<const std::uint8_t> bytes);

}  // namespace aeolic::stream
