#include "data/topology/surface_topology.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/append.h"
#include "data/topology/separatrices.h"
#include "data/topology/sharp_edges.h"

namespace aeolic {
namespace {

/// A line ends at a critical point that is no farther from its end than so many times the side of the triangle there.
constexpr double kNearSides = 1.5;
/// Lines are no longer than this many times the surface's size.
constexpr double kLongest = 4;

double sideOf(const SurfaceMesh& mesh, std::uint32_t triangle)
{
    const Triangle& t = mesh.triangles[triangle];
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
        longest = std::max(longest, double(glm::length(mesh.positions[t[(i + 1) % 3]] - mesh.positions[t[i]])));
    return longest;
}

/// Critical points that lines can end in, by their places.
class Ends {
public:
    Ends(const SurfaceMesh& mesh, const std::vector<CriticalPoint>& points) : mesh_(mesh)
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            if (points[i].kind != CriticalKind::saddle) ends_.push_back({positionWorld(mesh, points[i].place), i});
        std::ranges::sort(ends_, [](const End& a, const End& b) {
            return a.atWorld.x < b.atWorld.x || (a.atWorld.x == b.atWorld.x && a.point < b.point);
        });
    }

    /// The one that a line runs into, or comes from.
    std::optional<std::size_t> of(const SurfaceLine& line) const
    {
        if (line.end != LineEnd::rest) return {};
        const glm::dvec3 at = positionWorld(mesh_, line.places.back());
        std::optional<std::size_t> nearest;
        double least = kNearSides * sideOf(mesh_, line.places.back().triangle);
        const double reach = least;
        auto end = std::lower_bound(ends_.begin(), ends_.end(), at.x - reach,
                                    [](const End& each, double x) { return each.atWorld.x < x; });
        for (; end != ends_.end() && end->atWorld.x <= at.x + reach; ++end) {
            const double distance = glm::length(end->atWorld - at);
            if (distance < least || (distance == least && (!nearest || end->point < *nearest)))
                nearest = end->point, least = distance;
        }
        return nearest;
    }

private:
    struct End {
        glm::dvec3 atWorld;
        std::size_t point;
    };
    const SurfaceMesh& mesh_;
    std::vector<End> ends_;
};

std::vector<TopologyLine> linesOf(const FlowSurface& surface, const std::vector<CriticalPoint>& points,
                                  double longestWorld)
{
    const Ends ends(surface.mesh, points);
    std::vector<TopologyLine> lines;
    for (const Separatrix& separatrix : separatrices(surface, points, longestWorld)) {
        TopologyLine line{separatrix.saddle, {}, separatrix.direction, 0, {}};
        line.places.push_back(points[separatrix.saddle].place);
        appendAll(line.places, separatrix.line.places);
        line.other = ends.of(separatrix.line);
        if (line.other) line.places.push_back(points[*line.other].place);
        line.lengthWorld = lengthWorld(surface.mesh, line.places);
        lines.push_back(std::move(line));
    }
    return lines;
}

/// Takes pairs of points out that cancel each other, the nearest first.
class Cancellation {
public:
    Cancellation(SurfaceTopology& topology, double leastWorld, double longestWorld)
        : all_(topology),
          leastWorld_(leastWorld),
          longestWorld_(longestWorld),
          ofSaddle_(topology.points.size()),
          atPoint_(topology.points.size()),
          gone_(topology.points.size(), false)
    {
        for (std::size_t i = 0; i < all_.lines.size(); ++i) {
            ofSaddle_[all_.lines[i].saddle].push_back(i);
            if (all_.lines[i].other) atPoint_[*all_.lines[i].other].push_back(i);
            wait(i);
        }
    }

    void run()
    {
        while (!waiting_.empty()) {
            const auto [lengthWorld, i] = *waiting_.begin();
            waiting_.erase(waiting_.begin());
            const TopologyLine& line = all_.lines[i];
            if (lengthWorld == line.lengthWorld && mayCancel(line)) cancel(i);
        }
        tidy();
    }

private:
    void wait(std::size_t i)
    {
        if (all_.lines[i].other) waiting_.emplace(all_.lines[i].lengthWorld, i);
    }

    /// Not those that are joined twice, which would leave a closed line without a point.
    bool mayCancel(const TopologyLine& line) const
    {
        if (gone_[line.saddle] || !line.other || gone_[*line.other] || line.lengthWorld > leastWorld_) return false;
        const auto joins = [&](std::size_t i) { return all_.lines[i].other == line.other; };
        const std::vector<std::size_t>& own = ofSaddle_[line.saddle];
        return all_.points[*line.other].index == 1 && std::ranges::count_if(own, joins) == 1;
    }

    void cancel(std::size_t which)
    {
        const TopologyLine between = all_.lines[which];
        const std::vector<std::size_t>& own = ofSaddle_[between.saddle];
        const auto other = std::ranges::find_if(
            own, [&](std::size_t i) { return i != which && all_.lines[i].direction == between.direction; });
        gone_[between.saddle] = gone_[*between.other] = true;
        for (const std::size_t i : std::vector(atPoint_[*between.other])) {
            TopologyLine& line = all_.lines[i];
            if (gone_[line.saddle] || line.other != between.other) continue;
            extend(line, {between.places.rbegin(), between.places.rend()}, between.lengthWorld);
            line.other.reset();
            if (other != own.end() && line.lengthWorld <= longestWorld_) {
                extend(line, all_.lines[*other].places, all_.lines[*other].lengthWorld);
                line.other = all_.lines[*other].other;
            }
            if (line.other) atPoint_[*line.other].push_back(i);
            // A point that two of its saddle's lines ended in may have one of them left.
            for (const std::size_t each : ofSaddle_[line.saddle]) wait(each);
        }
    }
    static void extend(TopologyLine& line, const std::vector<SurfacePlace>& more, double lengthWorld)
    {
        appendAll(line.places, more);
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
        std::erase_if(all_.lines, [&](const TopologyLine& line) { return gone_[line.saddle]; });
        for (TopologyLine& line : all_.lines) {
            line.saddle = newNumber[line.saddle];
            if (line.other) line.other = newNumber[*line.other];
        }
        all_.points = std::move(kept);
    }

    SurfaceTopology& all_;
    double leastWorld_, longestWorld_;
    std::vector<std::vector<std::size_t>> ofSaddle_, atPoint_;  // [points] Lines that begin and that end there.
    std::vector<bool> gone_;
    std::set<std::pair<double, std::size_t>> waiting_;  // Lines by their lengths.
};

/// The diagonal of the box of all points that have flow.
double sizeWithFlow(const SurfaceMesh& mesh, const std::vector<glm::vec3>& vectors)
{
    Bounds box;
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t point : triangle)
            if (std::isfinite(glm::length(glm::dvec3(vectors[point])))) box.add(glm::dvec3(mesh.positions[point]));
    return box.empty() ? 0 : glm::length(box.hi - box.lo);
}

}  // namespace

SurfaceTopology surfaceTopology(const SurfaceMesh& mesh, const std::vector<glm::vec3>& vectors, double persistence)
{
    const SurfaceFans fans = surfaceFans(mesh);
    const TangentField field = tangentField(mesh, fans, vectors);
    const FlowSurface surface{mesh, fans, field};
    const double size = sizeWithFlow(mesh, vectors);
    SurfaceTopology topology;
    topology.points = criticalPoints(surface);
    topology.lines = linesOf(surface, topology.points, kLongest * size);
    Cancellation(topology, persistence * size, kLongest * size).run();
    layOnSharpEdges(surface, topology);
    return topology;
}

}  // namespace aeolic
