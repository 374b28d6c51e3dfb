#pragma once

#include <array>
#include <vector>

#include "data/mesh/surface_mesh.h"
#include "render/overlay/strokes.h"

namespace aeolic {

/// The sides of a surface's triangles. Where they are short in the picture they fade, so that a fine mesh does not
/// hide the surface.
class MeshEdges final : public SurfaceOverlay {
public:
    /// Cost: O(triangles).
    explicit MeshEdges(const SurfaceMesh& mesh);

    /// Cost: O(edges), parallel, and drawStrokes().
    void draw(const View& view, const SeenSurface& seen, Tile& out) const override;

private:
    std::vector<std::array<glm::vec3, 2>> edges_;  // Beside the mesh's originWorld.
};

/// A surface's lines in a technical drawing: silhouettes, creases and borders. A silhouette runs where the normal,
/// which is linear in each triangle, is at right angles to the line of sight (Hertzmann and Zorin, "Illustrating smooth
/// surfaces", SIGGRAPH 2000, section 4). A crease is an edge at which points have two normals.
class SurfaceOutline final : public SurfaceOverlay {
public:
    /// Cost: O(triangles); positions, normals and triangles are copied.
    explicit SurfaceOutline(const SurfaceMesh& mesh);

    /// Cost: O(triangles), parallel, and drawStrokes().
    void draw(const View& view, const SeenSurface& seen, Tile& out) const override;

private:
    std::vector<glm::vec3> positions_, normals_;  // [points]
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<std::array<glm::vec3, 2>> features_;  // Creases and borders.
};

}  // namespace aeolic
