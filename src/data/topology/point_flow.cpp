#include "data/topology/point_flow.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "base/parallel.h"
#include "data/cells/grid_sampler.h"
#include "data/cells/near_wall.h"
#include "data/cells/refine.h"
#include "data/cells_to_points.h"

namespace aeolic {
namespace {

constexpr std::size_t kGrain = 1024;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// More are not made of a surface. The topology takes about 150 bytes for each.
constexpr std::uint64_t kMostTriangles = std::uint64_t{4} << 20;

/// Which of the scene's surfaces a point is of; nothing where there is only one.
const SceneSurface* surfaceAt(const Scene& scene, const SurfaceMesh& mesh, std::size_t point)
{
    return mesh.surfaceOf.empty() ? nullptr : &scene.surfaces[mesh.surfaceOf[point]];
}

/// Cuts triangles until they are as fine as the grid's cells.
void refine(SurfaceMesh& mesh, const std::shared_ptr<const GridField>& field)
{
    const GridSampler sampler(field, nullptr);
    const auto tooLong = [&](const glm::dvec3& a, const glm::dvec3& b) { return longerThanCell(sampler, a, b); };
    const std::uint64_t most = std::max<std::uint64_t>(kMostTriangles, mesh.triangles.size());
    for (int round = 0; round < kMostRefinements; ++round) {
        const EdgeCuts cuts = findCuts(mesh, tooLong);
        if (cuts.ends.empty() || cuts.triangles > most) return;
        cutEdges(mesh, cuts);
    }
}

std::vector<glm::dvec3> placesWorld(const SurfaceMesh& mesh)
{
    std::vector<glm::dvec3> places;
    places.reserve(mesh.positions.size());
    for (const glm::vec3& position : mesh.positions) places.push_back(mesh.originWorld + glm::dvec3(position));
    return places;
}

}  // namespace

PointFlow pointFlow(const Scene& scene, const FieldLookup& lookUp)
{
    PointFlow flow{scene.surface, {}};
    SurfaceMesh& mesh = flow.mesh;
    if (!mesh.cellVectors.empty()) bringCellsToPoints(mesh);
    std::vector<FieldVector> ofField;
    if (scene.field) {
        refine(mesh, scene.field);
        ofField = lookUp(*scene.field, placesWorld(mesh));
    }
    flow.vectors.resize(mesh.positions.size(), glm::vec3(kNaN));
    parallelRanges(mesh.positions.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const SceneSurface* surface = surfaceAt(scene, mesh, i);
            if (surface && !surface->streaks) continue;
            const bool isOwn = !scene.field || (surface && surface->ownVectors);
            if (isOwn && !mesh.pointVectors.empty()) flow.vectors[i] = mesh.pointVectors[i];
            if (!isOwn && ofField[i].inside) flow.vectors[i] = glm::vec3(ofField[i].vector);
        }
    });
    return flow;
}

}  // namespace aeolic
