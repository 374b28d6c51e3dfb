#include "render/cpu/project/scene_arrays.h"

#include "base/parallel.h"

namespace aeolic::cpu {

SceneArrays::SceneArrays(const Scene& theScene) : scene(&theScene)
{
    update(true);
}

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
    constexpr std::uint32_t kBlocks = sizeof(VertexRecord) / 16;
    parallelRanges(triangles ? corners.size() : 0, 1 << 14, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto& t = mesh.triangles[i];
            corners[i] = {kBlocks * t[0], kBlocks * t[1], kBlocks * t[2], 0};
        }
    });
    parallelRanges(count, 1 << 14, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            VertexRecord& v = vertices[i];
            const glm::vec3 &p = mesh.positions[i], &n = mesh.normals[i];
            const glm::vec3 u = mesh.pointVectors.empty() ? glm::vec3(0) : mesh.pointVectors[i];
            v = {{p.x, p.y, p.z}, n.x, n.y, n.z, mesh.pointScalars.empty() ? 0.0f : mesh.pointScalars[i], 0,
                 {u.x, u.y, u.z}, 0};
            x[i] = v.position[0];
            y[i] = v.position[1];
            z[i] = v.position[2];
        }
    });
    groups = groupTriangles(mesh);
}

}  // namespace aeolic::cpu
