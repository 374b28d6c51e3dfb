#pragma once

#include <cstdint>
#include <optional>

namespace aeolic::gl {

/// What a device has for a scene.
struct DeviceLimits {
    std::uint64_t side = 0;                  ///< The longest side of a texture with three dimensions, samples.
    std::uint64_t block = 0;                 ///< The longest buffer that shaders read, bytes.
    std::optional<std::uint64_t> freeBytes;  ///< Memory that is free, where the driver tells.
    int ranks = 1;                           ///< How many ranks share this memory.
};

/// What a driver reports of its device's memory (GL_NVX_gpu_memory_info), kilobytes.
struct MemoryReport {
    bool software = false;         ///< The device is a program.
    std::int64_t dedicatedKb = 0;  ///< Of the device alone, all of it.
    std::int64_t freeKb = 0;       ///< The free part of it.
};

/// The free memory of a report, where it is a limit: that of a device with memory of its own. A device that shares the
/// processor's memory, or is a program, reports a part set aside, or nothing, and takes more when it needs more. A
/// report that contradicts itself says nothing either.
std::optional<std::uint64_t> freeBytesOf(const MemoryReport& report);

/// Bytes of memory that the current context's device has free now, where the driver tells.
std::optional<std::uint64_t> freeMemoryBytes();

/// The limits of the current context's device, for one rank on it.
DeviceLimits deviceLimits();

/// Throws InputError where a frame of that size does not fit; `rows` of it are held here, in the place of `heldBytes`.
void requireFrame(int width, int height, int rows, std::uint64_t bytesPerPixel, std::uint64_t heldBytes);

}  // namespace aeolic::gl
