#include "data/topology/surface_tracer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aeolic {
namespace {

constexpr double kPi = std::numbers::pi;

/// A step goes so far in the time in which the flow changes. The flow is linear, so that a thin triangle needs no
/// shorter ones.
constexpr double kTimePart = 0.5;

/// Places of trace() are so far apart at most, as a part of the triangle's longest side.
constexpr double kPlacePart = 0.25;

/// Where the flow is slower than this part of what it is at the triangle's corners, and gets slower, a line has come to
/// a point at rest. Beside a saddle that it leaves, the flow may be slower still.
constexpr double kAtRest = 1e-4;

/// So near to a corner, by its weight, a line passes through it. It is then set so far into the next triangle.
constexpr double kAtCorner = 1e-9, kIntoTriangle = 1e-6;

/// A line that crosses an edge again so near to where it was, as a part of the edge, is closed; so is one that crosses
/// it so many times.
constexpr double kSamePlace = 1e-3;
constexpr std::size_t kMostCrossings = 100;
/// The most steps in one triangle, and the most triangles on a line. A line takes many steps in a triangle where it
/// nears a focus or leaves a saddle slowly, or where the triangle is thin and the flow in it turns.
constexpr int kMostSteps = 1 << 14, kMostTriangles = 1 << 20;

double longestSide(const FlatTriangle& flat)
{
    const auto& p = flat.point;
    return std::max({glm::length(p[1] - p[0]), glm::length(p[2] - p[1]), glm::length(p[0] - p[2])});
}

/// The weights after a time, by Runge and Kutta's fourth order; inside or outside of the triangle.
glm::dvec3 stepped(const FlatTriangle& flat, const glm::dvec3& from, double time)
{
    const auto change = [&](const glm::dvec3& weight) { return flat.weightChange(flat.flowAt(weight)); };
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

/// The same up to where a corner's weight is zero, for a time after which it is `beyond`, below zero. By false
/// position, after Dowell and Jarratt, "A modified regula falsi method for computing the root of an equation", BIT 11
/// (1971).
glm::dvec3 steppedToSide(const FlatTriangle& flat, const glm::dvec3& from, double time, int corner, double beyond)
{
    constexpr double isZero = 1e-13;
    double low = 0, high = 1, atLow = std::max(from[corner], 0.0), atHigh = beyond;
    glm::dvec3 to = from;
    for (int round = 0, side = 0; round < 40; ++round) {
        const double part = (atLow * high - atHigh * low) / (atLow - atHigh);
        to = stepped(flat, from, part * time);
        if (std::abs(to[corner]) < isZero) break;
        if (to[corner] < 0) {
            high = part, atHigh = to[corner];
            if (side == -1) atLow *= 0.5;
            side = -1;
        } else {
            low = part, atLow = to[corner];
            if (side == 1) atHigh *= 0.5;
            side = 1;
        }
    }
    to[corner] = 0;
    return to;
}

}  // namespace

FlatTriangle SurfaceTracer::flat(std::uint32_t triangle) const
{
    const FlatTriangle found(surface_, triangle);
    return along_ == Along::flow ? found : found.turned();
}

/// Returns false where the line ends here.
bool SurfaceTracer::add(Walk& walk) const
{
    const glm::dvec3 atWorld = positionWorld(walk.at);
    walk.lengthWorld += glm::length(atWorld - walk.lastWorld);
    walk.lastWorld = atWorld;
    walk.end = !walk.visit(walk.at, walk.lengthWorld) ? LineEnd::stopped : LineEnd::longest;
    return walk.end != LineEnd::stopped && walk.lengthWorld < walk.longestWorld;
}

/// Goes on in the walk's triangle to one of its sides. Returns that half-edge; nothing where the line ends.
std::optional<std::uint32_t> SurfaceTracer::walkThrough(Walk& walk) const
{
    const std::uint32_t t = walk.at.triangle;
    if (surface_.field.masked[t]) {
        walk.end = LineEnd::masked;
        return {};
    }
    const FlatTriangle flat = this->flat(t);
    const glm::dmat2 derivative = flat.derivative();
    const double change = std::sqrt(glm::dot(derivative[0], derivative[0]) + glm::dot(derivative[1], derivative[1]));
    const double fastest = std::max({glm::length(flat.flow[0]), glm::length(flat.flow[1]), glm::length(flat.flow[2])}),
                 longest = longestSide(flat);
    const double shortSteps = std::min(8 * longest / walk.stepWorld, 1e6);  // That it may need to pass the triangle.
    for (int step = 0; step < kMostSteps + int(shortSteps); ++step) {
        const glm::dvec2 flow = flat.flowAt(walk.at.weight);
        const double speed = glm::length(flow), faster = walk.direction * glm::dot(flow, derivative * flow);
        if (!(speed > kAtRest * fastest || faster > 0)) {
            walk.end = LineEnd::rest;
            return {};
        }
        double time = std::min(walk.stepPart * longest, walk.stepWorld) / speed;
        if (change > 0) time = std::min(time, kTimePart / change);
        time *= walk.direction;
        const glm::dvec3 from = walk.at.weight;
        glm::dvec3 to = stepped(flat, from, time);
        const Exit exit = exitOf(from, to);
        if (exit.corner >= 0) {
            to = steppedToSide(flat, from, time, exit.corner, to[exit.corner]);
        }
        walk.at.weight = insideTriangle(to);
        if (!add(walk)) return {};
        if (exit.corner >= 0) return 3 * t + std::uint32_t((exit.corner + 1) % 3);
    }
    walk.end = LineEnd::rest;
    return {};
}

/// Goes through the point at a corner of the walk's triangle.
bool SurfaceTracer::passPoint(Walk& walk, std::uint32_t corner) const
{
    const std::uint32_t fan = surface_.fans.fanOf[corner];
    if (!(surface_.field.length[fan] > 0)) return walk.endsBy(LineEnd::rest);
    double rad =
        surface_.field.rad[fan] + (walk.direction < 0 ? kPi : 0) + (along_ == Along::acrossFlow ? 0.5 * kPi : 0);
    if (rad >= 2 * kPi) rad -= 2 * kPi;
    std::optional<std::uint32_t> into;
    forEachCorner(surface_.fans, fan, [&](std::uint32_t c) {
        if (surface_.fans.edgeRad[c] <= rad && rad <= surface_.fans.secondEdgeRad(c)) into = into.value_or(c);
    });
    if (!into) return walk.endsBy(LineEnd::boundary);
    const double part =
        (rad - surface_.fans.edgeRad[*into]) / (surface_.fans.scale[fan] * surface_.fans.cornerRad[*into]);
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
        const FlatTriangle flat = this->flat(h / 3);
        const std::size_t from = h % 3, to = nextInTriangle(h) % 3;
        return double(walk.direction) * glm::dot(flat.flowAt(weight), flat.point[to] - flat.point[from]);
    };
    const std::uint32_t end = along(halfEdge, walk.at.weight) >= 0 ? nextInTriangle(halfEdge) : halfEdge;
    walk.at.weight = glm::dvec3(0);
    walk.at.weight[int(end % 3)] = 1;
    return add(walk) && passPoint(walk, end);
}

