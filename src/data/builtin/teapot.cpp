#include "data/builtin/teapot.h"

#include <array>
#include <cstddef>
#include <vector>

#include "base/parallel.h"
#include "data/builtin/teapot_patches.h"

namespace aeolic {
namespace {

/// Control points [v][u]; du x dv points outwards. The first or last row may be a single point (a pole).
using Patch = std::array<std::array<glm::dvec3, 4>, 4>;
using Weights = std::array<double, 4>;
constexpr std::size_t patchCount = 32;

void addQuarters(const TeapotQuarter& quarter, std::vector<Patch>& patches)
{
    Patch patch;
    for (std::size_t v = 0; v < 4; ++v) {
        const auto [radius, tangent, z] = quarter[v];
        patch[v] = {{{radius, 0, z}, {radius, -tangent, z}, {tangent, -radius, z}, {0, -radius, z}}};
    }
    for (int turn = 0; turn < 4; ++turn) {
        patches.push_back(patch);
        for (auto& row : patch) {
            for (glm::dvec3& p : row) p = {p.y, -p.x, p.z};
        }
    }
}

/// The mirror image runs the other way round in u, which keeps du x dv outside and makes it meet the half at both
/// seams.
void addHalves(const TeapotHalf& half, std::vector<Patch>& patches)
{
    Patch patch, mirrored;
    for (std::size_t v = 0; v < 4; ++v) {
        const auto [x0, z0, x1, z1, w] = half[v];
        patch[v] = {{{x0, 0, z0}, {x0, -w, z0}, {x1, -w, z1}, {x1, 0, z1}}};
        mirrored[v] = {{{x1, 0, z1}, {x1, w, z1}, {x0, w, z0}, {x0, 0, z0}}};
    }
    patches.push_back(patch);
    patches.push_back(mirrored);
}

std::vector<Patch> teapotPatches()
{
    std::vector<Patch> patches;
    for (const TeapotQuarter& quarter : teapotQuarters) addQuarters(quarter, patches);
    for (const TeapotHalf& half : teapotHalves) addHalves(half, patches);
    return patches;
}

/// Cubic Bernstein polynomials and their derivatives at i / segments. At both ends the position's weights are exactly
/// one and zero: an edge depends on its own control points alone, and so is the same bits in both patches that share
/// it.
struct Basis {
    std::vector<Weights> value, slope;

    explicit Basis(std::size_t segments)
    {
        for (std::size_t i = 0; i <= segments; ++i) {
            const double t = double(i) / double(segments), s = 1 - t;
            value.push_back({s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t});
            slope.push_back({-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t});
        }
    }
};

glm::dvec3 blend(const std::array<glm::dvec3, 4>& points, const Weights& weights)
{
    return (weights[0] * points[0] + weights[1] * points[1]) + (weights[2] * points[2] + weights[3] * points[3]);
}

/// The control points of the curve u -> P(u, v), or of its derivative in v.
std::array<glm::dvec3, 4> rowCurve(const Patch& patch, const Weights& weights)
{
    std::array<glm::dvec3, 4> curve;
    for (std::size_t u = 0; u < 4; ++u) {
        curve[u] = blend({patch[0][u], patch[1][u], patch[2][u], patch[3][u]}, weights);
    }
    return curve;
}

bool isPole(const std::array<glm::dvec3, 4>& row)
{
    return row[0] == row[1] && row[0] == row[2] && row[0] == row[3];
}

/// At a pole dP/du vanishes. Close to it, dP/du is (distance in v) * d2P/dudv, whose direction is that of the next
/// row's derivative: use that row's instead, at v = 0 and v = 1 alike.
glm::vec3 unitNormal(const Patch& patch, std::size_t row, std::size_t segments, const Basis& basis, std::size_t i,
                     const std::array<glm::dvec3, 4>& curve, const std::array<glm::dvec3, 4>& slopeV)
{
    const bool atPole = (row == 0 && isPole(patch[0])) || (row == segments && isPole(patch[3]));
    const glm::dvec3 du = blend(atPole ? patch[row == 0 ? 1 : 2] : curve, basis.slope[i]);
    const glm::dvec3 dv = blend(slopeV, basis.value[i]);
    return glm::vec3(glm::normalize(glm::cross(du, dv)));
}

/// Where a patch's rows of triangles begin. A row at a pole has one triangle per segment, all others two.
struct PatchLayout {
    std::size_t firstTriangle = 0, segments = 0;
    bool poleAtStart = false, poleAtEnd = false;

