#include "data/topology/flat_triangle.h"

#include <cmath>
#include <numbers>

#include "data/topology/surface_place.h"

namespace aeolic {

FlatTriangle::FlatTriangle(const FlowSurface& surface, std::uint32_t triangle)
{
    const SurfaceMesh& mesh = surface.mesh;
    const SurfaceFans& fans = surface.fans;
    const TangentField& field = surface.field;
    constexpr double kPi = std::numbers::pi;
    const auto at = [&](std::size_t i) { return glm::dvec3(mesh.positions[mesh.triangles[triangle][i]]); };
    const double base = glm::length(at(1) - at(0)), last = glm::length(at(2) - at(0));
    const std::uint32_t corner = 3 * triangle;
    const double rad0 = fans.cornerRad[corner], rad1 = fans.cornerRad[corner + 1];
    point = {glm::dvec2(0), {base, 0}, {last * std::cos(rad0), last * std::sin(rad0)}};
    perPlace_ = glm::inverse(glm::dmat2(point[1] - point[0], point[2] - point[0]));
    const std::array<double, 3> sideRad{0, kPi - rad1, kPi + rad0};  // Of the half-edge that begins at each corner.
    for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t c = corner + i, fan = fans.fanOf[c];
        const double curved = 0.5 * fans.cornerRad[c] * (1 - fans.scale[fan]);  // Half of it beside either edge.
        const double rad = sideRad[i] + wrapped(field.rad[fan] - fans.edgeRad[c]) + curved;
        flow[i] = field.length[fan] * glm::dvec2(std::cos(rad), std::sin(rad));
        if (field.sharp.empty() || !field.sharp[fan]) continue;
        const glm::dvec3 ahead = (at(1) - at(0)) / base,
                         left = glm::cross(glm::normalize(areaVector(mesh, triangle)), ahead),
                         vector(field.own[mesh.triangles[triangle][i]]);
        flow[i] = {glm::dot(vector, ahead), glm::dot(vector, left)};
    }
}

FlatTriangle FlatTriangle::turned() const
{
    FlatTriangle triangle = *this;
    for (glm::dvec2& vector : triangle.flow) vector = {-vector.y, vector.x};
    return triangle;
}

glm::dvec3 FlatTriangle::weightsOf(const glm::dvec2& place) const
{
    const glm::dvec2 others = perPlace_ * (place - point[0]);
    return {1 - others.x - others.y, others.x, others.y};
}

glm::dmat2 FlatTriangle::derivative() const
{
    return glm::dmat2(flow[1] - flow[0], flow[2] - flow[0]) * perPlace_;
}

}  // namespace aeolic
