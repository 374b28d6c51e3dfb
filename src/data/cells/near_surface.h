#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "data/cells/cell_tree.h"
#include "data/mesh/surface_mesh.h"

namespace aeolic {

/// Triangles in the world, and how far around each of them something may be looked up.
struct SurfaceZone {
    std::vector<std::array<glm::dvec3, 3>> triangles;
    std::vector<double> reachWorld;  ///< [triangles]

    /// The mesh's triangles. `reachWorld`: [points], or empty: on the surface alone. A triangle has the largest of its
    /// corners'.
    SurfaceZone(const SurfaceMesh& mesh, const std::vector<double>& reachWorld);

    /// Points alone, each with its own reach.
    SurfaceZone(const std::vector<glm::dvec3>& pointsWorld, const std::vector<double>& reachWorld);
};

/// Tells which places are near a surface. Immutable, so any number of threads may ask.
class NearSurface {
public:
    /// Cost: O(n log n).
    explicit NearSurface(SurfaceZone zone);

    /// Asks about as many as `places` places in `worldBounds` will follow: the answers stay, and most come quickly.
    /// Cost: a search for one place in some dozens.
    void prepare(const Bounds& worldBounds, std::size_t places);

    /// Whether a point comes nearer to some triangle than that triangle's reach and `more` together, or as near.
    bool isNear(const glm::dvec3& pointWorld, double more) const;

private:
    /// How far the surface is from the middles of coarse boxes. It tells of most places whether they are near.
    struct Coarse {
        glm::dvec3 lo{0}, boxesPerWorld{0};
        glm::ivec3 count{0};
        struct Nearest {
            double distance, reach;  ///< To the nearest triangle, and of that triangle.
        };
        std::vector<Nearest> nearest;  ///< [boxes]

        std::size_t boxes() const { return std::size_t(count.x) * std::size_t(count.y) * std::size_t(count.z); }
        glm::ivec3 boxOf(const glm::dvec3& pointWorld) const;
        glm::dvec3 middleOf(const glm::ivec3& box) const;
    };

    Coarse::Nearest nearestTo(const glm::dvec3& pointWorld) const;
    bool search(const glm::dvec3& pointWorld, double more) const;

    SurfaceZone zone_;
    CellTree tree_;
    double farthest_ = 0;  // The largest reach.
    Coarse coarse_;
};

/// The squared distance of a point from a triangle (Ericson, Real-Time Collision Detection, 2005, section 5.1.5).
double distanceSquared(const glm::dvec3& point, const std::array<glm::dvec3, 3>& triangle);

}  // namespace aeolic