    std::size_t rowStart(std::size_t row) const
    {
        return firstTriangle + 2 * segments * row - (poleAtStart && row > 0 ? segments : 0);
    }
    std::size_t triangles() const
    {
        return 2 * segments * segments - (poleAtStart ? segments : 0) - (poleAtEnd ? segments : 0);
    }
};

void fillTriangles(SurfaceMesh& mesh, const PatchLayout& layout, std::size_t patch, std::size_t row)
{
    const std::size_t points = layout.segments + 1;
    auto a = std::uint32_t((patch * points + row) * points), c = a + std::uint32_t(points);
    const bool pointAbove = row == 0 && layout.poleAtStart, pointBelow = row + 1 == layout.segments && layout.poleAtEnd;
    std::size_t at = layout.rowStart(row);
    for (std::size_t i = 0; i < layout.segments; ++i, ++a, ++c) {
        if (!pointAbove) mesh.triangles[at++] = {a, a + 1, c + 1};
        if (!pointBelow) mesh.triangles[at++] = {a, c + 1, c};
    }
}

/// Calls body(patch, row) for rows [0, rows) of every patch, in parallel.
template <class Body>
void forRows(std::size_t rows, const Body& body)
{
    parallelRanges(patchCount * rows, 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) body(k / rows, k % rows);
    });
}

/// Bounds of the points that will be in the mesh, in the data's own coordinates.
Bounds tessellationBounds(const std::vector<Patch>& patches, const Basis& basis)
{
    std::array<Bounds, patchCount> boundsOf;
    parallelFor(patchCount, [&](std::size_t patch) {
        for (const Weights& v : basis.value) {
            const auto curve = rowCurve(patches[patch], v);
            for (const Weights& u : basis.value) boundsOf[patch].add(blend(curve, u));
        }
    });
    Bounds bounds;
    for (const Bounds& b : boundsOf) {
        bounds.add(b.lo);
        bounds.add(b.hi);
    }
    return bounds;
}

std::size_t segmentsFor(std::int64_t triangles)
{
    std::size_t n = 2;
    while (std::int64_t(64 * n * n - 8 * n) < triangles) ++n;
    return n;
}

}  // namespace

SurfaceMesh makeTeapot(std::int64_t triangles)
{
    const std::size_t segments = segmentsFor(triangles), rows = segments + 1;
    const std::vector<Patch> patches = teapotPatches();
    const Basis basis(segments);

    std::array<PatchLayout, patchCount> layouts;
    std::size_t triangleCount = 0;
    for (std::size_t k = 0; k < patchCount; ++k) {
        layouts[k] = {triangleCount, segments, isPole(patches[k][0]), isPole(patches[k][3])};
        triangleCount += layouts[k].triangles();
    }

    SurfaceMesh mesh;
    mesh.originWorld = tessellationBounds(patches, basis).center();
    mesh.positions.resize(patchCount * rows * rows);
    mesh.normals.resize(mesh.positions.size());
    mesh.triangles.resize(triangleCount);

    forRows(rows, [&](std::size_t patch, std::size_t row) {
        const auto curve = rowCurve(patches[patch], basis.value[row]);
        const auto slopeV = rowCurve(patches[patch], basis.slope[row]);
        const std::size_t first = (patch * rows + row) * rows;
        for (std::size_t i = 0; i < rows; ++i) {
            // Adding zero turns -0 into 0: points that are equal are then also the same bytes.
            mesh.positions[first + i] = glm::vec3(blend(curve, basis.value[i]) - mesh.originWorld) + 0.0f;
            mesh.normals[first + i] = unitNormal(patches[patch], row, segments, basis, i, curve, slopeV);
        }
    });
    forRows(segments, [&](std::size_t patch, std::size_t row) { fillTriangles(mesh, layouts[patch], patch, row); });
    return mesh;
}

}  // namespace aeolic
