#pragma once

#include "data/scene.h"
#include "render/gl/device/objects.h"
#include "render/lic/noise.h"

namespace aeolic::gl {

/// The scene in the GPU's memory.
class GpuScene {
public:
    /// Throws InputError where a limit of the device is too small, and says how many ranks would be enough.
    explicit GpuScene(const Scene& scene);

    /// Takes over what changed in the scene. Memory is taken anew only where sizes changed.
    void update(const SceneChange& change);

    const Scene& scene() const { return *scene_; }
    void bindMesh() const;    ///< Storage buffers 0 to 3 of resolve.comp.
    void bindFields() const;  ///< Textures 1 to 3 of resolve.comp and its field block.
    void draw() const;        ///< All triangles, in order.
    std::size_t triangles() const { return std::size_t(indices_) / 3; }

    /// Makes the noise that of `seed` and `style`.
    void setNoise(std::uint32_t seed, Style style);

private:
    void loadMesh(bool triangles);
    void loadFields();

    const Scene* scene_;
    Buffer vertices_, triangles_, cellVectors_, cellScalars_, fieldBlock_;
    VertexArray array_;
    Texture field_, scalarField_, noise_;
    std::uint32_t noiseSeed_ = 0;
    Style noiseStyle_ = Style::dense;
    GLsizei indices_ = 0;
};

}  // namespace aeolic::gl
