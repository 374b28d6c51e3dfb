#include "data/topology/surface_tracer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aeolic {
namespace {

constexpr double kPi = std::numbers::pi;

/// A step goes so far, as a part of the triangle's longest side, and so far in the time in which the flow changes. The
/// flow is linear, so that a thin triangle needs no shorter ones.
constexpr double kStepPart = 0.25, kTimePart = 0.5;

/// Where the flow is slower than this part of what it is at the triangle's corners a line has come to a point at rest.
constexpr double kAtRest = 1e-4;

/// So near to a corner, by its weight, a line passes through it. It is then set so far into the next triangle.
constexpr double kAtCorner = 1e-9, kIntoTriangle = 1e-6;

/// A line that crosses an edge again so near to where it was, as a part of the edge, is closed; so is one that crosses
/// it so many times.
constexpr double kSamePlace = 1e-3;
constexpr std::size_t kMostCrossings = 100;
/// The most steps in one triangle, and the most triangles on a line. A line takes many steps in a triangle where it
/// nears a focus slowly, or where the triangle is thin and the flow in it turns.
constexpr int kMostSteps = 1 << 12, kMostTriangles = 1 << 20;

double longestSide(const FlatTriangle& flat)
{
    const auto& p = flat.point;
    return std::max({glm::length(p[1] - p[0]), glm::length(p[2] - p[1]), glm::length(p[0] - p[2])});
}

/// The weights after a time, by Runge and Kutta's fourth order; inside or outside of the triangle.
glm::dvec3 stepped(const FlatTriangle& flat, const glm::dvec3& from, double time)
{
    const auto change = [&](const glm::dvec3& weight) {
        const glm::dvec3 moved = flat.weightsOf(flat.flowAt(weight) + flat.point[0]);
        return moved - glm::dvec3(1, 0, 0);  // The sum of what weights change by is 0.
    };
    const glm::dvec3 a = change(from), b = change(from + 0.5 * time * a), c = change(from + 0.5 * time * b),
                     d = change(from + time * c);
    return from + time / 6 * (a + 2.0 * b + 2.0 * c + d);
}

/// The corner whose weight falls below zero first on the way, and at which part of it.
struct Exit {
    int corner = -1;
    double part = 1;
};
Exit exitOf(const glm::dvec3& from, const glm::dvec3& to)
{
    Exit exit;
    for (int k = 0; k < 3; ++k)
        if (to[k] < 0)
            if (const double part = std::max(from[k], 0.0) / (std::max(from[k], 0.0) - to[k]);
                exit.corner < 0 || part < exit.part)
                exit = {k, part};
    return exit;
}

glm::dvec3 cleaned(glm::dvec3 weight)
{
    weight = glm::max(weight, glm::dvec3(0));
    return weight / (weight.x + weight.y + weight.z);
}

}  // namespace

void SurfaceTracer::add(Walk& walk) const
{
    SurfaceLine& line = walk.line;
    if (!line.places.empty())
        line.lengthWorld += glm::length(positionWorld(walk.at) - positionWorld(line.places.back()));
    line.places.push_back(walk.at);
}

/// Goes on in the walk's triangle to one of its sides. Returns that half-edge; nothing where the line ends.
std::optional<std::uint32_t> SurfaceTracer::walkThrough(Walk& walk, double longestWorld) const
{
    const std::uint32_t t = walk.at.triangle;
    if (field_.masked[t]) {
        walk.line.end = LineEnd::masked;
        return {};
    }
    const FlatTriangle flat(mesh_, fans_, field_, t);
    const glm::dmat2 derivative = flat.derivative();
    const double change = std::sqrt(glm::dot(derivative[0], derivative[0]) + glm::dot(derivative[1], derivative[1]));
    const double fastest = std::max({glm::length(flat.flow[0]), glm::length(flat.flow[1]), glm::length(flat.flow[2])}),
                 longest = longestSide(flat);
    for (int step = 0; step < kMostSteps; ++step) {
        const double speed = glm::length(flat.flowAt(walk.at.weight));
        if (!(speed > kAtRest * fastest)) {
            walk.line.end = LineEnd::rest;
            return {};
        }
        double time = kStepPart * longest / speed;
        if (change > 0) time = std::min(time, kTimePart / change);
        time *= walk.direction;
        const glm::dvec3 from = walk.at.weight;
        glm::dvec3 to = stepped(flat, from, time);
        const Exit exit = exitOf(from, to);
        if (exit.corner >= 0) {
            double low = 0, high = 1, part = exit.part;  // Where that weight is zero on the way.
            for (int round = 0; round < 20; ++round, part = 0.5 * (low + high)) {
                to = stepped(flat, from, part * time);
                if (std::abs(to[exit.corner]) < 1e-14) break;
                (to[exit.corner] < 0 ? high : low) = part;
            }
            to[exit.corner] = 0;
        }
        walk.at.weight = cleaned(to);
        add(walk);
        if (walk.line.lengthWorld >= longestWorld) {
            walk.line.end = LineEnd::longest;
            return {};
        }
        if (exit.corner >= 0) return 3 * t + std::uint32_t((exit.corner + 1) % 3);
    }
    walk.line.end = LineEnd::rest;
    return {};
}

