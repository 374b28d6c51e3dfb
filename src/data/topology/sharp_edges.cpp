#include "data/topology/sharp_edges.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "base/parallel.h"
#include "data/topology/flat_triangle.h"

namespace aeolic {
namespace {

/// The faces of a sharp edge turn by more than 40 degrees: the cosine.
constexpr double kSharp = 0.766;

/// Edges that meet make a corner where they bend by more than 45 degrees: the cosine between the ways along them.
constexpr double kStraightOn = -0.7;

/// A place on an edge, and which.
struct LaidPlace {
    SurfacePlace place;
    std::uint32_t halfEdge = 0;
};

/// Lays places on sharp edges at which the flow gathers that is followed in one direction.
class SharpEdges {
public:
    SharpEdges(const FlowSurface& surface, int direction) : surface_(surface), direction_(direction) {}

    /// The nearest place on such an edge, of those that begin or end at a corner of the place's triangle, if the place
    /// is beside it: a line that only passes by stays where it is. Nothing where there is none.
    std::optional<LaidPlace> nearestTo(const SurfacePlace& place)
    {
        if (!near_ || near_->triangle != place.triangle) near_ = edgesNear(place.triangle);
        const glm::dvec3 at = positionWorld(surface_.mesh, place);
        std::optional<LaidPlace> nearest;
        double least = 0;
        for (const std::uint32_t h : near_->halfEdges) {
            const auto laid = laidOn(at, h);
            if (!laid) continue;
            const double distance = glm::distance(positionWorld(surface_.mesh, laid->place), at);
            if (nearest && distance >= least) continue;
            nearest = laid;
            least = distance;
        }
        return nearest;
    }

    /// The nearest corner of the place's triangle in which such edges meet at an angle.
    std::optional<SurfacePlace> cornerBeside(const SurfacePlace& place)
    {
        std::optional<SurfacePlace> nearest;
        double most = 0;
        for (std::uint32_t c = 3 * place.triangle; c < 3 * place.triangle + 3; ++c) {
            if (!meetAtAngle(c) || (nearest && place.weight[int(c % 3)] <= most)) continue;
            most = place.weight[int(c % 3)];
            nearest = atCorner(c);
        }
        return nearest;
    }

