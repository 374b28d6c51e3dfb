#include "data/topology/surface_topology.h"

#include <algorithm>
#include <iterator>

#include "data/topology/separatrices.h"

namespace aeolic {
namespace {

/// A line ends at a critical point that is no farther from its end than so many times the side of the triangle there.
constexpr double kNearSides = 1.5;

double sideOf(const SurfaceMesh& mesh, std::uint32_t triangle)
{
    const Triangle& t = mesh.triangles[triangle];
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
        longest = std::max(longest, double(glm::length(mesh.positions[t[(i + 1) % 3]] - mesh.positions[t[i]])));
    return longest;
}

/// The point of no saddle that a line runs into, or comes from.
std::optional<std::size_t> pointAt(const SurfaceMesh& mesh, const std::vector<CriticalPoint>& points,
                                   const SurfaceLine& line)
{
    if (line.end != LineEnd::rest) return {};
    const glm::dvec3 endWorld = positionWorld(mesh, line.places.back());
    std::optional<std::size_t> nearest;
    double least = kNearSides * sideOf(mesh, line.places.back().triangle);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].kind == CriticalKind::saddle) continue;
        const double distance = glm::length(positionWorld(mesh, points[i].place) - endWorld);
        if (distance <= least) nearest = i, least = distance;
    }
    return nearest;
}

double lengthOf(const SurfaceMesh& mesh, const std::vector<SurfacePlace>& places)
{
    double length = 0;
    for (std::size_t i = 1; i < places.size(); ++i)
        length += glm::length(positionWorld(mesh, places[i]) - positionWorld(mesh, places[i - 1]));
    return length;
}

void append(std::vector<SurfacePlace>& places, const std::vector<SurfacePlace>& more)
{
    places.insert(places.end(), more.begin(), more.end());
}

std::vector<TopologyLine> linesOf(const SurfaceMesh& mesh, const SurfaceFans& fans, const TangentField& field,
                                  const std::vector<CriticalPoint>& points, double longestWorld)
{
    std::vector<TopologyLine> lines;
    for (const Separatrix& separatrix : separatrices(mesh, fans, field, points, longestWorld)) {
        TopologyLine line{separatrix.saddle, {}, separatrix.direction, 0, {}};
        line.places.push_back(points[separatrix.saddle].place);
        append(line.places, separatrix.line.places);
        line.other = pointAt(mesh, points, separatrix.line);
        if (line.other) line.places.push_back(points[*line.other].place);
        line.lengthWorld = lengthOf(mesh, line.places);
        lines.push_back(std::move(line));
    }
    return lines;
}

/// Takes pairs of points out that cancel each other.
class Cancellation {
public:
    Cancellation(SurfaceTopology& topology, double leastWorld) : all_(topology), leastWorld_(leastWorld) {}

    void run()
    {
        gone_.assign(all_.points.size(), false);
        while (const std::optional<std::size_t> shortest = shortestLine()) cancel(*shortest);
        tidy();
    }

private:
    /// The shortest line between two points that may cancel: not those that are joined twice, which would leave a
    /// closed line without a point.
    std::optional<std::size_t> shortestLine() const
    {
        std::optional<std::size_t> best;
        for (std::size_t i = 0; i < all_.lines.size(); ++i) {
            const TopologyLine& line = all_.lines[i];
            if (!isThere(line) || !line.other || line.lengthWorld > leastWorld_) continue;
            if (all_.points[*line.other].index != 1 || isJoinedTwice(line)) continue;
            if (!best || line.lengthWorld < all_.lines[*best].lengthWorld) best = i;
        }
        return best;
    }
    bool isThere(const TopologyLine& line) const { return !gone_[line.saddle]; }
    bool isJoinedTwice(const TopologyLine& line) const
    {
        return std::count_if(all_.lines.begin(), all_.lines.end(), [&](const TopologyLine& other) {
                   return other.saddle == line.saddle && other.other == line.other;
               }) > 1;
    }

    void cancel(std::size_t which)
    {
        const TopologyLine between = all_.lines[which];
        const auto beyond = std::find_if(all_.lines.begin(), all_.lines.end(), [&](const TopologyLine& line) {
            return line.saddle == between.saddle && line.direction == between.direction && line.other != between.other;
        });
        for (TopologyLine& line : all_.lines) {
            if (!isThere(line) || line.saddle == between.saddle || line.other != between.other) continue;
            extend(line, {between.places.rbegin(), between.places.rend()}, between.lengthWorld);
            line.other.reset();
            if (beyond == all_.lines.end()) continue;
            extend(line, beyond->places, beyond->lengthWorld);
            line.other = beyond->other;
        }
        gone_[between.saddle] = gone_[*between.other] = true;
    }
    static void extend(TopologyLine& line, const std::vector<SurfacePlace>& more, double lengthWorld)
    {
        append(line.places, more);
        line.lengthWorld += lengthWorld;
    }

    void tidy()
    {
        std::vector<std::size_t> newNumber;
        std::vector<CriticalPoint> kept;
        for (std::size_t i = 0; i < gone_.size(); ++i) {
            newNumber.push_back(kept.size());
            if (!gone_[i]) kept.push_back(all_.points[i]);
        }
        std::erase_if(all_.lines, [&](const TopologyLine& line) { return !isThere(line); });
        for (TopologyLine& line : all_.lines) {
            line.saddle = newNumber[line.saddle];
            if (line.other) line.other = newNumber[*line.other];
        }
        all_.points = std::move(kept);
    }

    SurfaceTopology& all_;
    double leastWorld_;
    std::vector<bool> gone_;
};

}  // namespace

SurfaceTopology surfaceTopology(const SurfaceMesh& mesh, const std::vector<glm::vec3>& vectors,
                                const TopologyOptions& options)
{
    const SurfaceFans fans = surfaceFans(mesh);
    const TangentField field = tangentField(mesh, fans, vectors);
    const Bounds box = mesh.bounds();
    const double size = glm::length(box.hi - box.lo);
    SurfaceTopology topology;
    topology.points = criticalPoints(mesh, fans, field);
    topology.lines = linesOf(mesh, fans, field, topology.points, options.longest * size);
    Cancellation(topology, options.persistence * size).run();
    return topology;
}

}  // namespace aeolic
