#include "stream/codec/codec.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "stream/codec/codec_kinds.h"
#include "stream/protocol_error.h"
#include "version.h"

namespace aeolic::stream {
namespace {

constexpr std::array<std::string_view, 5> kNames{"raw", "jpeg", "png", "lz4", "lzo"};

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

void encodeTo(Codec codec, const Pixels& pixels, int quality, std::vector<std::uint8_t>& out)
{
    switch (codec) {
        case Codec::raw:
            out.insert(out.end(), pixels.data, pixels.data + pixels.bytes());
            return;
        case Codec::jpeg:
            return encodeJpeg(pixels, quality, out);
        case Codec::png:
            return encodePng(pixels, out);
        case Codec::lz4:
            return encodeLz4(pixels, out);
        case Codec::lzo:
            return encodeLzo(pixels, out);
    }
}

void decodeTo(Codec codec, std::span<const std::uint8_t> encoded, const PixelRoom& out)
{
    switch (codec) {
        case Codec::raw:
            std::copy(encoded.begin(), encoded.end(), out.data);
            return;
        case Codec::jpeg:
            return decodeJpeg(encoded, out);
        case Codec::png:
            return decodePng(encoded, out);
        case Codec::lz4:
            return decodeLz4(encoded, out);
        case Codec::lzo:
            return decodeLzo(encoded, out);
    }
}

}  // namespace

bool available(Codec codec)
{
    return std::size_t(codec) < kNames.size() && (codec != Codec::lzo || builtWithLzo);
}

std::string_view codecName(Codec codec)
{
    return std::size_t(codec) < kNames.size() ? kNames[std::size_t(codec)] : "unknown";
}

std::optional<Codec> codecFromName(std::string_view name)
{
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return Codec(found - kNames.begin());
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
        encodeTo(codec, pixels, quality, out);
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
    decodeTo(codec, encoded, {out.data(), width, rows, channels});
}

std::uint32_t crc32(std::span<const std::uint8_t> bytes)
{
    return std::uint32_t(::crc32_z(::crc32_z(0, nullptr, 0), bytes.data(), bytes.size()));
}

}  // namespace aeolic::stream