    /// The point that two edges share; nothing where they share none or both.
    std::optional<SurfacePlace> between(std::uint32_t a, std::uint32_t b) const
    {
        const std::uint32_t endOfA = nextInTriangle(a), endOfB = nextInTriangle(b);
        const auto isOfB = [&](std::uint32_t c) { return pointAt(c) == pointAt(b) || pointAt(c) == pointAt(endOfB); };
        if (isOfB(a) == isOfB(endOfA)) return {};
        return atCorner(isOfB(a) ? a : endOfA);
    }

private:
    struct Near {
        std::uint32_t triangle = 0;
        std::vector<std::uint32_t> halfEdges;
    };
    Near edgesNear(std::uint32_t triangle) const
    {
        Near near{triangle, {}};
        for (std::uint32_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
            forEachCorner(surface_.fans, surface_.fans.fanOf[corner], [&](std::uint32_t c) {
                for (const std::uint32_t h : {c, SurfaceFans::previousInTriangle(c)})
                    if (gathers(h)) near.halfEdges.push_back(h);
            });
        return near;
    }

    static SurfacePlace atCorner(std::uint32_t corner)
    {
        SurfacePlace place{corner / 3, glm::dvec3(0)};
        place.weight[int(corner % 3)] = 1;
        return place;
    }

    bool meetAtAngle(std::uint32_t corner) const
    {
        std::vector<glm::dvec3> ways;
        // An edge that gathers has two triangles, of which the one to its left begins with it here.
        forEachCorner(surface_.fans, surface_.fans.fanOf[corner], [&](std::uint32_t c) {
            if (gathers(c)) ways.push_back(glm::normalize(edge(c)));
        });
        bool bends = false;
        for (const glm::dvec3& a : ways)
            for (const glm::dvec3& b : ways) bends = bends || (&a != &b && glm::dot(a, b) > kStraightOn);
        return bends;
    }

    /// Beside the edge, or beyond an end of it in which edges meet at an angle.
    std::optional<LaidPlace> laidOn(const glm::dvec3& atWorld, std::uint32_t halfEdge) const
    {
        const std::uint32_t end = nextInTriangle(halfEdge);
        const glm::dvec3 from = positionWorld(surface_.mesh, atCorner(halfEdge)), along = edge(halfEdge);
        const double part = glm::dot(atWorld - from, along) / glm::dot(along, along);
        if (part < 0)
            return meetAtAngle(halfEdge) ? std::optional(LaidPlace{atCorner(halfEdge), halfEdge}) : std::nullopt;
        if (part > 1) return meetAtAngle(end) ? std::optional(LaidPlace{atCorner(end), halfEdge}) : std::nullopt;
        SurfacePlace place{halfEdge / 3, glm::dvec3(0)};
        place.weight[int(halfEdge % 3)] = 1 - part;
        place.weight[int(end % 3)] = part;
        return LaidPlace{place, halfEdge};
    }
    glm::dvec3 edge(std::uint32_t halfEdge) const
    {
        const Triangle& t = surface_.mesh.triangles[halfEdge / 3];
        return glm::dvec3(surface_.mesh.positions[t[nextInTriangle(halfEdge) % 3]]) -
               glm::dvec3(surface_.mesh.positions[t[halfEdge % 3]]);
    }
    std::uint32_t pointAt(std::uint32_t corner) const { return surface_.fans.triangles[corner / 3][corner % 3]; }

    bool gathers(std::uint32_t halfEdge) const
    {
        const std::uint32_t twin = surface_.fans.twin[halfEdge];
        if (twin == SurfaceFans::kNone || surface_.field.masked[halfEdge / 3] || surface_.field.masked[twin / 3])
            return false;
        const auto normal = [&](std::uint32_t h) { return glm::normalize(areaVector(surface_.mesh, h / 3)); };
        return glm::dot(normal(halfEdge), normal(twin)) < kSharp && runsTo(halfEdge) && runsTo(twin);
    }

    /// Whether the flow at the triangle's other corner runs to a side.
    bool runsTo(std::uint32_t halfEdge) const
    {
        const FlatTriangle flat(surface_, halfEdge / 3);
        const glm::dvec2 side = flat.point[nextInTriangle(halfEdge) % 3] - flat.point[halfEdge % 3],
                         flow = flat.flow[SurfaceFans::previousInTriangle(halfEdge) % 3];
        return direction_ * glm::dot(flow, glm::dvec2(side.y, -side.x)) > 0;  // The triangle is to its left.
    }

    const FlowSurface surface_;
    int direction_;
    std::optional<Near> near_;  // Of the place before: lines have several in a triangle.
};

std::vector<SurfacePlace> laid(SharpEdges edges, const std::vector<SurfacePlace>& places)
{
    std::vector<SurfacePlace> out;
    std::optional<LaidPlace> last;
    for (const SurfacePlace& place : places) {
        const auto found = edges.nearestTo(place);
        if (last && found)
            if (const auto point = edges.between(last->halfEdge, found->halfEdge)) out.push_back(*point);
        out.push_back(found ? found->place : place);
        last = found;
    }
    return out;
}

/// Ends a line at a point, where it comes to it first: it may have been laid on what lies beyond a corner.
void endAt(const SurfaceMesh& mesh, const SurfacePlace& point, std::vector<SurfacePlace>& places)
{
    const glm::dvec3 at = positionWorld(mesh, point);
    const auto first =
        std::ranges::find_if(places, [&](const SurfacePlace& place) { return positionWorld(mesh, place) == at; });
    if (first != places.end()) places.erase(first + 1, places.end());
    if (places.size() > 1) places.pop_back();
    places.push_back(point);
}

/// Whether flow followed in that direction may come to the point along an edge.
bool mayGather(const CriticalPoint& point, int direction)
{
    if (point.kind == CriticalKind::saddle) return true;
    const bool isEnd = point.kind == CriticalKind::node || point.kind == CriticalKind::focus;
    return isEnd && point.attracts == (direction > 0);
}

}  // namespace

void layOnSharpEdges(const FlowSurface& surface, SurfaceTopology& topology)
{
    parallelFor(topology.lines.size(), [&](std::size_t i) {
        TopologyLine& line = topology.lines[i];
        line.places = laid(SharpEdges(surface, line.direction), line.places);
    });
    for (CriticalPoint& point : topology.points)
        for (const int direction : {1, -1}) {
            if (!mayGather(point, direction)) continue;
            SharpEdges edges(surface, direction);
            const auto found = edges.nearestTo(point.place);
            if (!found) continue;
            const auto corner = edges.cornerBeside(point.place);
            point.place = corner && point.kind != CriticalKind::saddle ? *corner : found->place;
            break;
        }
    for (TopologyLine& line : topology.lines) {
        line.places.front() = topology.points[line.saddle].place;
        if (line.other) endAt(surface.mesh, topology.points[*line.other].place, line.places);
        line.lengthWorld = lengthWorld(surface.mesh, line.places);
    }
}

}  // namespace aeolic
