#pragma once

#include <cstddef>
#include <cstdint>

namespace aeolic::stream {

/// The protocol's filtered rows: each byte less the byte one pixel to its left, modulo 256; a row's first pixel as it
/// is. LZ codecs find more to repeat in differences. `channels`: 3 or 4. Cost: about that of copying.
void filterRows(const std::uint8_t* pixels, int width, int rows, int channels, std::uint8_t* filtered);

/// The way back, in place.
void unfilterRows(std::uint8_t* pixels, int width, int rows, int channels);

}  // namespace aeolic::stream
