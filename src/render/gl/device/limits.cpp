#include "render/gl/device/limits.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <string>

#include "aeolic/error.h"
#include "render/gl/device/device_errors.h"

namespace aeolic::gl {
namespace {

std::uint64_t limit(GLenum name)
{
    GLint64 value = 0;
    glGetInteger64v(name, &value);
    return std::uint64_t(std::max<GLint64>(value, 0));
}

}  // namespace

std::optional<std::uint64_t> freeMemoryBytes()
{
    if (epoxy_has_gl_extension("GL_NVX_gpu_memory_info")) {
        GLint kilobytes = 0;
        glGetIntegerv(GL_GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX, &kilobytes);
        return std::uint64_t(kilobytes) << 10;
    }
    if (epoxy_has_gl_extension("GL_ATI_meminfo")) {
        GLint kilobytes[4] = {};  // Free, the largest block of it, and the same in the processor's memory.
        glGetIntegerv(GL_TEXTURE_FREE_MEMORY_ATI, kilobytes);
        return std::uint64_t(kilobytes[0]) << 10;
    }
    return std::nullopt;
}

DeviceLimits deviceLimits()
{
    return {limit(GL_MAX_3D_TEXTURE_SIZE), limit(GL_MAX_SHADER_STORAGE_BLOCK_SIZE), freeMemoryBytes()};
}

void requireFrame(int width, int height, int rows, std::uint64_t bytesPerPixel, std::uint64_t heldBytes)
{
    const std::uint64_t side = std::min(limit(GL_MAX_TEXTURE_SIZE), limit(GL_MAX_VIEWPORT_DIMS));
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
