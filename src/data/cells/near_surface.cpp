#include "data/cells/near_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.h"

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

glm::ivec3 NearSurface::Coarse::boxOf(const glm::dvec3& point) const
{
    return glm::ivec3(glm::clamp((point - lo) * boxesPerWorld, glm::dvec3(0), glm::dvec3(count - 1)));
}

glm::dvec3 NearSurface::Coarse::middleOf(const glm::ivec3& box) const
{
    return lo + (glm::dvec3(box) + 0.5) / boxesPerWorld;
}

NearSurface::Coarse::Nearest NearSurface::nearestTo(const glm::dvec3& point) const
{
    double least = std::numeric_limits<double>::max(), reach = 0;
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

void NearSurface::prepare(const Bounds& bounds, std::size_t places)
{
    constexpr std::size_t placesOfBox = 64;
    const double side = std::cbrt(double(places / placesOfBox));
    if (zone_.triangles.empty() || !(side > 1) || !std::isfinite(bounds.diagonal())) return;
    const glm::dvec3 size = glm::max(bounds.hi - bounds.lo, glm::dvec3(1e-6 * bounds.diagonal()));
    const double middling = std::cbrt(size.x * size.y * size.z);
    if (!(middling > 0)) return;
    Coarse coarse;
    coarse.lo = bounds.lo;
    coarse.count = glm::ivec3(glm::clamp(glm::ceil(side * size / middling), glm::dvec3(1), glm::dvec3(256)));
    coarse.boxesPerWorld = glm::dvec3(coarse.count) / size;
    coarse.nearest.resize(coarse.boxes());
    parallelRanges(coarse.nearest.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto across = std::size_t(coarse.count.x), layer = across * std::size_t(coarse.count.y);
            const glm::ivec3 box(int(i % across), int(i % layer / across), int(i / layer));
            coarse.nearest[i] = nearestTo(coarse.middleOf(box));
        }
    });
    coarse_ = std::move(coarse);
}

bool NearSurface::isNear(const glm::dvec3& point, double more) const
{
    constexpr double aHair = 1e-9;
    if (zone_.triangles.empty()) return false;
    if (coarse_.nearest.empty()) return search(point, more);
    const glm::ivec3 box = coarse_.boxOf(point);
    const auto& [distance, reach] =
        coarse_.nearest[std::size_t((box.z * coarse_.count.y + box.y) * coarse_.count.x + box.x)];
    const double off = glm::distance(point, coarse_.middleOf(box));
    if ((1 - aHair) * distance - off > farthest_ + more) return false;
    if ((1 + aHair) * (distance + off) < reach + more) return true;
    return search(point, more);
}

bool NearSurface::search(const glm::dvec3& point, double more) const
{
    bool found = false;
    const double most = farthest_ + more;
    tree_.forEachNear(
        point, [&] { return found ? -1.0 : most * most; },
        [&](std::uint32_t i) {
            const double reach = zone_.reachWorld[i] + more;
            found = found || distanceSquared(point, zone_.triangles[i]) <= reach * reach;
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
