#include "data/cells/cell_geometry.h"

#include <algorithm>
#include <cmath>

#include "data/mesh/nearest_in_triangle.h"

namespace aeolic {
namespace {

constexpr double kInsideTolerance = 1e-9;  // Of a weight: points on a face are in both cells.

/// Whether the triangle's plane is surely farther from the point. No answer for triangles that hardly have an area.
bool isBeyond(double farthest, const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    constexpr double aHairMore = 1 + 1e-3, least = 1e-8;
    const glm::dvec3 ab = b - a, ac = c - a, across = glm::cross(ab, ac);
    const double height = glm::dot(across, p - a), area = glm::dot(across, across);
    return area > least * glm::dot(ab, ab) * glm::dot(ac, ac) &&
           height * height > aHairMore * farthest * farthest * area;
}

}  // namespace

bool within(const VolumeCells& cells, std::uint32_t cell, const glm::dvec3& point, CellPlace& place)
{
    const auto center = cellMean<glm::dvec3>(cells, cell, [&](std::uint32_t id) { return cells.points[id]; });
    const glm::dvec3 p = point - center;
    double best = -kInfinity;
    std::uint32_t number = 0;
    cells.forEachFace(cell, [&](Corners face) {
        const auto middle = faceMean<glm::dvec3>(face, [&](std::uint32_t id) { return cells.points[id]; });
        const glm::dvec3 f = middle - center;
        for (std::uint32_t side = 0; side < face.size(); ++side) {
            const glm::dvec3 a = cells.points[face[side]] - center,
                             b = cells.points[face[(side + 1) % face.size()]] - center;
            const double volume = glm::dot(glm::cross(f, a), b);
            const double wf = glm::dot(glm::cross(p, a), b) / volume, wa = glm::dot(glm::cross(f, p), b) / volume,
                         wb = glm::dot(glm::cross(f, a), p) / volume, wc = 1 - wf - wa - wb;
            const double least = std::min({wf, wa, wb, wc});
            if (!std::isfinite(wc) || !(least > best)) continue;  // Flat ones give none.
            best = least;
            place = {cell, number, side, {wc, wf, wa, wb}, 0};
        }
        ++number;
    });
    return best >= -kInsideTolerance;
}

CellPlace nearestOnFace(const VolumeCells& cells, Corners face, const glm::dvec3& point, double farthest)
{
    CellPlace nearest;
    nearest.distanceSquared = kInfinity;
    const auto middle = faceMean<glm::dvec3>(face, [&](std::uint32_t id) { return cells.points[id]; });
    for (std::uint32_t side = 0; side < face.size(); ++side) {
        const glm::dvec3 &corner = cells.points[face[side]], &next = cells.points[face[(side + 1) % face.size()]];
        if (farthest < kInfinity && isBeyond(farthest, point, middle, corner, next)) continue;
        const glm::dvec3 w = nearestInTriangle(point, middle, corner, next);
        const glm::dvec3 off = w.x * middle + w.y * corner + w.z * next - point;
        const double squared = glm::dot(off, off);
        if (squared < nearest.distanceSquared) nearest = {0, 0, side, {0, w.x, w.y, w.z}, squared};
    }
    return nearest;
}

CellPlace nearestOn(const VolumeCells& cells, std::uint32_t cell, const glm::dvec3& point, double farthest)
{
    CellPlace nearest;
    nearest.distanceSquared = kInfinity;
    std::uint32_t number = 0;
    cells.forEachFace(cell, [&](Corners face) {
        CellPlace candidate = nearestOnFace(cells, face, point, farthest);
        candidate.cell = cell;
        candidate.face = number++;
        if (candidate.distanceSquared < nearest.distanceSquared) nearest = candidate;
    });
    return nearest;
}

}  // namespace aeolic
