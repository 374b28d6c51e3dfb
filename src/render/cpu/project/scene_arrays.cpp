#include "render/cpu/project/scene_arrays.h"

#include "base/parallel.h"

namespace aeolic::cpu {

void SceneArrays::update(bool triangles)
{
    constexpr std::size_t pad = 64;
    const SurfaceMesh& mesh = scene->surface;
    const std::size_t count = mesh.positions.size();
    vertices.resize(count);
    corners.resize(mesh.triangles.size());
    x.resize(count + pad);
    y.resize(count + pad);
    z.resize(count + pad);
    const VertexRecords records(*scene);
    constexpr std::uint32_t kBlocks = sizeof(VertexRecord) / 16;
    parallelRanges(triangles ? corners.size() : 0, 1 << 14, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto& t = mesh.triangles[i];
            corners[i] = {kBlocks * t[0], kBlocks * t[1], kBlocks * t[2], 0};
        }
    });
    parallelRanges(count, 1 << 14, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const VertexRecord& v = vertices[i] = records(i);
            x[i] = v.position[0];
            y[i] = v.position[1];
            z[i] = v.position[2];
        }
    });
    groups = groupTriangles(mesh, lengthUnit(*scene));
}

}  // namespace aeolic::cpu
