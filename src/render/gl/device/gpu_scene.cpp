#include "render/gl/device/gpu_scene.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "base/parallel.h"
#include "base/uninitialized.h"
#include "data/field_tiles.h"
#include "render/gl/device/device_errors.h"
#include "render/gl/device/gl_blocks.h"
#include "render/gl/device/scene_limits.h"
#include "render/vertex_record.h"

namespace aeolic::gl {
namespace {

std::vector<VertexRecord> vertexRecords(const Scene& scene)
{
    const VertexRecords recordOf(scene);
    std::vector<VertexRecord> records(scene.surface.positions.size());
    parallelRanges(records.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) records[i] = recordOf(i);
    });
    return records;
}

/// Each from the same corner on, so that rasterizers give triangles in the same place the same depths.
std::vector<std::array<std::uint32_t, 3>> fromFirstCorners(const SurfaceMesh& mesh)
{
    std::vector<std::array<std::uint32_t, 3>> triangles(mesh.triangles);
    const auto comesFirst = [&](std::uint32_t a, std::uint32_t b) {
        const glm::vec3 &p = mesh.positions[a], &q = mesh.positions[b];
        return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
    };
    parallelRanges(triangles.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            std::rotate(triangles[i].begin(), std::min_element(triangles[i].begin(), triangles[i].end(), comesFirst),
                        triangles[i].end());
    });
    return triangles;
}

template <class T>
void load(const std::vector<T>& values, Buffer& buffer)
{
    const std::size_t bytes = values.size() * sizeof(T);
    if (buffer.bytes() == std::max<std::size_t>(bytes, 4)) return buffer.write(0, bytes, values.data());
    buffer = Buffer();  // Before the new one is taken: never both.
    buffer = Buffer(bytes, GL_DYNAMIC_STORAGE_BIT, values.data());
}

void copySlices(const GridField& field, int first, int count, Bytes& out)
{
    const GridIndex held = field.heldDims();
    const std::size_t rowBytes = std::size_t(held[0]) * field.sampleBytes();
    parallelRanges(std::size_t(count * held[1]), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row)
            copyRow(field, std::int64_t(row) % held[1], first + std::int64_t(row) / held[1],
                    out.data() + row * rowBytes);
    });
}

// Slab by slab: a driver may keep a copy of what it is given at once.
void load(const GridField& field, Texture& texture)
{
    const GridIndex held = field.heldDims();
    const bool half = field.precision == FieldPrecision::float16, vectors = field.components == 3;
    const int width = int(held[0]), height = int(held[1]), depth = int(held[2]);
    const GLenum format = vectors ? (half ? GL_RGBA16F : GL_RGBA32F) : GL_R32F;
    const bool empty = width < 1 || height < 1 || depth < 1;  // A brick of no cells: never looked up.
    const bool fits = texture && texture.format() == format && texture.width() == width && texture.height() == height &&
                      texture.depth() == depth;
    if (!fits) {
        texture = {};  // Before the new one is taken: never both.
        texture = empty ? Texture::volume(format, 1, 1, 1) : Texture::volume(format, width, height, depth);
    }
    if (empty) return;
    const std::size_t sliceBytes =
        std::size_t(width) * std::size_t(height) * std::size_t(field.components) * (half ? 2 : 4);
    const int slices = int(std::clamp<std::size_t>((std::size_t{64} << 20) / sliceBytes, 1, std::size_t(depth)));
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    Bytes rows(field.tiled ? std::size_t(slices) * sliceBytes : 0);
    for (int z = 0; z < depth; z += slices) {
        const int count = std::min(slices, depth - z);
        const std::byte* from = static_cast<const std::byte*>(field.samples.get()) + std::size_t(z) * sliceBytes;
        if (field.tiled) {
            copySlices(field, z, count, rows);
            from = rows.data();
        }
        glTextureSubImage3D(texture.id(), 0, 0, 0, z, width, height, count, vectors ? GL_RGB : GL_RED,
                            half ? GL_HALF_FLOAT : GL_FLOAT, from);
    }
}

}  // namespace

GpuScene::GpuScene(const Scene& scene) : scene_(&scene)
{
    requireLimits(sizesOf(scene), deviceLimits(), true);
    loadMesh(true);
    loadFields();
}

void GpuScene::update(const SceneChange& change)
{
    requireLimits(sizesOf(*scene_), deviceLimits(), false);
    if (change.surface) loadMesh(change.triangles);
    if (change.surface || change.field) loadFields();  // Look-ups count from the surface's origin.
}

void GpuScene::loadMesh(bool triangles)
{
    const SurfaceMesh& mesh = scene_->surface;
    load(vertexRecords(*scene_), vertices_);
    load(mesh.cellVectors, cellVectors_);
    load(mesh.cellScalars, cellScalars_);
    if (!triangles) return;
    load(fromFirstCorners(mesh), triangles_);
    indices_ = GLsizei(3 * mesh.triangles.size());

    GLuint id = 0;
    glCreateVertexArrays(1, &id);
    array_ = VertexArray(id);
    glVertexArrayElementBuffer(id, triangles_.id());
    glVertexArrayVertexBuffer(id, 0, vertices_.id(), 0, sizeof(VertexRecord));
    glVertexArrayAttribFormat(id, 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(id, 0, 0);
    glEnableVertexArrayAttrib(id, 0);
    checkErrors("loading the surface");
}

void GpuScene::loadFields()
{
    const glm::dvec3& origin = scene_->surface.originWorld;
    const double unit = lengthUnit(*scene_);
    std::vector<FieldLookup> lookups(2);
    if (scene_->field) {
        lookups[0] = makeFieldLookup(*scene_->field, origin, unit);
        load(*scene_->field, field_);
    }
    if (scene_->scalarField) {
        lookups[1] = makeFieldLookup(*scene_->scalarField, origin, unit);
        load(*scene_->scalarField, scalarField_);
    }
    load(lookups, fieldBlock_);
    checkErrors("loading the field");
}

void GpuScene::setNoise(std::uint32_t seed, Style style)
{
    if (noise_ && noiseSeed_ == seed && noiseStyle_ == style) return;
    const NoisePyramid pyramid(seed, style);
    constexpr int size = NoisePyramid::kSize;
    if (!noise_) noise_ = Texture::volume(GL_R8UI, size, size, size);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage3D(noise_.id(), 0, 0, 0, 0, size, size, size, GL_RED_INTEGER, GL_UNSIGNED_BYTE,
                        pyramid.cells.data());
    noiseSeed_ = seed;
    noiseStyle_ = style;
}

void GpuScene::bindMesh() const
{
    const Buffer* buffers[] = {&triangles_, &vertices_, &cellVectors_, &cellScalars_};
    for (GLuint i = 0; i < 4; ++i) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, buffers[i]->id());
}

void GpuScene::bindFields() const
{
    glBindBufferBase(GL_UNIFORM_BUFFER, kFieldBinding, fieldBlock_.id());
    if (field_) field_.bind(1);
    if (scalarField_) scalarField_.bind(2);
    noise_.bind(3);
}

void GpuScene::draw() const
{
    glBindVertexArray(array_);
    glDrawElements(GL_TRIANGLES, indices_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace aeolic::gl
