#include "render/overlay/streamline_through.h"

#include <algorithm>

namespace aeolic {
namespace {

/// Okabe and Ito's reddish purple, made darker: no other overlay has it.
constexpr std::array<std::uint8_t, 3> kThroughColor{130, 30, 100}, kThroughCasing{255, 255, 255};
constexpr StrokeLook kComes{kThroughColor, kThroughCasing, 1.6f, 1.4f, 12},
    kLeaves{kThroughColor, kThroughCasing, 2.6f, 1.6f, 15};

/// Heads are this part of the surface's size apart.
constexpr double kHeadsApart = 0.08;

}  // namespace

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
