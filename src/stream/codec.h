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
inline constexpr std::size_t kLargestTileBytes = std::size_t(64) << 20;  ///< Of pixels, not encoded.

/// Full rows of a picture, top to bottom, no padding: width * rows * channels bytes, sRGB values.
struct Pixels {
    const std::uint8_t* data;
    int width, rows;  ///< Each 1 … kLongestTileSide; all bytes together at most kLargestTileBytes.
    int channels;     ///< 3 RGB, 4 RGBA (not premultiplied).

    std::size_t bytes() const { return std::size_t(width) * std::size_t(rows) * std::size_t(channels); }
};

/// Whether this build has it: `lzo` only with AEOLIC_LZO. False for numbers that are no codec.
bool available(Codec codec);

/// "raw", "jpeg", "png", "lz4", "lzo"; "unknown" for other numbers.
std::string_view codecName(Codec codec);

/// The codec of that name, available or not.
std::optional<Codec> codecFromName(std::string_view name);

/// Appends the encoded bytes to `out`, whose bytes stay; its memory is reused. All but jpeg are lossless; jpeg leaves
/// alpha out. `quality`, of jpeg alone: 1 … 100; colour has half the resolution of brightness below kFullColorQuality.
/// Takes memory for about two times the pixels, of which each thread keeps up to 16 MiB. Thread-safe. Throws
/// std::invalid_argument for a codec that is not available and sizes or qualities out of range, std::bad_alloc; `out`
/// is then as it was.
void encode(Codec codec, const Pixels& pixels, int quality, std::vector<std::uint8_t>& out);

/// Quality from which jpeg keeps colour at full resolution.
inline constexpr int kFullColorQuality = 90;

/// Decodes into `out`, of then exactly width * rows * channels bytes; jpeg fills alpha with 255. Nothing about
/// `encoded` is trusted: no byte out of bounds is read or written, and no more memory taken than `out` needs, plus a
/// constant. Thread-safe. Throws ProtocolError where `encoded` is anything but a whole picture of that size, where that
/// size is out of range (as for Pixels), and for a codec that is not available; `out` then holds anything.
void decode(Codec codec, std::span<const std::uint8_t> encoded, int width, int rows, int channels,
            std::vector<std::uint8_t>& out);

/// That of zlib and PNG.
std::uint32_t crc32(std::span<const std::uint8_t> bytes);

}  // namespace aeolic::stream
