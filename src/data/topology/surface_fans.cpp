#include "data/topology/surface_fans.h"

#include <cmath>
#include <numbers>

#include "base/parallel.h"

namespace aeolic {
namespace {

constexpr std::size_t kGrain = 4096;
constexpr double kPi = std::numbers::pi;

/// Half-edges of one edge: two that run in opposite directions belong together.
void findTwins(std::size_t points, SurfaceFans& fans)
{
    const std::vector<std::uint32_t> ring = ringEdges(fans.triangles, points);
    const auto start = [&](std::uint32_t h) { return fans.triangles[h / 3][h % 3]; };
    fans.twin.assign(ring.size(), SurfaceFans::kNone);
    parallelRanges(ring.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (auto h = std::uint32_t(begin); h < end; ++h)
            if (const std::uint32_t g = ring[h]; g != h && ring[g] == h && start(g) != start(h)) fans.twin[h] = g;
    });
}

/// The most clockwise corner of this one's fan; itself where the fan is closed.
std::uint32_t beginningOf(const SurfaceFans& fans, std::uint32_t corner)
{
    std::uint32_t first = corner;
    while (fans.twin[first] != SurfaceFans::kNone) {
        first = nextInTriangle(fans.twin[first]);
        if (first == corner) return corner;
    }
    return first;
}

void layFan(SurfaceFans& fans, std::uint32_t first)
{
    const auto fan = std::uint32_t(fans.fans());
    double whole = 0;
    std::uint32_t corner = first;
    do {
        fans.fanOf[corner] = fan;
        fans.edgeRad[corner] = whole;
        whole += fans.cornerRad[corner];
        corner = fans.nextCorner(corner);
    } while (corner != SurfaceFans::kNone && corner != first);
    const bool closed = corner == first;
    const double scale = closed ? 2 * kPi / whole : 1;
    for (std::uint32_t c = first; closed;) {
        fans.edgeRad[c] *= scale;
        if ((c = fans.nextCorner(c)) == first) break;
    }
    fans.firstCorner.push_back(first);
    fans.scale.push_back(scale);
    fans.closed.push_back(closed);
}

}  // namespace

double wrapped(double rad)
{
    return rad - 2 * kPi * std::ceil((rad - kPi) / (2 * kPi));
}

double SurfaceFans::transportRad(std::uint32_t halfEdge) const
{
    return secondEdgeRad(nextInTriangle(halfEdge)) + kPi - edgeRad[halfEdge];
}

SurfaceFans surfaceFans(const SurfaceMesh& mesh)
{
    SurfaceFans fans;
    fans.triangles = joinedTriangles(mesh.triangles, mesh.positions);
    fans.cornerRad = cornerAngles(fans.triangles, mesh.positions);
    findTwins(mesh.positions.size(), fans);
    const std::size_t corners = 3 * fans.triangles.size();
    fans.fanOf.assign(corners, SurfaceFans::kNone);
    fans.edgeRad.resize(corners);
    for (std::uint32_t corner = 0; corner < corners; ++corner)
        if (fans.fanOf[corner] == SurfaceFans::kNone) layFan(fans, beginningOf(fans, corner));
    return fans;
}

}  // namespace aeolic
