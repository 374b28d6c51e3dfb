#include "engine/surface_pick.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <vector>

#include "base/parallel.h"
#include "engine/place_values.h"

namespace aeolic {
namespace {

constexpr std::size_t kGrain = 4096;
constexpr double kEdge = 1e-9;       // So far outside of a triangle a ray still meets it: neighbours leave no gap.
constexpr double kSamePlace = 1e-6;  // Of the depth: faces that are as near as that are in the same place.

/// A line of sight. A place on it is eye + depth * direction.
struct Ray {
    glm::dvec3 eye, direction;
};

struct Hit {
    double depth = std::numeric_limits<double>::infinity();
    bool isFront = false;  ///< The face is turned to the viewer.
    std::uint64_t order = 0;
    SurfacePlace place;
};

std::optional<Hit> meet(const Ray& ray, const std::array<glm::dvec3, 3>& corners)
{
    const glm::dvec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
    const glm::dvec3 across = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, across);
    if (determinant == 0) return std::nullopt;  // Seen from its edge.
    const glm::dvec3 from = ray.eye - corners[0];
    const double b = glm::dot(from, across) / determinant;
    const glm::dvec3 turned = glm::cross(from, ab);
    const double c = glm::dot(ray.direction, turned) / determinant;
    if (!(b >= -kEdge && c >= -kEdge && b + c <= 1 + kEdge)) return std::nullopt;
    Hit hit;
    hit.depth = glm::dot(ac, turned) / determinant;
    hit.isFront = determinant > 0;
    hit.place.weight = {1 - b - c, b, c};
    return hit;
}

Ray rayThrough(const Scene& scene, const Camera& camera, int x, int y)
{
    const double right = (x + 0.5 - 0.5 * camera.width) / camera.focalPx,
                 down = (y + 0.5 - 0.5 * camera.height) / camera.focalPx;
    return {camera.positionWorld - scene.surface.originWorld, camera.forward + right * camera.right - down * camera.up};
}

/// Where a ray meets the scene first, and what else lies in the same place. In no order.
std::vector<Hit> nearestHits(const Scene& scene, const Camera& camera, const Ray& ray)
{
    const SurfaceMesh& mesh = scene.surface;
    std::mutex guard;
    std::vector<Hit> hits;
    parallelRanges(mesh.triangles.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        std::vector<Hit> own;
        for (std::size_t i = begin; i < end; ++i) {
            const auto& t = mesh.triangles[i];
            auto hit = meet(ray, {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
            if (!hit || hit->depth < camera.nearDepth || (scene.frontFacesOnly && !hit->isFront)) continue;
            hit->place.triangle = std::uint32_t(i);
            hit->order = mesh.order.empty() ? i : mesh.order[i];
            own.push_back(*hit);
        }
        const std::scoped_lock lock(guard);
        hits.insert(hits.end(), own.begin(), own.end());
    });
    double nearest = std::numeric_limits<double>::infinity();
    for (const Hit& hit : hits) nearest = std::min(nearest, hit.depth);
    std::erase_if(hits, [&](const Hit& hit) { return hit.depth > nearest * (1 + kSamePlace); });
    return hits;
}

std::optional<Hit> shownHit(const std::vector<Hit>& hits)
{
    std::optional<Hit> shown;
    for (const Hit& hit : hits) {
        const bool isBetter = !shown || (hit.isFront != shown->isFront ? hit.isFront : hit.order < shown->order);
        if (isBetter) shown = hit;
    }
    return shown;
}

Vec3 toVec3(const glm::dvec3& v)
{
    return {v.x + 0.0, v.y + 0.0, v.z + 0.0};  // Without zeros that are negative.
}

}  // namespace

std::vector<std::uint32_t> trianglesMet(const Scene& piece, const Camera& camera, int x, int y)
{
    std::vector<std::uint32_t> triangles;
    for (const Hit& hit : nearestHits(piece, camera, rayThrough(piece, camera, x, y)))
        triangles.push_back(hit.place.triangle);
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

std::optional<PickedPlace> pickSurface(const Scene& scene, const Camera& camera, int x, int y,
                                       const FieldLookup& lookUp)
{
    const SurfaceMesh& mesh = scene.surface;
    const Ray ray = rayThrough(scene, camera, x, y);
    const auto hit = shownHit(nearestHits(scene, camera, ray));
    if (!hit) return std::nullopt;

    const glm::dvec3 position = positionWorld(mesh, hit->place);
    FieldVector ofField, ofScalarField;
    if (scene.field) ofField = lookUp(*scene.field, {position}).front();
    if (scene.scalarField) ofScalarField = lookUp(*scene.scalarField, {position}).front();
    const glm::dvec3 vector = vectorAt(scene, hit->place, ofField);
    PickedPlace picked;
    const auto& t = mesh.triangles[hit->place.triangle];
    glm::dvec3 normal = glm::normalize(glm::cross(glm::dvec3(mesh.positions[t[1]]) - glm::dvec3(mesh.positions[t[0]]),
                                                  glm::dvec3(mesh.positions[t[2]]) - glm::dvec3(mesh.positions[t[0]])));
    if (glm::dot(normal, ray.direction) > 0) normal = -normal;
    picked.position = toVec3(position);
    picked.depth = hit->depth;
    picked.normal = toVec3(normal);
    picked.triangle = hit->order;
    const SceneSurface* const surface = surfaceOf(scene, mesh, hit->place.triangle);
    picked.surface = surface ? surface->name : mesh.name;
    if (std::isfinite(vector.x + vector.y + vector.z)) {
        picked.vectorName = scene.vectorsName;
        picked.vector = toVec3(vector);
        picked.tangential = toVec3(vector - glm::dot(vector, normal) * normal);
    }
    const double scalar = scalarAt(scene, mesh, hit->place, vector, ofScalarField);
    const bool isColored = scene.hasScalar && !(surface && surface->colors == SceneSurface::kPlain);
    if (isColored) picked.scalarName = surface ? scene.colors[std::size_t(surface->colors)].name : scene.scalarName;
    if (std::isfinite(scalar)) picked.scalar = scalar;
    return picked;
}

}  // namespace aeolic
