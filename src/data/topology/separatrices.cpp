#include "data/topology/separatrices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include "base/parallel.h"

namespace aeolic {
namespace {

/// A separatrix begins so far from its saddle, as a part of the triangle's side: nearer the flow has no direction.
constexpr double kBesideSaddle = 1e-3;

/// A saddle that is nearer to a side than this, by weight, counts as on it, and one nearer to a point as at it: starts
/// beside it would leave the triangle. Those around a point lie farther off.
constexpr double kNearSide = 2 * kBesideSaddle, kNearPoint = 10 * kBesideSaddle, kBesidePoint = 0.1;

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

/// A direction in which the flow runs straight away from a point or to it, by the cosine between the two.
constexpr double kStraight = 1 - 1e-9;

/// Where a separatrix begins, and which way it goes.
struct Start {
    SurfacePlace place;
    int direction = 1;
};

/// The starts of a saddle that is a point of the mesh. Each triangle around the point has directions of its own, and
/// takes those that lead into it. A direction along a side belongs to the triangle of which it is the first side.
std::vector<Start> startsAroundPoint(const FlowSurface& surface, std::uint32_t corner)
{
    constexpr double alongSide = 1e-9;
    std::vector<Start> starts;
    forEachCorner(surface.fans, surface.fans.fanOf[corner], [&](std::uint32_t c) {
        const std::uint32_t t = c / 3;
        if (surface.field.masked[t]) return;
        const FlatTriangle flat(surface, t);
        const glm::dmat2 derivative = flat.derivative();
        const std::array<glm::dvec2, 2> along = eigenvectors(derivative);
        const glm::dvec2 point = flat.point[c % 3];
        const double side = glm::length(flat.point[nextInTriangle(c) % 3] - point);
        for (std::size_t k = 0; k < 4; ++k) {
            const glm::dvec2 way = (k % 2 == 0 ? 1.0 : -1.0) * along[k / 2];
            const glm::dvec3 weight = flat.weightsOf(point + side * way);
            const double next = weight[int(nextInTriangle(c) % 3)],
                         last = weight[int(SurfaceFans::previousInTriangle(c) % 3)];
            if (!(next > alongSide) || last < -alongSide) continue;
            glm::dvec3 at(0);
            at[int(c % 3)] = 1 - kBesidePoint;
            at[int(nextInTriangle(c) % 3)] = kBesidePoint * next / (next + std::max(last, 0.0));
            at[int(SurfaceFans::previousInTriangle(c) % 3)] =
                kBesidePoint * std::max(last, 0.0) / (next + std::max(last, 0.0));
            const glm::dvec2 flow = derivative * way;
            const double outwards = glm::dot(flow, way);
            if (std::abs(outwards) < kStraight * glm::length(flow) || outwards == 0) continue;  // It turns here.
            starts.push_back({{t, at}, outwards > 0 ? 1 : -1});
        }
    });
    return starts;
}

/// Starts a little beside a place in a triangle, kept on its border where they would leave it. `opposite`: where the
/// place is on the side before that corner, only of those directions that lead into the triangle, or along the side.
void addStartsIn(const FlatTriangle& flat, const SurfacePlace& from, std::optional<int> opposite, bool takesSide,
                 std::vector<Start>& starts)
{
    constexpr double alongSide = 1e-9;
    const std::array<glm::dvec2, 2> along = eigenvectors(flat.derivative());
    const double side = glm::length(flat.point[1] - flat.point[0]);
    for (std::size_t k = 0; k < 4; ++k) {
        const glm::dvec2 way = (k % 2 == 0 ? 1.0 : -1.0) * along[k / 2];
        const glm::dvec3 weight = flat.weightsOf(flat.at(from.weight) + kBesideSaddle * side * way);
        if (opposite) {
            const double inwards = weight[*opposite] - from.weight[*opposite];
            if (inwards < -alongSide || (inwards <= alongSide && !takesSide)) continue;
        }
        starts.push_back({{from.triangle, insideTriangle(weight)}, k < 2 ? 1 : -1});
    }
}

std::vector<Start> startsInTriangle(const FlowSurface& surface, const SurfacePlace& at)
{
    std::vector<Start> starts;
    addStartsIn(FlatTriangle(surface, at.triangle), at, std::nullopt, true, starts);
    return starts;
}

/// The starts of a saddle on a side, or nearly so: each of the two triangles takes the directions that lead into it.
std::vector<Start> startsAcrossSide(const FlowSurface& surface, const SurfacePlace& at, int opposite)
{
    std::vector<Start> starts;
    const int first = (opposite + 1) % 3, second = (opposite + 2) % 3;
    glm::dvec3 onSide = at.weight;
    onSide[opposite] = 0;
    onSide /= onSide[first] + onSide[second];
    addStartsIn(FlatTriangle(surface, at.triangle), {at.triangle, onSide}, opposite, true, starts);
    const std::uint32_t twin = surface.fans.twin[3 * at.triangle + std::uint32_t(first)];
    if (twin == SurfaceFans::kNone || surface.field.masked[twin / 3]) return starts;
    const int begin = int(twin % 3), end = (begin + 1) % 3;  // The side runs the other way round here.
    glm::dvec3 there(0);
    there[begin] = onSide[second];
    there[end] = onSide[first];
    addStartsIn(FlatTriangle(surface, twin / 3), {twin / 3, there}, (begin + 2) % 3, false, starts);
    return starts;
}

/// The corner before which a place lies on a side of the triangle, or so near that a start would leave it.
std::optional<int> sideAt(const SurfacePlace& place)
{
    int least = 0;
    for (int i = 1; i < 3; ++i)
        if (place.weight[i] < place.weight[least]) least = i;
    return place.weight[least] < kNearSide ? std::optional(least) : std::nullopt;
}

/// The corner of the triangle that a place is at, or nearly so.
std::optional<std::uint32_t> cornerAt(const SurfacePlace& place)
{
    for (int i = 0; i < 3; ++i)
        if (place.weight[i] > 1 - kNearPoint) return 3 * place.triangle + std::uint32_t(i);
    return {};
}

}  // namespace

std::vector<Separatrix> separatrices(const FlowSurface& surface, const std::vector<CriticalPoint>& points,
                                     double longestWorld)
{
    std::vector<std::size_t> saddles;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].kind == CriticalKind::saddle) saddles.push_back(i);
    std::vector<std::vector<Separatrix>> found(saddles.size());
    const SurfaceTracer tracer(surface);
    parallelFor(saddles.size(), [&](std::size_t s) {
        const CriticalPoint& saddle = points[saddles[s]];
        const auto corner = cornerAt(saddle.place);
        const auto side = sideAt(saddle.place);
        const std::vector<Start> starts = corner ? startsAroundPoint(surface, *corner)
                                          : side ? startsAcrossSide(surface, saddle.place, *side)
                                                 : startsInTriangle(surface, saddle.place);
        for (const Start& start : starts)
            found[s].push_back({saddles[s], start.direction, tracer.trace(start.place, start.direction, longestWorld)});
    });
    std::vector<Separatrix> all;
    for (std::vector<Separatrix>& some : found) std::move(some.begin(), some.end(), std::back_inserter(all));
    return all;
}

}  // namespace aeolic
