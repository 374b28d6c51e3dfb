#include "engine/surface_pick.h"

#include <cmath>
#include <limits>
#include <mutex>
#include <vector>

#include "base/parallel.h"
#include "engine/place_values.h"
#include "engine/ray_hit.h"

namespace aeolic {
namespace {

constexpr std::size_t kGrain = 4096;

struct Hit : RayHit {
    std::uint64_t order = 0;
    SurfacePlace place;
};

std::optional<Hit> nearestHit(const Scene& scene, const Camera& camera, const Ray& ray)
{
    const SurfaceMesh& mesh = scene.surface;
    std::mutex guard;
    std::vector<Hit> hits;
    parallelRanges(mesh.triangles.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        std::vector<Hit> own;
        for (std::size_t i = begin; i < end; ++i) {
            const auto& t = mesh.triangles[i];
            const auto hit = meet(ray, {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
            if (!hit || hit->depth < camera.nearDepth || (scene.frontFacesOnly && !hit->isFront)) continue;
            own.push_back({*hit, mesh.order.empty() ? i : mesh.order[i], {std::uint32_t(i), hit->weight}});
        }
        const std::scoped_lock lock(guard);
        hits.insert(hits.end(), own.begin(), own.end());
    });
    double nearest = std::numeric_limits<double>::infinity();
    for (const Hit& hit : hits) nearest = std::min(nearest, hit.depth);
    std::optional<Hit> shown;
    for (const Hit& hit : hits) {
        if (hit.depth > nearest * (1 + kSamePlace)) continue;
        if (!shown || showsBefore(hit, hit.order, *shown, shown->order)) shown = hit;
    }
    return shown;
}

Vec3 toVec3(const glm::dvec3& v)
{
    return {v.x + 0.0, v.y + 0.0, v.z + 0.0};  // Without zeros that are negative.
}

}  // namespace

std::optional<PickedPlace> pickSurface(const Scene& scene, const Camera& camera, int x, int y)
{
    const double right = (x + 0.5 - 0.5 * camera.width) / camera.focalPx,
                 down = (y + 0.5 - 0.5 * camera.height) / camera.focalPx;
    const SurfaceMesh& mesh = scene.surface;
    const Ray ray{camera.positionWorld - mesh.originWorld, camera.forward + right * camera.right - down * camera.up};
    const auto hit = nearestHit(scene, camera, ray);
    if (!hit) return std::nullopt;

    PickedPlace picked;
    const glm::dvec3 position = positionWorld(mesh, hit->place), vector = vectorAt(scene, hit->place, position);
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
    const double scalar = scalarAt(scene, mesh, hit->place, position, vector);
    const bool isColored = scene.hasScalar && !(surface && surface->colors == SceneSurface::kPlain);
    if (isColored) picked.scalarName = surface ? scene.colors[std::size_t(surface->colors)].name : scene.scalarName;
    if (std::isfinite(scalar)) picked.scalar = scalar;
    return picked;
}

}  // namespace aeolic
