#pragma once

#include <span>
#include <vector>

#include "stream/codec/codec.h"

/// One pair of functions per codec. Each pair has a file of its own, the only one that knows the codec's library.
/// codec.cpp has checked sizes and quality before; jpeg alone looks at the quality. The `out` of a decoder has as many
/// bytes as the pixels need; the decoder fills all of them or throws ProtocolError.
namespace aeolic::stream {

void encodeJpeg(const Pixels& pixels, int quality, std::vector<std::uint8_t>& out);
void encodePng(const Pixels& pixels, int quality, std::vector<std::uint8_t>& out);
void encodeLz4(const Pixels& pixels, int quality, std::vector<std::uint8_t>& out);
void encodeLzo(const Pixels& pixels, int quality, std::vector<std::uint8_t>& out);

/// Where decoded pixels go.
using PixelRoom = PixelRows<std::uint8_t>;

void decodeJpeg(std::span<const std::uint8_t> encoded, const PixelRoom& out);
void decodePng(std::span<const std::uint8_t> encoded, const PixelRoom& out);
void decodeLz4(std::span<const std::uint8_t> encoded, const PixelRoom& out);
void decodeLzo(std::span<const std::uint8_t> encoded, const PixelRoom& out);

}  // namespace aeolic::stream
