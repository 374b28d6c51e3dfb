#include "data/topology/separatrices.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"

namespace aeolic {
namespace {

/// A separatrix begins so far from its saddle, as a part of the triangle's side: nearer the flow has no direction.
constexpr double kBesideSaddle = 1e-3;

/// The flow's derivative at a saddle stretches along one direction and shrinks along another.
std::array<glm::dvec2, 2> eigenvectors(const glm::dmat2& m)
{
    const double a = m[0][0], b = m[1][0], c = m[0][1], d = m[1][1];
    const double middle = 0.5 * (a + d), root = std::sqrt(std::max(0.25 * (a - d) * (a - d) + b * c, 0.0));
    const auto vectorOf = [&](double value) {
        const glm::dvec2 first(b, value - a), second(value - d, c);
        const glm::dvec2 longer = glm::length(first) > glm::length(second) ? first : second;
        return glm::length(longer) > 0 ? glm::normalize(longer) : glm::dvec2(1, 0);
    };
    return {vectorOf(middle + root), vectorOf(middle - root)};
}

/// A place in the plane of a triangle, a little beside another one; kept on the triangle's border where it would leave.
SurfacePlace beside(const FlatTriangle& flat, const CriticalPoint& point, const glm::dvec2& direction)
{
    const glm::dvec3 from = point.place.weight;
    const double side = glm::length(flat.point[1] - flat.point[0]);
    glm::dvec3 weight = flat.weightsOf(flat.at(from) + kBesideSaddle * side * direction);
    weight = glm::max(weight, glm::dvec3(0));
    return {point.place.triangle, weight / (weight.x + weight.y + weight.z)};
}

}  // namespace

std::vector<Separatrix> separatrices(const SurfaceMesh& mesh, const SurfaceFans& fans, const TangentField& field,
                                     const std::vector<CriticalPoint>& points, double longestWorld)
{
    std::vector<std::size_t> saddles;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].kind == CriticalKind::saddle) saddles.push_back(i);
    std::vector<Separatrix> all(4 * saddles.size());
    const SurfaceTracer tracer(mesh, fans, field);
    parallelFor(saddles.size(), [&](std::size_t s) {
        const CriticalPoint& saddle = points[saddles[s]];
        const FlatTriangle flat(mesh, fans, field, saddle.place.triangle);
        const std::array<glm::dvec2, 2> along = eigenvectors(flat.derivative());
        for (std::size_t k = 0; k < 4; ++k) {
            const int direction = k < 2 ? 1 : -1;
            const glm::dvec2 way = (k % 2 == 0 ? 1.0 : -1.0) * along[k / 2];
            all[4 * s + k] = {saddles[s], direction, tracer.trace(beside(flat, saddle, way), direction, longestWorld)};
        }
    });
    return all;
}

}  // namespace aeolic
