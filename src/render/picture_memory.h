#pragma once

#include <cstdint>

namespace aeolic {

/// Bytes that a processor needs for each pixel of a picture: G-buffer, LIC levels, keys, picture and the phases of a
/// cycle together. Measured with the largest set of stages. A GPU's images take their own amount
/// (gl/project/frame_images.cpp).
constexpr std::uint64_t kBytesPerPixel = 126;

/// Bytes that a processor needs to draw a picture of this size.
inline std::uint64_t pictureBytes(int width, int height)
{
    return std::uint64_t(width) * std::uint64_t(height) * kBytesPerPixel;
}

}  // namespace aeolic