/// Goes into the triangle beyond a side that the walk has come to.
bool SurfaceTracer::enter(Walk& walk, std::uint32_t halfEdge) const
{
    const std::uint32_t end = nextInTriangle(halfEdge);
    const double there = walk.at.weight[int(end % 3)];
    if (there < kAtCorner) return passPoint(walk, halfEdge);
    if (there > 1 - kAtCorner) return passPoint(walk, end);
    const std::uint32_t twin = surface_.fans.twin[halfEdge];
    if (twin == SurfaceFans::kNone) return walk.endsBy(LineEnd::boundary);
    std::vector<double>& before = walk.entered[halfEdge];
    const bool again = std::ranges::any_of(before, [&](double place) { return std::abs(place - there) < kSamePlace; });
    if (again || before.size() >= kMostCrossings) return walk.endsBy(LineEnd::closed);
    before.push_back(there);
    walk.at.triangle = twin / 3;
    walk.at.weight = glm::dvec3(0);
    walk.at.weight[int(twin % 3)] = there;
    walk.at.weight[int(nextInTriangle(twin) % 3)] = 1 - there;
    const FlatTriangle flat = this->flat(twin / 3);
    const glm::dvec2 flow = double(walk.direction) * flat.flowAt(walk.at.weight),
                     side = flat.point[nextInTriangle(twin) % 3] - flat.point[twin % 3];
    if (side.x * flow.y - side.y * flow.x > 0) return true;  // The triangle is to the left of its sides.
    return std::isfinite(flow.x) ? slide(walk, twin) : true;
}

LineEnd SurfaceTracer::walk(Walk walk) const
{
    if (!add(walk)) return walk.end;
    for (int triangle = 0; triangle < kMostTriangles; ++triangle) {
        const std::optional<std::uint32_t> side = walkThrough(walk);
        if (!side || !enter(walk, *side)) break;
    }
    return walk.end;
}

LineEnd SurfaceTracer::follow(const SurfacePlace& from, int direction, double longestWorld, double stepWorld,
                              const Visit& visit) const
{
    return walk({from, direction, longestWorld, stepWorld, 1, visit, positionWorld(from)});
}

SurfaceLine SurfaceTracer::trace(const SurfacePlace& from, int direction, double longestWorld) const
{
    SurfaceLine line;
    const Visit add = [&](const SurfacePlace& place, double lengthWorld) {
        line.places.push_back(place);
        line.lengthWorld = lengthWorld;
        return true;
    };
    constexpr double any = std::numeric_limits<double>::infinity();
    line.end = walk({from, direction, longestWorld, any, kPlacePart, add, positionWorld(from)});
    return line;
}

}  // namespace aeolic
