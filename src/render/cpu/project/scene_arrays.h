#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/large_memory.h"
#include "data/scene.h"
#include "render/cpu/project/raster/triangle_groups.h"
#include "render/vertex_record.h"

namespace aeolic::cpu {

/// The scene rearranged for the kernels; nothing here depends on the camera.
struct SceneArrays {
    LargeVector<VertexRecord> vertices;
    /// Where the records of each triangle's points begin, in blocks of 128 bits: one load brings all three.
    LargeVector<std::array<std::uint32_t, 4>> corners;
    std::vector<float> x, y, z;  ///< Positions again, for the vertex transform; padded to whole vectors.
    std::vector<TriangleGroup> groups;
    const Scene* scene = nullptr;

    explicit SceneArrays(const Scene& theScene) : scene(&theScene) { update(true); }

    /// After the scene's points or arrays have changed, and, where it says so, its triangles.
    void update(bool triangles);
};

}  // namespace aeolic::cpu
