#include "stream/codec/codec.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "stream/codec/codec_kinds.h"
#include "stream/wire.h"
#include "version.h"

namespace aeolic::stream {
namespace {

void encodeRaw(const Pixels& pixels, int, std::vector<std::uint8_t>& out)
{
    out.insert(out.end(), pixels.data, pixels.data + pixels.bytes());
}

void decodeRaw(std::span<const std::uint8_t> encoded, const PixelRoom& out)
{
    std::copy(encoded.begin(), encoded.end(), out.data);
}

struct Kind {
    std::string_view name;
    void (*encode)(const Pixels& pixels, int quality, std::vector<std::uint8_t>& out);  ///< Null: not in this build.
    void (*decode)(std::span<const std::uint8_t> encoded, const PixelRoom& out);
};

constexpr Kind lzoKind()
{
    if constexpr (builtWithLzo)
        return {"lzo", encodeLzo, decodeLzo};
    else
        return {"lzo", nullptr, nullptr};
}

/// In the order of Codec.
constexpr std::array<Kind, 5> kKinds{{{"raw", encodeRaw, decodeRaw},
                                      {"jpeg", encodeJpeg, decodeJpeg},
                                      {"png", encodePng, decodePng},
                                      {"lz4", encodeLz4, decodeLz4},
                                      lzoKind()}};

bool fits(int width, int rows, int channels)
{
    const auto side = [](int length) { return length >= 1 && length <= kLongestTileSide; };
    return side(width) && side(rows) && (channels == 3 || channels == 4) &&
           Pixels{nullptr, width, rows, channels}.bytes() <= kLargestTileBytes;
}

std::string sizeText(int width, int rows, int channels)
{
    return std::to_string(width) + "x" + std::to_string(rows) + " pixels of " + std::to_string(channels) + " bytes";
}

}  // namespace

bool available(Codec codec)
{
    return std::size_t(codec) < kKinds.size() && kKinds[std::size_t(codec)].encode;
}

std::string_view codecName(Codec codec)
{
    return std::size_t(codec) < kKinds.size() ? kKinds[std::size_t(codec)].name : "unknown";
}

std::optional<Codec> codecFromName(std::string_view name)
{
    const auto found = std::ranges::find(kKinds, name, &Kind::name);
    if (found == kKinds.end()) return std::nullopt;
    return Codec(found - kKinds.begin());
}

void encode(Codec codec, const Pixels& pixels, int quality, std::vector<std::uint8_t>& out)
{
    if (!available(codec))
        throw std::invalid_argument("codec " + std::string(codecName(codec)) + ": not in this build");
    if (!fits(pixels.width, pixels.rows, pixels.channels))
        throw std::invalid_argument("a tile of " + sizeText(pixels.width, pixels.rows, pixels.channels));
    if (codec == Codec::jpeg && (quality < 1 || quality > 100))
        throw std::invalid_argument("jpeg quality " + std::to_string(quality));
    const std::size_t before = out.size();
    try {
        kKinds[std::size_t(codec)].encode(pixels, quality, out);
    } catch (...) {
        out.resize(before);
        throw;
    }
}

void decode(Codec codec, std::span<const std::uint8_t> encoded, int width, int rows, int channels,
            std::vector<std::uint8_t>& out)
{
    if (!available(codec))
        throw ProtocolError("tile: codec " + std::to_string(int(codec)) + " (" + std::string(codecName(codec)) +
                            "); expected one of this build");
    if (!fits(width, rows, channels)) throw ProtocolError("tile: " + sizeText(width, rows, channels));
    const PixelRoom room{nullptr, width, rows, channels};
    if (codec == Codec::raw && encoded.size() != room.bytes())
        throw ProtocolError("tile: raw, " + std::to_string(encoded.size()) + " bytes; expected " +
                            std::to_string(room.bytes()));
    out.resize(room.bytes());
    kKinds[std::size_t(codec)].decode(encoded, {out.data(), width, rows, channels});
}

std::uint32_t crc32(std::span<const std::uint8_t> bytes)
{
    return std::uint32_t(::crc32_z(::crc32_z(0, nullptr, 0), bytes.data(), bytes.size()));
}

}  // namespace aeolic::stream
