#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

#include "base/parallel.h"
#include "data/mesh/mesh_edges.h"
#include "data/mesh/mesh_tools.h"

namespace aeolic {
namespace {

constexpr std::size_t normalsGrain = 4096;
constexpr std::uint32_t maxFacesOnSmoothEdge = 8;

/// Float normals are good to about 1e-7, and cos is flat at zero: this keeps coplanar faces together at an angle of 0.
constexpr float cosTolerance = 1e-6f;

/// Both half-edges run the same way: their triangles are wound against each other.
bool sameDirection(const std::vector<Triangle>& triangles, std::uint32_t g, std::uint32_t h)
{
    return triangles[g / 3][g % 3] == triangles[h / 3][h % 3];
}

/// Marks the triangles to turn round so that each piece connected by two-sided edges is wound one way, the majority's.
std::vector<std::uint8_t> findFlips(const std::vector<Triangle>& triangles, const std::vector<std::uint32_t>& next)
{
    std::vector<std::uint8_t> flip(triangles.size(), 0), seen(triangles.size(), 0);
    std::vector<std::uint32_t> piece;
    for (std::uint32_t seed = 0; seed < triangles.size(); ++seed) {
        if (seen[seed]) continue;
        seen[seed] = 1;
        piece.assign(1, seed);
        std::size_t flipped = 0;
        for (std::size_t k = 0; k < piece.size(); ++k) {  // `piece` is the queue, and in the end the piece.
            const std::uint32_t t = piece[k];
            flipped += flip[t];
            for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
                const std::uint32_t g = next[h], neighbour = g / 3;
                if (next[g] != h || seen[neighbour]) continue;
                seen[neighbour] = 1;
                flip[neighbour] = flip[t] ^ std::uint8_t(sameDirection(triangles, g, h));
                piece.push_back(neighbour);
            }
        }
        if (2 * flipped > piece.size()) {
            for (const std::uint32_t t : piece) flip[t] ^= 1;
        }
    }
    return flip;
}

/// Turning swaps corners 1 and 2, and with them half-edges 0 (0→1) and 2 (2→0); half-edge 1 stays itself.
void applyFlips(const std::vector<std::uint8_t>& flip, std::vector<Triangle>& triangles,
                std::vector<std::uint32_t>& next)
{
    const auto renamed = [&](std::uint32_t h) { return flip[h / 3] ? h - h % 3 + (2 - h % 3) : h; };
    std::vector<std::uint32_t> turned(next.size());
    parallelRanges(triangles.size(), normalsGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            if (flip[t]) std::swap(triangles[t][1], triangles[t][2]);
            for (auto h = std::uint32_t(3 * t); h < 3 * t + 3; ++h) turned[renamed(h)] = renamed(next[h]);
        }
    });
    next.swap(turned);
}

struct FaceNormals {
    std::vector<glm::vec3> normal;  ///< [triangles], unit length.
    std::vector<float> angleRad;    ///< [corners]
};

FaceNormals faceNormals(const SurfaceMesh& mesh)
{
    FaceNormals faces{std::vector<glm::vec3>(mesh.triangles.size()), std::vector<float>(3 * mesh.triangles.size())};
    parallelRanges(mesh.triangles.size(), normalsGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            std::array<glm::dvec3, 3> p, side;
            for (std::size_t i = 0; i < 3; ++i) p[i] = glm::dvec3(mesh.positions[mesh.triangles[t][i]]);
            for (std::size_t i = 0; i < 3; ++i) side[i] = p[(i + 1) % 3] - p[i];
            const glm::dvec3 normal = glm::cross(side[0], side[1]);
            const double doubleArea = glm::length(normal);
            if (!(doubleArea > 0)) continue;  // Not expected; without a normal and an angle it counts for nothing.
            faces.normal[t] = glm::vec3(normal / doubleArea);
            for (std::size_t i = 0; i < 3; ++i) {
                faces.angleRad[3 * t + i] = float(std::atan2(doubleArea, -glm::dot(side[i], side[(i + 2) % 3])));
            }
        }
    });
    return faces;
}

