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

/// Writes a picture as its name ends: .png, .jpg or .jpeg (of quality 95, without subsampling), .webp (lossless). The
/// file gets its name when it is complete, so a failure leaves no half-written file. Throws aeolic::InputError for
/// another ending, for a picture with transparency as JPEG, and for one too large for WebP (16383 pixels a side);
/// std::runtime_error naming the path if it cannot be written.
void writePicture(const Picture& picture, const std::string& path);

/// Writes a PNG. The file gets its name when it is complete, so a failure leaves no half-written file.
/// Throws std::runtime_error naming the path if it cannot be written.
void writePng(const Picture& picture, const std::string& path);

}  // namespace aeolic
