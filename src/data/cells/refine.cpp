#include "data/cells/refine.h"

#include <algorithm>

#include "base/parallel.h"
#include "data/mesh/mesh_edges.h"
#include "data/mesh/triangle_order.h"

namespace aeolic {
namespace {

/// The middle of an edge is the same from either end.
template <class Value>
void addMiddles(std::vector<Value>& values, const std::vector<glm::uvec2>& ends)
{
    if (values.empty()) return;
    values.reserve(values.size() + ends.size());
    for (const glm::uvec2& end : ends) values.push_back((values[end.x] + values[end.y]) * 0.5f);
}

void addNormals(std::vector<glm::vec3>& normals, const std::vector<glm::uvec2>& ends)
{
    if (normals.empty()) return;
    normals.reserve(normals.size() + ends.size());
    for (const glm::uvec2& end : ends) {
        const glm::vec3 sum = normals[end.x] + normals[end.y];
        const float length = glm::length(sum);
        normals.push_back(length > 1e-6f ? sum / length : normals[end.x]);
    }
}

/// The parts of a triangle whose edges have the middles `m`.
void cutTriangle(const Triangle& t, const std::array<std::uint32_t, 3>& m, std::vector<Triangle>& parts)
{
    constexpr std::uint32_t uncut = EdgeCuts::kUncut;
    const auto cut = std::size_t(std::ranges::count_if(m, [](std::uint32_t p) { return p != uncut; }));
    if (cut == 0) {
        parts.push_back(t);
        return;
    }
    if (cut == 3) {
        parts.insert(parts.end(),
                     {Triangle{t[0], m[0], m[2]}, {m[0], t[1], m[1]}, {m[2], m[1], t[2]}, {m[0], m[1], m[2]}});
        return;
    }
    std::size_t k = 0;  // One cut: on this edge. Two: on this edge and the next.
    while (m[k] == uncut || (cut == 2 && m[(k + 1) % 3] == uncut)) ++k;
    const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3], ab = m[k], bc = m[(k + 1) % 3];
    if (cut == 1)
        parts.insert(parts.end(), {Triangle{a, ab, c}, {ab, b, c}});
    else
        parts.insert(parts.end(), {Triangle{ab, b, bc}, {a, ab, bc}, {a, bc, c}});
}

}  // namespace

EdgeCuts findCuts(const SurfaceMesh& mesh, const std::function<bool(const glm::dvec3&, const glm::dvec3&)>& tooLong)
{
    const std::vector<std::uint32_t> next = ringEdges(mesh.triangles, mesh.positions.size());
    const auto endsOf = [&](std::uint32_t h) {
        const std::uint32_t a = mesh.triangles[h / 3][h % 3], b = mesh.triangles[h / 3][nextInTriangle(h) % 3];
        return glm::uvec2(std::min(a, b), std::max(a, b));
    };
    const auto isFirst = [&](std::uint32_t h) {  // Of its ring, which ascends.
        std::uint32_t g = h;
        while (next[g] > g) g = next[g];
        return next[g] == h;
    };
    std::vector<char> cut(next.size(), 0);
    parallelRanges(next.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t h = begin; h < end; ++h) {
            if (!isFirst(std::uint32_t(h))) continue;
            const glm::uvec2 ends = endsOf(std::uint32_t(h));
            cut[h] = tooLong(mesh.originWorld + glm::dvec3(mesh.positions[ends.x]),
                             mesh.originWorld + glm::dvec3(mesh.positions[ends.y]));
        }
    });
    EdgeCuts cuts;
    cuts.middle.assign(next.size(), EdgeCuts::kUncut);
    cuts.triangles = mesh.triangles.size();
    for (std::uint32_t h = 0; h < next.size(); ++h) {
        if (!cut[h]) continue;
        const auto point = std::uint32_t(mesh.positions.size() + cuts.ends.size());
        cuts.ends.push_back(endsOf(h));
        std::uint32_t g = h;
        do {
            cuts.middle[g] = point;
            ++cuts.triangles;
            g = next[g];
        } while (g != h);
    }
    return cuts;
}

void cutEdges(SurfaceMesh& mesh, const EdgeCuts& cuts)
{
    std::vector<Triangle> parts;
    std::vector<std::uint32_t> source;
    parts.reserve(cuts.triangles);
    source.reserve(cuts.triangles);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        cutTriangle(mesh.triangles[t], {cuts.middle[3 * t], cuts.middle[3 * t + 1], cuts.middle[3 * t + 2]}, parts);
        source.resize(parts.size(), std::uint32_t(t));
    }
    mesh.triangles.swap(parts);
    permute(mesh.cellVectors, source);
    permute(mesh.cellScalars, source);
    permute(mesh.order, source);
    addMiddles(mesh.positions, cuts.ends);
    addMiddles(mesh.pointVectors, cuts.ends);
    addMiddles(mesh.pointScalars, cuts.ends);
    addNormals(mesh.normals, cuts.ends);
    if (!mesh.surfaceOf.empty())  // All corners of a triangle are of one surface.
        for (const glm::uvec2& ends : cuts.ends) mesh.surfaceOf.push_back(mesh.surfaceOf[ends.x]);
}

}  // namespace aeolic
