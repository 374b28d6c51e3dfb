#pragma once

#include <cstddef>
#include <cstdint>

namespace aeolic::data_message {

// How addData() writes what readData() reads.
inline constexpr std::uint32_t kInMessage = 0xffffffff;  ///< In the place of a memory's number: values follow.

/// What a data object is.
enum class Form : std::uint8_t { none, blocks, polygons, image, rectilinear, structured, unstructured };

}  // namespace aeolic::data_message
