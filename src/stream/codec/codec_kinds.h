#pragma once

#include <span>
#include <vector>

#include "stream/codec/codec.h"

/// One pair of functions per codec. Each pair has a file of its own, the only one that knows the codec's library.
/// codec.cpp has checked sizes and quality before. The `out` of a decoder has as many bytes as the pixels need; the
/// decoder fills all of them or throws ProtocolError.
namespace aeolic::stream {

void encodeJpeg(const Pixels& pixels, int quality, std::vector<std::uint8_t>& out);
void encodePng(const Pixels& pixels, std::vector<std::uint8_t>& out);
void encodeLz4(const Pixels& pixels, std::vector<std::uint8_t>& out);
void encodeLzo(const Pixels& pixels, std::vector<std::uint8_t>& out);

/// Where decoded pixels go.
struct PixelRoom {
    std::uint8_t* data;
    int width, rows, channels;

    std::size_t bytes() const { return std::size_t(width) * std::size_t(rows) * std::size_t(channels); }
};

void decodeJpeg(std::span<const std::uint8_t> encoded, const PixelRoom& out);
void decodePng(std::span<const std::uint8_t> encoded, const PixelRoom& out);
void decodeLz4(std::span<const std::uint8_t> encoded, const PixelRoom& out);
void decodeLzo(std::span<const std::uint8_t> encoded, const PixelRoom& out);

}  // namespace aeolic::stream
