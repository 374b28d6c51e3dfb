#pragma once

#include <cstdint>
#include <vector>

#include "data/scene.h"

namespace aeolic::cpu {

/// One surface point as the resolve stage gathers it: all it needs of a vertex on one cache line.
struct alignas(16) VertexRecord {
    float position[3];
    float normal[3];
    float vector[3];
    float scalar;
    float unused[2];  // Keeps the record at 48 bytes.
};
static_assert(sizeof(VertexRecord) == 48);

/// The scene rearranged once for the kernels; nothing here depends on the camera.
struct SceneArrays {
    std::vector<VertexRecord> vertices;
    std::vector<float> x, y, z;          ///< Positions again, for the vertex transform; padded to whole vectors.
    const Scene* scene = nullptr;

    explicit SceneArrays(const Scene& scene);
};

}  // namespace aeolic::cpu
