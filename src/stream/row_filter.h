#pragma once

#include <cstddef>
#include <cstdint>

namespace aeolic::stream {

/// The protocol's filtered rows: of each row first its greens, then its reds less the greens, then its blues less the
/// greens, then its alphas where there are such; of these each byte less the one before it, modulo 256, the first as it
/// is. Streaks are brightness, which all three colours share: what is left of red and blue repeats, and LZ codecs,
/// which find nothing but repeats, take half the bytes for a surface without colour (docs/codecs.md). `channels`: 3
/// or 4. Cost: some GB/s.
void filterRows(const std::uint8_t* pixels, int width, int rows, int channels, std::uint8_t* filtered);

/// The way back, in place.
void unfilterRows(std::uint8_t* pixels, int width, int rows, int channels);

}  // namespace aeolic::stream
