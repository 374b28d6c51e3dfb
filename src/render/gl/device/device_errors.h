#pragma once

#include <cstdint>
#include <string>

#include "render/backend.h"

namespace aeolic::gl {

/// The device has no memory left for something.
struct OutOfMemory : DeviceError {
    using DeviceError::DeviceError;
};

/// Local to the calling thread. The renderer to name in errors to come; Context::bind() calls it. Null: none.
void errorsAreOf(const std::string* renderer);

/// Throws DeviceError: the device's name and what happened.
[[noreturn]] void deviceFailed(const std::string& what);

/// Throws DeviceError naming `doing` after an OpenGL error, OutOfMemory where it is that.
void checkErrors(const std::string& doing);

/// Throws as checkErrors() after an allocation, naming its size and the free memory.
void checkAllocation(const std::string& what, std::uint64_t bytes);

/// Throws DeviceError where the device was reset since the context was made: what it gives back is nothing.
void requireNoReset();

/// "1234 MB"
std::string megabytes(std::uint64_t bytes);

}  // namespace aeolic::gl
