#include "render/gl/limits.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <string>

#include "aeolic/error.h"

namespace aeolic::gl {
namespace {

std::uint64_t limit(GLenum name)
{
    GLint64 value = 0;
    glGetInteger64v(name, &value);
    return std::uint64_t(std::max<GLint64>(value, 0));
}

std::string megabytes(std::uint64_t bytes)
{
    return std::to_string(bytes >> 20) + " MB";
}

std::uint64_t textureBytes(const GridField& field)
{
    const std::uint64_t sample = field.precision == FieldPrecision::float16 ? 8 : 16;
    return field.sampleCount() * (field.components == 3 ? sample : 4);
}

void requireField(const GridField& field, bool fresh)
{
    const std::uint64_t side = limit(GL_MAX_3D_TEXTURE_SIZE), bytes = textureBytes(field);
    const GridIndex held = field.heldDims();
    const std::string dims =
        std::to_string(held[0]) + "x" + std::to_string(held[1]) + "x" + std::to_string(held[2]) + " samples";
    const auto longest = std::uint64_t(std::max({held[0], held[1], held[2]}));
    if (longest > side)
        throw InputError(field.name, dims + ", more than a texture of this GPU takes",
                         "at most " + std::to_string(side) + " along each side: " +
                             std::to_string((longest + side - 1) / side * (field.brick ? 2 : 1)) +
                             " ranks or more with --bricks on, or --backend cpu");
    const auto free = fresh ? freeMemoryBytes() : std::nullopt;
    if (free && bytes > *free)
        throw InputError(field.name, dims + " take " + megabytes(bytes) + " of GPU memory",
                         "at most the " + megabytes(*free) +
                             " that are free: " + std::to_string(bytes / std::max<std::uint64_t>(*free, 1) + 1) +
                             " GPUs or more with --bricks on, --field-precision half, or --backend cpu");
}

}  // namespace

std::optional<std::uint64_t> freeMemoryBytes()
{
    if (epoxy_has_gl_extension("GL_NVX_gpu_memory_info")) {
        GLint kilobytes = 0;
        glGetIntegerv(GL_GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX, &kilobytes);
        return std::uint64_t(kilobytes) << 10;
    }
    return std::nullopt;
}

void requireLimits(const Scene& scene, bool fresh)
{
    const SurfaceMesh& mesh = scene.surface;
    const std::uint64_t block = limit(GL_MAX_SHADER_STORAGE_BLOCK_SIZE);
    if (mesh.positions.size() * 48 > block || mesh.triangles.size() * 12 > block || mesh.triangles.size() >= 1u << 29)
        throw InputError(mesh.name, std::to_string(mesh.triangles.size()) + " triangles",
                         "at most " + std::to_string(std::min<std::uint64_t>(block / 12, (1u << 29) - 1)) +
                             " triangles and " + std::to_string(block / 48) + " points on this GPU, or --backend cpu");
    if (scene.field) requireField(*scene.field, fresh);
    if (scene.scalarField) requireField(*scene.scalarField, fresh);
}

void requireFrame(int width, int height, int rows, std::uint64_t bytesPerPixel)
{
    const std::uint64_t side = std::min(limit(GL_MAX_TEXTURE_SIZE), limit(GL_MAX_VIEWPORT_DIMS));
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    if (std::uint64_t(std::max(width, height)) > side)
        throw InputError("--size", size, "at most " + std::to_string(side) + " pixels a side on this GPU");
    const std::uint64_t bytes = std::uint64_t(width) * std::uint64_t(rows) * bytesPerPixel;
    const auto free = freeMemoryBytes();
    if (free && bytes > *free)
        throw InputError("--size", size + " takes " + megabytes(bytes) + " of GPU memory",
                         "at most the " + megabytes(*free) + " that are free: a smaller picture, or more ranks");
}

}  // namespace aeolic::gl
