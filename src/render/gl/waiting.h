#pragma once

#include "render/gl/objects.h"

namespace aeolic::gl {

/// Waits for the device to pass `fence`, and deletes it. Throws std::runtime_error where the device hangs.
void waitFor(GLsync fence);

/// Makes `buffer` anew, in memory that the processor reads fast, mapped for as long as it lives.
const void* mapForReading(Buffer& buffer, std::size_t bytes);

}  // namespace aeolic::gl
