#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace aeolic {

/// An 8-bit image, sRGB values, rows from top to bottom, no padding.
struct Picture {
    int width = 0, height = 0;
    int channels = 3;                  ///< 3: RGB, 4: RGBA (not premultiplied).
    std::vector<std::uint8_t> pixels;  ///< width * height * channels bytes.
};

/// The bytes of a PNG file. Throws std::runtime_error if size and pixels do not agree.
std::string pngOf(const Picture& picture);

/// Writes a PNG. The file gets its name when it is complete, so a failure leaves no half-written file.
/// Throws std::runtime_error naming the path if it cannot be written.
void writePng(const Picture& picture, const std::string& path);

}  // namespace aeolic
