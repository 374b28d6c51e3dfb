#include "render/overlay/mesh_lines.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "data/mesh/mesh_edges.h"

namespace aeolic {
namespace {

constexpr std::size_t kGrain = 4096;

constexpr StrokeLook kEdge{{30, 30, 30}, {255, 255, 255}, 0.9f, 0, 0, 0},
    kOutline{{15, 15, 15}, {255, 255, 255}, 2, 0, 0, 0};

/// An edge shows nothing where it is shorter than the first in the picture, and all from the second on. Pixels.
constexpr float kNothingPx = 3, kAllPx = 10;

/// The most that shows of an edge: the surface stays the picture's subject.
constexpr float kEdgePart = 0.7f;

/// Two normals at one place make a crease where the cosine between them is below this.
constexpr float kOneNormal = 0.97f;

using Segment = std::array<glm::vec3, 2>;

/// Collects what ranges of a parallel loop find, in the order of the ranges.
template <class Find>
std::vector<Stroke> strokesIn(std::size_t count, const Find& find)
{
    std::vector<std::vector<Stroke>> parts((count + kGrain - 1) / kGrain);
    parallelFor(parts.size(), [&](std::size_t p) {
        for (std::size_t i = p * kGrain; i < std::min(count, (p + 1) * kGrain); ++i) find(i, parts[p]);
    });
    std::vector<Stroke> all;
    for (const std::vector<Stroke>& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

/// The half-edges of each edge, points in the same place taken as one: visit(half-edges).
template <class Visit>
void forEachEdge(const SurfaceMesh& mesh, const Visit& visit)
{
    const std::vector<std::uint32_t> ring =
        ringEdges(joinedTriangles(mesh.triangles, mesh.positions), mesh.positions.size());
    std::vector<bool> isVisited(ring.size());
    std::vector<std::uint32_t> halfEdges;
    for (std::uint32_t h = 0; h < ring.size(); ++h) {
        if (isVisited[h]) continue;
        halfEdges.assign(1, h);
        for (std::uint32_t other = ring[h]; other != h; other = ring[other]) halfEdges.push_back(other);
        for (const std::uint32_t each : halfEdges) isVisited[each] = true;
        visit(halfEdges);
    }
}

std::array<std::uint32_t, 2> pointsOf(const SurfaceMesh& mesh, std::uint32_t halfEdge)
{
    return {mesh.triangles[halfEdge / 3][halfEdge % 3], mesh.triangles[halfEdge / 3][nextInTriangle(halfEdge) % 3]};
}

Segment segmentOf(const SurfaceMesh& mesh, std::uint32_t halfEdge)
{
    const auto [a, b] = pointsOf(mesh, halfEdge);
    return {mesh.positions[a], mesh.positions[b]};
}

/// A border or a crease. Faces in the same place have the same normals, and make none.
bool isFeature(const SurfaceMesh& mesh, const std::vector<std::uint32_t>& halfEdges)
{
    if (halfEdges.size() == 1) return true;
    const std::array<std::uint32_t, 2> a = pointsOf(mesh, halfEdges[0]);
    return std::any_of(halfEdges.begin() + 1, halfEdges.end(), [&](std::uint32_t halfEdge) {
        std::array<std::uint32_t, 2> b = pointsOf(mesh, halfEdge);
        if (mesh.positions[a[0]] != mesh.positions[b[0]]) std::swap(b[0], b[1]);
        return std::abs(glm::dot(mesh.normals[a[0]], mesh.normals[b[0]])) < kOneNormal ||
               std::abs(glm::dot(mesh.normals[a[1]], mesh.normals[b[1]])) < kOneNormal;
    });
}

}  // namespace

MeshEdges::MeshEdges(const SurfaceMesh& mesh)
{
    forEachEdge(mesh, [&](const std::vector<std::uint32_t>& halfEdges) {
        edges_.push_back(segmentOf(mesh, halfEdges.front()));
    });
}

void MeshEdges::draw(const View& view, const SeenSurface& seen, Tile& out) const
{
    if (seen.rows().empty()) return;
    const float scale = strokeScale(view.camera);
    StrokeLayer layer{kEdge.in(view.camera), strokesIn(edges_.size(), [&](std::size_t i, std::vector<Stroke>& found) {
                          auto stroke = strokeOf(view, fromEye(view, edges_[i][0]), fromEye(view, edges_[i][1]));
                          if (!stroke) return;
                          const float length = glm::length(stroke->b.px - stroke->a.px) / scale;
                          const float part = std::clamp((length - kNothingPx) / (kAllPx - kNothingPx), 0.0f, 1.0f);
                          stroke->a.part = stroke->b.part = kEdgePart * part;
                          if (part > 0) found.push_back(*stroke);
                      })};
    drawStrokes(view, {layer}, seen, out);
}

SurfaceOutline::SurfaceOutline(const SurfaceMesh& mesh)
    : positions_(mesh.positions), normals_(mesh.normals), triangles_(mesh.triangles)
{
    forEachEdge(mesh, [&](const std::vector<std::uint32_t>& halfEdges) {
        if (isFeature(mesh, halfEdges)) features_.push_back(segmentOf(mesh, halfEdges.front()));
    });
}

void SurfaceOutline::draw(const View& view, const SeenSurface& seen, Tile& out) const
{
    if (seen.rows().empty()) return;
    std::vector<float> facing(positions_.size());  // Above 0 where a point faces the viewer.
    const glm::vec3 eye = view.eyeLocal * float(view.unitWorld);
    parallelRanges(facing.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) facing[i] = glm::dot(normals_[i], eye - positions_[i]);
    });
    const auto silhouette = [&](std::size_t t, std::vector<Stroke>& found) {
        Segment ends;
        std::size_t count = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = triangles_[t][i], b = triangles_[t][(i + 1) % 3];
            if ((facing[a] > 0) == (facing[b] > 0)) continue;
            const float part = facing[a] / (facing[a] - facing[b]);
            if (count < 2) ends[count++] = positions_[a] + part * (positions_[b] - positions_[a]);
        }
        if (count == 2)
            if (const auto stroke = strokeOf(view, fromEye(view, ends[0]), fromEye(view, ends[1])))
                found.push_back(*stroke);
    };
    StrokeLayer layer{kOutline.in(view.camera), strokesIn(triangles_.size(), silhouette)};
    const std::vector<Stroke> features = strokesIn(features_.size(), [&](std::size_t i, std::vector<Stroke>& found) {
        if (const auto stroke = strokeOf(view, fromEye(view, features_[i][0]), fromEye(view, features_[i][1])))
            found.push_back(*stroke);
    });
    layer.strokes.insert(layer.strokes.end(), features.begin(), features.end());
    drawStrokes(view, {layer}, seen, out);
}

}  // namespace aeolic
