#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "base/parallel.h"
#include "data/cells/cell_tree.h"
#include "data/cells/coarse_boxes.h"
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

    /// What isNear() is asked. A negative `more` asks nothing.
    struct Question {
        glm::dvec3 pointWorld;
        double more;
    };

    /// These `count` questions about places in `worldBounds` will follow: the answers stay, and most come quickly.
    /// `questionOf(i)`: one of them; any thread may call it. Cost: one pass over them, and a search that ends early for
    /// one place in some dozens.
    template <class QuestionOf>
    void prepare(const Bounds& worldBounds, std::size_t count, const QuestionOf& questionOf);

    /// Whether isNear() may be so for a point in a box, with so much `more` or less. Cost: a search that ends at the
    /// first triangle whose box is near enough.
    bool mayBeNear(const CellTree::Box& boxWorld, double more) const;

    /// Whether a point comes nearer to some triangle than that triangle's reach and `more` together, or as near.
    bool isNear(const glm::dvec3& pointWorld, double more) const;

    /// The same. `hint`: any number at first; it becomes that of a triangle that is near, which is tried first for the
    /// next point.
    bool isNear(const glm::dvec3& pointWorld, double more, std::uint32_t& hint) const;

private:
    /// How far the surface is from the middles of coarse boxes. It tells of most places whether they are near.
    struct Coarse {
        CoarseBoxes boxes;
        struct Nearest {
            double distance, reach;  ///< To the nearest triangle, and of that triangle.
        };
        std::vector<Nearest> nearest;  ///< [boxes]
    };

    /// [boxes] The largest `more` of the questions about places in each; negative where there is none.
    using MostAsked = std::vector<std::atomic<double>>;

    void measure(Coarse& coarse, const MostAsked& most) const;
    Coarse::Nearest nearestTo(const glm::dvec3& pointWorld, double within) const;
    bool search(const glm::dvec3& pointWorld, double more, std::uint32_t& hint) const;

    SurfaceZone zone_;
    CellTree tree_;
    double farthest_ = 0;  // The largest reach.
    Coarse coarse_;
};

template <class QuestionOf>
void NearSurface::prepare(const Bounds& worldBounds, std::size_t count, const QuestionOf& questionOf)
{
    coarse_ = {};
    if (zone_.triangles.empty()) return;
    Coarse coarse{CoarseBoxes(worldBounds, count), {}};
    if (coarse.boxes.size() == 0) return;
    MostAsked most(coarse.boxes.size());
    for (auto& each : most) each = -1;
    parallelRanges(count, 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Question question = questionOf(i);
            if (question.more < 0) continue;
            std::atomic<double>& largest = most[coarse.boxes.indexOf(question.pointWorld)];
            double known = largest.load(std::memory_order_relaxed);
            while (known < question.more &&
                   !largest.compare_exchange_weak(known, question.more, std::memory_order_relaxed)) {
            }
        }
    });
    measure(coarse, most);
    coarse_ = std::move(coarse);
}

/// The squared distance of a point from a triangle (Ericson, Real-Time Collision Detection, 2005, section 5.1.5).
double distanceSquared(const glm::dvec3& point, const std::array<glm::dvec3, 3>& triangle);

}  // namespace aeolic
