#include "data/cells/cell_geometry.h"

#include <algorithm>
#include <cmath>

#include "data/mesh/nearest_in_triangle.h"

namespace aeolic {
namespace {

constexpr double kInsideTolerance = 1e-9;  // Of a weight: points on a face are in both cells.

/// Calls visit(face, side, centre of the face, corner, next corner) for all tetrahedra of a cell.
template <class Visit>
void forEachTetra(const VolumeCells& cells, std::size_t cell, const Visit& visit)
{
    std::uint32_t number = 0;
    cells.forEachFace(cell, [&](Corners face) {
        const auto middle = faceMean<glm::dvec3>(face, [&](std::uint32_t id) { return cells.points[id]; });
        for (std::uint32_t side = 0; side < face.size(); ++side)
            visit(number, side, middle, cells.points[face[side]], cells.points[face[(side + 1) % face.size()]]);
        ++number;
    });
}

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
    forEachTetra(cells, cell,
                 [&](std::uint32_t face, std::uint32_t side, const glm::dvec3& middle, const glm::dvec3& corner,
                     const glm::dvec3& next) {
                     const glm::dvec3 f = middle - center, a = corner - center, b = next - center;
                     const double volume = glm::dot(glm::cross(f, a), b);
                     const double wf = glm::dot(glm::cross(p, a), b) / volume,
                                  wa = glm::dot(glm::cross(f, p), b) / volume,
                                  wb = glm::dot(glm::cross(f, a), p) / volume, wc = 1 - wf - wa - wb;
                     const double least = std::min({wf, wa, wb, wc});
                     if (!std::isfinite(wc) || !(least > best)) return;  // Flat ones give none.
                     best = least;
                     place = {cell, face, side, {wc, wf, wa, wb}, 0};
                 });
    return best >= -kInsideTolerance;
}

bool touches(const VolumeCells& cells, std::uint32_t cell, const glm::dvec3& point, double farthest, CellPlace& place)
{
    CellPlace nearest;
    nearest.distanceSquared = kInfinity;
    forEachTetra(cells, cell,
                 [&](std::uint32_t face, std::uint32_t side, const glm::dvec3& middle, const glm::dvec3& corner,
                     const glm::dvec3& next) {
                     if (isBeyond(farthest, point, middle, corner, next)) return;
                     const glm::dvec3 w = nearestInTriangle(point, middle, corner, next);
                     const glm::dvec3 off = w.x * middle + w.y * corner + w.z * next - point;
                     const double squared = glm::dot(off, off);
                     if (squared < nearest.distanceSquared) nearest = {cell, face, side, {0, w.x, w.y, w.z}, squared};
                 });
    if (!(nearest.distanceSquared <= farthest * farthest)) return false;
    place = nearest;
    return true;
}

CellPlace nearestOnFace(const VolumeCells& cells, Corners face, const glm::dvec3& point)
{
    CellPlace nearest;
    nearest.distanceSquared = kInfinity;
    const auto middle = faceMean<glm::dvec3>(face, [&](std::uint32_t id) { return cells.points[id]; });
    for (std::uint32_t side = 0; side < face.size(); ++side) {
        const glm::dvec3 &corner = cells.points[face[side]], &next = cells.points[face[(side + 1) % face.size()]];
        const glm::dvec3 w = nearestInTriangle(point, middle, corner, next);
        const glm::dvec3 off = w.x * middle + w.y * corner + w.z * next - point;
        const double squared = glm::dot(off, off);
        if (squared < nearest.distanceSquared) nearest = {0, 0, side, {0, w.x, w.y, w.z}, squared};
    }
    return nearest;
}

CellPlace nearestOn(const VolumeCells& cells, std::uint32_t cell, const glm::dvec3& point)
{
    CellPlace nearest;
    nearest.distanceSquared = kInfinity;
    std::uint32_t number = 0;
    cells.forEachFace(cell, [&](Corners face) {
        CellPlace candidate = nearestOnFace(cells, face, point);
        candidate.cell = cell;
        candidate.face = number++;
        if (candidate.distanceSquared < nearest.distanceSquared) nearest = candidate;
    });
    return nearest;
}

}  // namespace aeolic
