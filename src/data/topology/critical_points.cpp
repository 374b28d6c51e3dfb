#include "data/topology/critical_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/append.h"
#include "base/parallel.h"
#include "data/topology/flat_triangle.h"

namespace aeolic {
namespace {

constexpr std::size_t kGrain = 1024;
constexpr double kPi = std::numbers::pi;

/// Where streamlines turn by less than this beside how they come nearer they do not turn: what flows straight at a
/// point from everywhere would else be a node or a focus by rounding.
constexpr double kRounding = 1e-6;

/// Where streamlines come no nearer in this part of a turn they count as closed.
constexpr double kClosed = 1e-3;

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

/// By how much the flow turns along a half-edge, more than what is carried along. Opposite for its twin, to the bit:
/// half a turn would else be counted to the same side twice.
double rotationRad(const FlowSurface& surface, std::uint32_t h)
{
    if (const std::uint32_t twin = surface.fans.twin[h]; twin < h) return -rotationRad(surface, twin);
    const double there = surface.field.rad[surface.fans.fanOf[nextInTriangle(h)]],
                 here = surface.field.rad[surface.fans.fanOf[h]];
    return wrapped(there - here - surface.fans.transportRad(h));
}

/// Turns of the flow around a triangle.
int indexOf(const FlowSurface& surface, std::uint32_t t)
{
    double rotation = 0, holonomy = 0;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        rotation += rotationRad(surface, h);
        holonomy += surface.fans.transportRad(h);
    }
    return int(std::lround((rotation + wrapped(holonomy)) / (2 * kPi)));
}

void placeIn(const FlatTriangle& flat, CriticalPoint& out)
{
    const auto& v = flat.flow;
    const double parts[3] = {cross(v[1], v[2]), cross(v[2], v[0]), cross(v[0], v[1])};
    const double whole = parts[0] + parts[1] + parts[2];
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += out.place.weight[i] = whole == 0 ? 1 : std::max(parts[i] / whole, 0.0);
    out.place.weight /= sum;
}

void classify(const FlatTriangle& flat, CriticalPoint& out)
{
    const glm::dmat2 derivative = flat.derivative();
    const double trace = derivative[0][0] + derivative[1][1], determinant = glm::determinant(derivative);
    out.strength = std::sqrt(std::abs(determinant));
    if (std::abs(out.index) != 1) return;
    out.attracts = trace < 0;
    const double turning = determinant - 0.25 * trace * trace;
    if (out.index < 0)
        out.kind = CriticalKind::saddle, out.attracts = false;
    else if (turning <= kRounding * trace * trace)
        out.kind = CriticalKind::node;
    else
        out.kind = std::abs(trace) < kClosed * std::sqrt(turning) ? CriticalKind::centre : CriticalKind::focus;
    if (out.kind == CriticalKind::centre) out.attracts = false;
}

/// Corners of a triangle where the flow is at rest; nothing where the triangle is masked.
std::optional<std::vector<std::uint32_t>> restingCorners(const FlowSurface& surface, std::uint32_t t)
{
    if (surface.field.masked[t]) return {};
    std::vector<std::uint32_t> resting;
    for (std::uint32_t c = 3 * t; c < 3 * t + 3; ++c)
        if (surface.field.length[surface.fans.fanOf[c]] == 0) resting.push_back(c);
    return resting;
}

/// Turns of the flow around a point at rest: those around the triangles of its fan, of which the first one tells them.
/// 0 for the others.
int indexAt(const FlowSurface& surface, std::uint32_t corner)
{
    int index = 0;
    std::uint32_t first = corner;
    forEachCorner(surface.fans, surface.fans.fanOf[corner], [&](std::uint32_t c) {
        const auto resting = restingCorners(surface, c / 3);
        if (!resting || resting->size() != 1) return;
        index += indexOf(surface, c / 3);
        first = std::min(first, c);
    });
    return first == corner ? index : 0;
}

std::optional<CriticalPoint> criticalPointOf(const FlowSurface& surface, std::uint32_t t)
{
    const auto resting = restingCorners(surface, t);
    if (!resting || resting->size() > 1) return {};
    CriticalPoint found;
    found.place.triangle = t;
    found.index = resting->empty() ? indexOf(surface, t) : indexAt(surface, resting->front());
    if (found.index == 0) return {};
    const FlatTriangle laid(surface, t);
    if (resting->empty())
        placeIn(laid, found);
    else
        found.place.weight[int(resting->front() % 3)] = 1;
    classify(laid, found);
    return found;
}

}  // namespace

std::vector<CriticalPoint> criticalPoints(const FlowSurface& surface)
{
    const std::size_t triangles = surface.mesh.triangles.size(), runs = (triangles + kGrain - 1) / kGrain;
    std::vector<std::vector<CriticalPoint>> found(runs);
    parallelFor(runs, [&](std::size_t run) {
        for (std::size_t t = run * kGrain; t < std::min(triangles, (run + 1) * kGrain); ++t)
            if (const auto point = criticalPointOf(surface, std::uint32_t(t))) found[run].push_back(*point);
    });
    std::vector<CriticalPoint> all;
    for (const auto& some : found) appendAll(all, some);
    return all;
}

}  // namespace aeolic
