#pragma once

#include <cstddef>
#include <cstdint>

namespace aeolic::stream {

/// The protocol's filtered rows. A row becomes planes: its greens, its reds less the greens, its blues less the greens,
/// and its alphas if it has any. In each plane the first byte stays, and every other byte is replaced by its difference
/// from the byte before it, modulo 256. Streaks are brightness, which all three colours share: the differences of red
/// and blue repeat. LZ codecs find nothing but repeats, and take half the bytes for a surface without colour
/// (docs/codecs.md). `channels`: 3 or 4. Cost: some GB/s.
void filterRows(const std::uint8_t* pixels, int width, int rows, int channels, std::uint8_t* filtered);

/// The way back, in place.
void unfilterRows(std::uint8_t* pixels, int width, int rows, int channels);

}  // namespace aeolic::stream
