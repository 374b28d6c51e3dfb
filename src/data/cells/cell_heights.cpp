#include "data/cells/cell_heights.h"

#include <algorithm>
#include <cmath>

namespace aeolic {
namespace {

struct FaceUnder {
    FacePlane plane{};
    double distance = kInfinity;  // Of the point from the plane.
    double along = 0;             // The cosine between the face's normal and the surface's.
    std::uint32_t number = 0;     // Of the cell's faces.
};

/// The face along a surface that is the nearest to its point; of those that are equally near the most parallel one.
FaceUnder faceUnder(const VolumeCells& cells, std::uint32_t cell, const glm::dvec3& center, const glm::dvec3& point,
                    const glm::dvec3& normal, double slackWorld)
{
    FaceUnder best;
    std::uint32_t number = 0;
    cells.forEachFace(cell, [&](Corners face) {
        FaceUnder candidate;
        candidate.number = number++;
        candidate.plane = planeOf(cells, face, center);
        candidate.along = glm::dot(candidate.plane.inwards, normal);
        if (!(std::abs(candidate.along) >= kAlongSurface)) return;
        candidate.distance =
            std::max(slackWorld, std::abs(glm::dot(point - candidate.plane.middle, candidate.plane.inwards)));
        if (candidate.distance < best.distance ||
            (candidate.distance == best.distance && std::abs(candidate.along) > std::abs(best.along)))
            best = candidate;
    });
    return best;
}

}  // namespace

FacePlane planeOf(const VolumeCells& cells, Corners face, const glm::dvec3& center)
{
    FacePlane plane;
    plane.middle = faceMean<glm::dvec3>(face, [&](std::uint32_t id) { return cells.points[id]; });
    glm::dvec3 across(0);
    for (std::size_t i = 0; i < face.size(); ++i)
        across +=
            glm::cross(cells.points[face[i]] - plane.middle, cells.points[face[(i + 1) % face.size()]] - plane.middle);
    if (glm::dot(center - plane.middle, across) < 0) across = -across;
    plane.inwards = across / glm::length(across);
    return plane;
}

glm::dvec3 centerOf(const VolumeCells& cells, std::uint32_t cell)
{
    return cellMean<glm::dvec3>(cells, cell, [&](std::uint32_t id) { return cells.points[id]; });
}

double widthOf(const VolumeCells& cells, std::uint32_t cell, const glm::dvec3& direction)
{
    double lo = kInfinity, hi = -kInfinity;
    cells.forEachFace(cell, [&](Corners face) {
        for (const std::uint32_t id : face) {
            const double along = glm::dot(cells.points[id], direction);
            lo = std::min(lo, along);
            hi = std::max(hi, along);
        }
    });
    return hi - lo;
}

double heightOver(const VolumeCells& cells, std::uint32_t cell, const glm::dvec3& point, const glm::dvec3& normal,
                  double slackWorld)
{
    const FaceUnder under = faceUnder(cells, cell, centerOf(cells, cell), point, normal, slackWorld);
    if (under.along == 0) return widthOf(cells, cell, normal);
    double height = 0;
    cells.forEachFace(cell, [&](Corners face) {
        for (const std::uint32_t id : face)
            height = std::max(height, glm::dot(cells.points[id] - under.plane.middle, under.plane.inwards));
    });
    return height;
}

void settleOnFace(const VolumeCells& cells, const glm::dvec3& point, const glm::dvec3& normal, double slackWorld,
                  CellPlace& place)
{
    const auto cell = std::uint32_t(place.cell);
    const FaceUnder under = faceUnder(cells, cell, centerOf(cells, cell), point, normal, 0);
    if (!(under.distance <= slackWorld)) return;
    std::uint32_t number = 0;
    cells.forEachFace(cell, [&](Corners face) {
        if (number++ != under.number) return;
        CellPlace onFace = nearestOnFace(cells, face, point);
        if (!(onFace.distanceSquared <= slackWorld * slackWorld)) return;
        onFace.cell = cell;
        onFace.face = under.number;
        place = onFace;
    });
}

bool isTowards(const VolumeCells& cells, std::uint32_t cell, const glm::dvec3& point, const glm::dvec3& towards,
               double slackWorld)
{
    constexpr double steep = 0.5;         // Of the way to the centre: 30 degrees.
    constexpr double noVolume = 0x1p-10;  // Of the slack.
    const glm::dvec3 center = centerOf(cells, cell), off = center - point;
    const double along = glm::dot(off, towards);
    const bool isSteep = along * along > steep * steep * glm::dot(off, off) * glm::dot(towards, towards);
    if (isSteep && std::abs(along) > slackWorld) return along > 0;
    const FaceUnder under = faceUnder(cells, cell, center, point, towards, 0);
    if (under.along == 0) return along > slackWorld;
    return under.along > 0 && glm::dot(center - under.plane.middle, under.plane.inwards) > noVolume * slackWorld;
}

}  // namespace aeolic
