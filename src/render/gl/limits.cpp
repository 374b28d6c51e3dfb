#include "render/gl/limits.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <string>

#include "aeolic/error.h"
#include "render/gl/device_errors.h"

namespace aeolic::gl {
namespace {

std::uint64_t limit(GLenum name)
{
    GLint64 value = 0;
    glGetInteger64v(name, &value);
    return std::uint64_t(std::max<GLint64>(value, 0));
}

std::uint64_t textureBytes(const GridField& field)
{
    const std::uint64_t sample = field.precision == FieldPrecision::float16 ? 8 : 16;
    return field.sampleCount() * (field.components == 3 ? sample : 4);
}

std::string dimsText(const GridField& field)
{
    const GridIndex held = field.heldDims();
    return std::to_string(held[0]) + "x" + std::to_string(held[1]) + "x" + std::to_string(held[2]) + " samples";
}

void requireSides(const GridField& field)
{
    const std::uint64_t side = limit(GL_MAX_3D_TEXTURE_SIZE);
    const GridIndex held = field.heldDims();
    const auto longest = std::uint64_t(std::max({held[0], held[1], held[2]}));
    if (longest > side)
        throw InputError(field.name, dimsText(field) + ", more than a texture of this GPU takes",
                         "at most " + std::to_string(side) + " along each side: " +
                             std::to_string((longest + side - 1) / side * (field.brick ? 2 : 1)) +
                             " ranks or more with --bricks on, or --backend cpu");
}

std::uint64_t meshBytes(const SurfaceMesh& mesh)
{
    return mesh.positions.size() * 48 + mesh.triangles.size() * 12 + mesh.cellVectors.size() * 12 +
           mesh.cellScalars.size() * 4;
}

std::uint64_t fieldBytes(const Scene& scene)
{
    return (scene.field ? textureBytes(*scene.field) : 0) + (scene.scalarField ? textureBytes(*scene.scalarField) : 0);
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

void throwDoesNotFit(const Scene& scene)
{
    const auto free = freeMemoryBytes();
    const std::uint64_t mesh = meshBytes(scene.surface), field = fieldBytes(scene);
    const std::string limit = free ? "at most the " + megabytes(*free) + " that are free: " : "less: ";
    if (field <= mesh)
        throw InputError(
            scene.surface.name,
            std::to_string(scene.surface.triangles.size()) + " triangles take " + megabytes(mesh) + " of GPU memory",
            limit + "fewer ranks on this GPU, or --backend cpu");
    const GridField& larger = scene.field ? *scene.field : *scene.scalarField;
    std::string enough = "more GPUs";  // Every rank holds the whole surface, and its share of the field.
    if (free && *free > mesh) {
        const std::uint64_t number = std::max<std::uint64_t>(field / (*free - mesh) + 1, 2);
        enough = std::to_string(number) + (larger.brick ? " times as many GPUs" : " or more GPUs");
    }
    throw InputError(larger.name, dimsText(larger) + " take " + megabytes(field) + " of GPU memory",
                     limit + enough + " with --bricks on, --field-precision half, or --backend cpu");
}

void requireLimits(const Scene& scene, bool fresh)
{
    const SurfaceMesh& mesh = scene.surface;
    const std::uint64_t block = limit(GL_MAX_SHADER_STORAGE_BLOCK_SIZE);
    if (mesh.positions.size() * 48 > block || mesh.triangles.size() * 12 > block || mesh.triangles.size() >= 1u << 29)
        throw InputError(mesh.name, std::to_string(mesh.triangles.size()) + " triangles",
                         "at most " + std::to_string(std::min<std::uint64_t>(block / 12, (1u << 29) - 1)) +
                             " triangles and " + std::to_string(block / 48) + " points on this GPU, or --backend cpu");
    for (const auto& field : {scene.field, scene.scalarField})
        if (field) requireSides(*field);
    if (const auto free = freeMemoryBytes(); fresh && free && meshBytes(mesh) + fieldBytes(scene) > *free)
        throwDoesNotFit(scene);
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
