#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <unordered_map>
#include <vector>

#include "data/topology/flat_triangle.h"
#include "data/topology/surface_place.h"

namespace aeolic {

/// Why a streamline ends. `stopped`: whoever followed it wanted no more.
enum class LineEnd { boundary, rest, masked, closed, longest, stopped };

/// A streamline on a surface.
struct SurfaceLine {
    std::vector<SurfacePlace> places;  ///< From where it begins.
    LineEnd end = LineEnd::longest;
    double lengthWorld = 0;
};

/// Which lines a tracer follows: those along the flow, or those that cross it at right angles, to the left.
enum class Along { flow, acrossFlow };

/// Follows the flow on a surface, from triangle to triangle. In each the flow is linear.
class SurfaceTracer {
public:
    explicit SurfaceTracer(const FlowSurface& surface, Along along = Along::flow) : surface_(surface), along_(along) {}

    /// The streamline from a place on, downstream (`direction` 1) or upstream (-1), as long as `longestWorld` at most.
    /// The places on it are no farther apart than a quarter of a triangle. A line that comes near a point at rest ends
    /// there, and one that comes back to itself is closed. Cost: some steps for each triangle that it passes.
    SurfaceLine trace(const SurfacePlace& from, int direction, double longestWorld) const;

    /// Called for each place on a line, the first included, with the way to it. Returns false to end the line there.
    using Visit = std::function<bool(const SurfacePlace& place, double lengthWorld)>;

    /// Follows the line that trace() gives, and visits its places, which are no farther apart than `stepWorld` and a
    /// triangle. Where the line runs along an edge, from one end to the other, they are as far apart as that is long.
    LineEnd follow(const SurfacePlace& from, int direction, double longestWorld, double stepWorld,
                   const Visit& visit) const;

    glm::dvec3 positionWorld(const SurfacePlace& place) const { return aeolic::positionWorld(surface_.mesh, place); }

private:
    struct Walk {
        SurfacePlace at;
        int direction;
        double longestWorld, stepWorld, stepPart;  // The last as a part of a triangle.
        const Visit& visit;
        glm::dvec3 lastWorld{0};
        double lengthWorld = 0;
        LineEnd end = LineEnd::longest;
        std::unordered_map<std::uint32_t, std::vector<double>> entered = {};  // Where half-edges were crossed.

        bool endsBy(LineEnd why)
        {
            end = why;
            return false;
        }
    };
    FlatTriangle flat(std::uint32_t triangle) const;
    LineEnd walk(Walk walk) const;
    std::optional<std::uint32_t> walkThrough(Walk& walk) const;
    bool enter(Walk& walk, std::uint32_t halfEdge) const;
    bool passPoint(Walk& walk, std::uint32_t corner) const;
    bool slide(Walk& walk, std::uint32_t halfEdge) const;
    bool add(Walk& walk) const;

    const FlowSurface surface_;
    Along along_;
};

}  // namespace aeolic