/// Disjoint sets of corners that share a normal; a set's root is its first corner.
class CornerSets {
public:
    explicit CornerSets(std::size_t corners) : parent_(corners) { std::iota(parent_.begin(), parent_.end(), 0u); }

    std::uint32_t root(std::uint32_t corner)
    {
        while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
        return corner;
    }
    void join(std::uint32_t a, std::uint32_t b)
    {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> parent_;
};

/// Joins the corners at both ends of every edge whose faces are wound alike and meet at no more than the feature angle.
CornerSets joinSmoothEdges(const std::vector<std::uint32_t>& next, const std::vector<Triangle>& triangles,
                           const FaceNormals& faces, double featureAngleDeg)
{
    const float minCos = float(std::cos(featureAngleDeg * std::numbers::pi / 180)) - cosTolerance;
    CornerSets sets(next.size());
    for (std::uint32_t h = 0; h < next.size(); ++h) {
        std::uint32_t facesOnEdge = 1;
        for (std::uint32_t g = next[h]; g != h && facesOnEdge <= maxFacesOnSmoothEdge; g = next[g]) ++facesOnEdge;
        if (facesOnEdge > maxFacesOnSmoothEdge) continue;
        for (std::uint32_t g = next[h]; g != h; g = next[g]) {
            if (g < h || sameDirection(triangles, g, h)) continue;
            if (glm::dot(faces.normal[g / 3], faces.normal[h / 3]) < minCos) continue;
            sets.join(h, nextInTriangle(g));
            sets.join(nextInTriangle(h), g);
        }
    }
    return sets;
}

/// Gives each set of corners a point of its own: the first set keeps the point, the others get copies, in corner order.
void splitPoints(SurfaceMesh& mesh, CornerSets& sets)
{
    std::vector<std::uint8_t> taken(mesh.positions.size(), 0);
    for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
        std::uint32_t& point = mesh.triangles[corner / 3][corner % 3];
        const std::uint32_t root = sets.root(corner);
        if (root != corner) {
            point = mesh.triangles[root / 3][root % 3];  // Its root came first and is settled.
        } else if (!taken[point]) {
            taken[point] = 1;
        } else {
            point = mesh.copyPoint(point);
        }
    }
}

void averageNormals(SurfaceMesh& mesh, const FaceNormals& faces)
{
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0));
    for (std::size_t corner = 0; corner < faces.angleRad.size(); ++corner) {
        mesh.normals[mesh.triangles[corner / 3][corner % 3]] += faces.angleRad[corner] * faces.normal[corner / 3];
    }
    // A sum can vanish at a feature angle near 180; any one face's normal is then better than none.
    constexpr float vanished = 1e-6f;
    for (std::size_t corner = 0; corner < faces.angleRad.size(); ++corner) {
        glm::vec3& normal = mesh.normals[mesh.triangles[corner / 3][corner % 3]];
        if (glm::dot(normal, normal) < vanished * vanished) normal = faces.normal[corner / 3];
    }
    parallelRanges(mesh.normals.size(), normalsGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            const float length = glm::length(mesh.normals[p]);
            mesh.normals[p] = length > 0 ? mesh.normals[p] / length : glm::vec3(0, 0, 1);
        }
    });
}

}  // namespace

void computeSmoothNormals(SurfaceMesh& mesh, double featureAngleDeg)
{
    std::vector<std::uint32_t> next = ringEdges(mesh.triangles, mesh.positions.size());
    applyFlips(findFlips(mesh.triangles, next), mesh.triangles, next);
    const FaceNormals faces = faceNormals(mesh);
    CornerSets sets = joinSmoothEdges(next, mesh.triangles, faces, featureAngleDeg);
    splitPoints(mesh, sets);
    averageNormals(mesh, faces);
}

}  // namespace aeolic