/// Goes through the point at a corner of the walk's triangle.
bool SurfaceTracer::passPoint(Walk& walk, std::uint32_t corner) const
{
    const std::uint32_t fan = fans_.fanOf[corner];
    if (!(field_.length[fan] > 0)) {
        walk.line.end = LineEnd::rest;
        return false;
    }
    double rad = field_.rad[fan] + (walk.direction < 0 ? kPi : 0);
    if (rad >= 2 * kPi) rad -= 2 * kPi;
    std::optional<std::uint32_t> into;
    forEachCorner(fans_, fan, [&](std::uint32_t c) {
        if (fans_.edgeRad[c] <= rad && rad <= fans_.secondEdgeRad(c)) into = into.value_or(c);
    });
    if (!into) {
        walk.line.end = LineEnd::boundary;
        return false;
    }
    const double part = (rad - fans_.edgeRad[*into]) / (fans_.scale[fan] * fans_.cornerRad[*into]);
    const std::uint32_t next = nextInTriangle(*into), last = SurfaceFans::previousInTriangle(*into);
    walk.at.triangle = *into / 3;
    walk.at.weight[int(*into % 3)] = 1 - kIntoTriangle;
    walk.at.weight[int(next % 3)] = kIntoTriangle * (1 - part);
    walk.at.weight[int(last % 3)] = kIntoTriangle * part;
    return true;
}

/// The flow on both sides of an edge runs towards it: goes along it to one of its ends, and through that.
bool SurfaceTracer::slide(Walk& walk, std::uint32_t halfEdge) const
{
    const auto along = [&](std::uint32_t h, const glm::dvec3& weight) {
        const FlatTriangle flat(mesh_, fans_, field_, h / 3);
        const std::size_t from = h % 3, to = nextInTriangle(h) % 3;
        return double(walk.direction) * glm::dot(flat.flowAt(weight), flat.point[to] - flat.point[from]);
    };
    const std::uint32_t end = along(halfEdge, walk.at.weight) >= 0 ? nextInTriangle(halfEdge) : halfEdge;
    walk.at.weight = glm::dvec3(0);
    walk.at.weight[int(end % 3)] = 1;
    add(walk);
    return passPoint(walk, end);
}

/// Goes into the triangle beyond a side that the walk has come to.
bool SurfaceTracer::enter(Walk& walk, std::uint32_t halfEdge) const
{
    const std::uint32_t end = nextInTriangle(halfEdge);
    const double there = walk.at.weight[int(end % 3)];
    if (there < kAtCorner) return passPoint(walk, halfEdge);
    if (there > 1 - kAtCorner) return passPoint(walk, end);
    const std::uint32_t twin = fans_.twin[halfEdge];
    if (twin == SurfaceFans::kNone) {
        walk.line.end = LineEnd::boundary;
        return false;
    }
    std::vector<double>& before = walk.entered[halfEdge];
    const bool again =
        std::any_of(before.begin(), before.end(), [&](double place) { return std::abs(place - there) < kSamePlace; });
    if (again || before.size() >= kMostCrossings) {
        walk.line.end = LineEnd::closed;
        return false;
    }
    before.push_back(there);
    walk.at.triangle = twin / 3;
    walk.at.weight = glm::dvec3(0);
    walk.at.weight[int(twin % 3)] = there;
    walk.at.weight[int(nextInTriangle(twin) % 3)] = 1 - there;
    const FlatTriangle flat(mesh_, fans_, field_, twin / 3);
    const glm::dvec2 flow = double(walk.direction) * flat.flowAt(walk.at.weight),
                     side = flat.point[nextInTriangle(twin) % 3] - flat.point[twin % 3];
    if (side.x * flow.y - side.y * flow.x > 0) return true;  // The triangle is to the left of its sides.
    return std::isfinite(flow.x) ? slide(walk, twin) : true;
}

SurfaceLine SurfaceTracer::trace(const SurfacePlace& from, int direction, double longestWorld) const
{
    Walk walk{from, direction, {}, {}};
    add(walk);
    for (int triangle = 0; triangle < kMostTriangles; ++triangle) {
        const std::optional<std::uint32_t> side = walkThrough(walk, longestWorld);
        if (!side || !enter(walk, *side)) break;
    }
    return std::move(walk.line);
}

}  // namespace aeolic
