#include "render/overlay/topology_lines.h"

namespace aeolic {
namespace {

using Rgb8 = std::array<std::uint8_t, 3>;

// The vermilion and the blue, made darker, of Okabe and Ito, "Color universal design" (2008).
constexpr Rgb8 kTo{213, 94, 0}, kFrom{0, 84, 150}, kNeither{20, 20, 20}, kCasing{255, 255, 255};

/// Okabe and Ito's reddish purple, made darker: no other overlay has it.
constexpr Rgb8 kThrough{130, 30, 100};
constexpr StrokeLook kComes{kThrough, kCasing, 1.6f, 1.4f, 12}, kLeaves{kThrough, kCasing, 2.6f, 1.6f, 15};

/// Heads are this part of the surface's size apart.
constexpr double kHeadsApart = 0.08;

MarkShape shapeOf(CriticalKind kind)
{
    switch (kind) {
        case CriticalKind::node:
            return MarkShape::disc;
        case CriticalKind::focus:
            return MarkShape::ringWithDot;
        case CriticalKind::centre:
        case CriticalKind::multiple:
            return MarkShape::ring;
        case CriticalKind::saddle:
            break;
    }
    return MarkShape::cross;
}

}  // namespace

std::vector<SurfaceLines::Style> topologyLines(const SurfaceTopology& topology, const SurfaceMesh& mesh)
{
    const auto positionOf = [&](const SurfacePlace& place) {
        return glm::vec3(positionWorld(mesh, place) - mesh.originWorld);
    };
    SurfaceLines::Style from{{.color = kFrom, .casing = kCasing}, {}, {}},
        to{{.color = kTo, .casing = kCasing}, {}, {}}, neither{{.color = kNeither, .casing = kCasing}, {}, {}};
    for (const TopologyLine& line : topology.lines) {
        std::vector<glm::vec3> points;
        for (const SurfacePlace& place : line.places) points.push_back(positionOf(place));
        (line.direction > 0 ? to : from).lines.push_back(std::move(points));
    }
    for (const CriticalPoint& point : topology.points) {
        const bool isEnd = point.kind == CriticalKind::node || point.kind == CriticalKind::focus;
        SurfaceLines::Style& style = !isEnd ? neither : point.attracts ? to : from;
        style.marks.push_back({positionOf(point.place), shapeOf(point.kind)});
    }
    return {std::move(from), std::move(to), std::move(neither)};
}

std::vector<SurfaceLines::Style> openLines(const StreamlineSurface& surface, const std::vector<SeparationLine>& lines)
{
    const auto unit = float(surface.unitWorld());
    const double apart = 0.06 * surface.size() * surface.unitWorld();
    SurfaceLines::Style from{{.color = kFrom, .casing = kCasing, .markPx = 14}, {}, {}},
        to{{.color = kTo, .casing = kCasing, .markPx = 14}, {}, {}};
    for (const SeparationLine& line : lines) {
        SurfaceLines::Style& style = line.separates ? to : from;
        std::vector<glm::vec3> points;
        for (const SurfacePlace& place : line.places) points.push_back(surface.at(place) * unit);
        addHeads(points, apart, style);
        style.lines.push_back(std::move(points));
    }
    return {std::move(from), std::move(to)};
}

std::vector<SurfaceLines::Style> streamlineThrough(const StreamlineSurface& surface, const glm::dvec3& pointWorld)
{
    if (surface.area() == 0) return {};
    const SurfacePlace place = surface.nearest(pointWorld);
    const auto unit = float(surface.unitWorld());
    auto parts = surface.through(place);
    std::vector<SurfaceLines::Style> styles{{kComes, {}, {}}, {kLeaves, {}, {}}};
    for (std::size_t i = 0; i < 2; ++i) {
        for (glm::vec3& point : parts[i]) point *= unit;
        addHeads(parts[i], kHeadsApart * surface.size() * surface.unitWorld(), styles[i]);
        styles[i].lines.push_back(std::move(parts[i]));
    }
    styles[1].marks.push_back({surface.at(place) * unit, MarkShape::disc});
    return styles;
}

}  // namespace aeolic
