#include "data/cells/near_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace aeolic {
namespace {

std::vector<CellTree::Box> boxesOf(const SurfaceZone& zone)
{
    std::vector<CellTree::Box> boxes(zone.triangles.size());
    parallelRanges(boxes.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Bounds box;
            for (const glm::dvec3& corner : zone.triangles[i]) box.add(corner);
            boxes[i] = CellTree::Box::around(box);
        }
    });
    return boxes;
}

}  // namespace

SurfaceZone::SurfaceZone(const SurfaceMesh& mesh, const std::vector<double>& reach)
{
    triangles.reserve(mesh.triangles.size());
    reachWorld.reserve(mesh.triangles.size());
    for (const auto& corners : mesh.triangles) {
        std::array<glm::dvec3, 3> places;
        double most = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            places[k] = mesh.originWorld + glm::dvec3(mesh.positions[corners[k]]);
            if (!reach.empty()) most = std::max(most, reach[corners[k]]);
        }
        triangles.push_back(places);
        reachWorld.push_back(most);
    }
}

SurfaceZone::SurfaceZone(const std::vector<glm::dvec3>& pointsWorld, const std::vector<double>& reach)
    : reachWorld(reach)
{
    triangles.reserve(pointsWorld.size());
    for (const glm::dvec3& point : pointsWorld) triangles.push_back({point, point, point});
}

NearSurface::NearSurface(SurfaceZone zone) : zone_(std::move(zone)), tree_(boxesOf(zone_))
{
    for (const double reach : zone_.reachWorld) farthest_ = std::max(farthest_, reach);
}

/// The nearest triangle within so many world units; no reach at that distance where there is none.
NearSurface::Coarse::Nearest NearSurface::nearestTo(const glm::dvec3& point, double within) const
{
    double least = within * within, reach = -std::numeric_limits<double>::infinity();
    tree_.forEachNear(
        point, [&] { return least; },
        [&](std::uint32_t i) {
            const double squared = distanceSquared(point, zone_.triangles[i]);
            if (squared >= least) return;
            least = squared;
            reach = zone_.reachWorld[i];
        });
    return {std::sqrt(least), reach};
}

/// In a box nothing is looked for beyond the distances asked there: most boxes of a volume are far from a surface.
void NearSurface::measure(Coarse& coarse, const MostAsked& most) const
{
    constexpr double aHairMore = 1 + 1e-6;
    const double half = 0.5 * glm::length(1.0 / coarse.boxes.boxesPerWorld);
    coarse.nearest.resize(coarse.boxes.size());
    parallelRanges(coarse.nearest.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const double within = aHairMore * (farthest_ + std::max(0.0, most[i].load()) + half);
            coarse.nearest[i] = nearestTo(coarse.boxes.middleOf(i), within);
        }
    });
}

bool NearSurface::mayBeNear(const CellTree::Box& box, double more) const
{
    constexpr double aHairMore = 1 + 1e-9;
    if (zone_.triangles.empty()) return false;
    bool found = false;
    const double most = aHairMore * (farthest_ + more);
    tree_.forEachNear(
        box, [&] { return found ? -1.0 : most * most; }, [&](std::uint32_t) { found = true; });
    return found;
}

bool NearSurface::isNear(const glm::dvec3& point, double more) const
{
    std::uint32_t hint = 0;
    return isNear(point, more, hint);
}

bool NearSurface::isNear(const glm::dvec3& point, double more, std::uint32_t& hint) const
{
    constexpr double aHair = 1e-9;
    if (zone_.triangles.empty()) return false;
    if (coarse_.nearest.empty()) return search(point, more, hint);
    const std::size_t box = coarse_.boxes.indexOf(point);
    const auto& [distance, reach] = coarse_.nearest[box];
    const double off = glm::distance(point, coarse_.boxes.middleOf(box));
    if ((1 - aHair) * distance - off > farthest_ + more) return false;
    if ((1 + aHair) * (distance + off) < reach + more) return true;
    return search(point, more, hint);
}

bool NearSurface::search(const glm::dvec3& point, double more, std::uint32_t& hint) const
{
    const auto reaches = [&](std::uint32_t i) {
        const double reach = zone_.reachWorld[i] + more;
        return distanceSquared(point, zone_.triangles[i]) <= reach * reach;
    };
    if (hint < zone_.triangles.size() && reaches(hint)) return true;
    bool found = false;
    const double most = farthest_ + more;
    tree_.forEachNear(
        point, [&] { return found ? -1.0 : most * most; },
        [&](std::uint32_t i) {
            if (found || !reaches(i)) return;
            found = true;
            hint = i;
        });
    return found;
}

double distanceSquared(const glm::dvec3& p, const std::array<glm::dvec3, 3>& triangle)
{
    const auto& [a, b, c] = triangle;
    const glm::dvec3 ab = b - a, ac = c - a;
    const auto from = [&](const glm::dvec3& q) { return glm::dot(p - q, p - q); };
    const double d1 = glm::dot(ab, p - a), d2 = glm::dot(ac, p - a);
    if (d1 <= 0 && d2 <= 0) return from(a);
    const double d3 = glm::dot(ab, p - b), d4 = glm::dot(ac, p - b);
    if (d3 >= 0 && d4 <= d3) return from(b);
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return from(d1 > d3 ? a + d1 / (d1 - d3) * ab : a);
    const double d5 = glm::dot(ab, p - c), d6 = glm::dot(ac, p - c);
    if (d6 >= 0 && d5 <= d6) return from(c);
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return from(d2 > d6 ? a + d2 / (d2 - d6) * ac : a);
    const double va = d3 * d6 - d5 * d4, onBc = (d4 - d3) + (d5 - d6);
    if (va <= 0 && d4 >= d3 && d5 >= d6) return from(onBc > 0 ? b + (d4 - d3) / onBc * (c - b) : b);
    const double sum = va + vb + vc;
    return from(sum > 0 ? a + vb / sum * ab + vc / sum * ac : a);
}

}  // namespace aeolic
