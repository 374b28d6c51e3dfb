#include "render/gl/device/gl_limits.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <string>

#include "aeolic/error.h"
#include "render/gl/device/device_errors.h"
#include "render/gl/device/devices.h"

namespace aeolic::gl {
namespace {

/// The values of a limit that has so many.
template <std::size_t kValues>
std::array<std::uint64_t, kValues> limits(GLenum name)
{
    std::array<GLint64, kValues> values{};
    glGetInteger64v(name, values.data());
    std::array<std::uint64_t, kValues> limits{};
    for (std::size_t i = 0; i < kValues; ++i) limits[i] = std::uint64_t(std::max<GLint64>(values[i], 0));
    return limits;
}

std::uint64_t limit(GLenum name)
{
    return limits<1>(name)[0];
}

std::string rendererName()
{
    const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return name ? name : "";  // The context is lost.
}

GLint kilobytes(GLenum name)
{
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

}  // namespace

std::optional<std::uint64_t> freeBytesOf(const MemoryReport& report)
{
    constexpr std::int64_t kLeastDedicatedKb = 512 << 10;  // Graphics cards with OpenGL 4.5 have more.
    if (report.software || report.dedicatedKb < kLeastDedicatedKb) return std::nullopt;
    if (report.freeKb < 0 || report.freeKb > report.dedicatedKb) return std::nullopt;
    return std::uint64_t(report.freeKb) << 10;
}

std::optional<std::uint64_t> freeMemoryBytes()
{
    if (epoxy_has_gl_extension("GL_NVX_gpu_memory_info"))
        return freeBytesOf({isSoftwareRenderer(rendererName()), kilobytes(GL_GPU_MEMORY_INFO_DEDICATED_VIDMEM_NVX),
                            kilobytes(GL_GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX)});
    // Mesa has both extensions. This one alone is from AMD's own driver, which has it for graphics cards.
    if (epoxy_has_gl_extension("GL_ATI_meminfo")) {
        GLint kilobytes[4] = {};  // Free, the largest block of it, and the same in the processor's memory.
        glGetIntegerv(GL_TEXTURE_FREE_MEMORY_ATI, kilobytes);
        if (kilobytes[0] > 0) return std::uint64_t(kilobytes[0]) << 10;
    }
    return std::nullopt;
}

DeviceLimits deviceLimits()
{
    return {limit(GL_MAX_3D_TEXTURE_SIZE), limit(GL_MAX_SHADER_STORAGE_BLOCK_SIZE), freeMemoryBytes()};
}

void requireFrame(int width, int height, int rows, std::uint64_t bytesPerPixel, std::uint64_t heldBytes)
{
    const auto [viewportWidth, viewportHeight] = limits<2>(GL_MAX_VIEWPORT_DIMS);
    const std::uint64_t side = std::min({limit(GL_MAX_TEXTURE_SIZE), viewportWidth, viewportHeight});
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    if (std::uint64_t(std::max(width, height)) > side)
        throw InputError("--size", size, "at most " + std::to_string(side) + " pixels a side on this GPU");
    const std::uint64_t bytes = std::uint64_t(width) * std::uint64_t(rows) * bytesPerPixel;
    const auto free = freeMemoryBytes();
    if (free && bytes > *free + heldBytes)
        throw InputError("--size", size + " takes " + megabytes(bytes) + " of GPU memory",
                         "at most the " + megabytes(*free + heldBytes) + " that are free: a smaller picture, or " +
                             std::to_string(bytes / std::max<std::uint64_t>(*free + heldBytes, 1) + 1) +
                             " times as many GPUs");
}

}  // namespace aeolic::gl
