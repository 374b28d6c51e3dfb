#pragma once

#include <cstdint>
#include <span>

namespace aeolic::stream {

/// Reads a JPEG file's segments up to its pixels. Throws ProtocolError unless it is one that a tile may be: baseline,
/// 8 bits, three components in one scan, of that size, ended by its end marker. What else JPEG knows (progressive and
/// arithmetic coding, a scan for each component, heights told later) takes decoders many times the picture's memory or
/// minutes, from a few bytes.
void requireJpegTile(std::span<const std::uint8_t> file, int width, int rows);

}  // namespace aeolic::stream
