#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

namespace aeolic {

/// Pixels without padding, 8 bits a channel: 3 channels RGB, 4 RGBA (not premultiplied).
struct PngPixels {
    const std::uint8_t* data;
    int width, rows, channels;
};

/// How hard libpng tries. What is not given is its own choice.
struct PngEffort {
    int level;                        ///< Of zlib, 0 to 9.
    std::optional<int> filters = {};  ///< PNG_FILTER_…
    std::optional<int> strategy = {};
    std::optional<std::size_t> chunkBytes = {};
};

/// Hands a PNG file to `sink`, piece after piece. Throws std::bad_alloc where there is no memory, or where the sink
/// threw; and std::runtime_error with libpng's words for anything else.
void writePngTo(const PngPixels& pixels, const PngEffort& effort,
                const std::function<void(const std::uint8_t* bytes, std::size_t count)>& sink);

}  // namespace aeolic
