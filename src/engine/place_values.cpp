#include "engine/place_values.h"

#include <limits>

namespace aeolic {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The mean of the corners' values by their weights.
template <class Value, class Wide>
Wide between(const SurfaceMesh& mesh, const SurfacePlace& place, const std::vector<Value>& ofPoints, Wide sum)
{
    for (int i = 0; i < 3; ++i) sum += place.weight[i] * Wide(ofPoints[mesh.triangles[place.triangle][std::size_t(i)]]);
    return sum;
}

}  // namespace

const SceneSurface* surfaceOf(const Scene& scene, const SurfaceMesh& mesh, std::uint32_t triangle)
{
    return mesh.surfaceOf.empty() ? nullptr : &scene.surfaces[mesh.surfaceOf[mesh.triangles[triangle][0]]];
}

double scalarAt(const Scene& scene, const SurfaceMesh& mesh, const SurfacePlace& place, const glm::dvec3& vector,
                const FieldVector& ofField)
{
    const SceneSurface* const surface = surfaceOf(scene, mesh, place.triangle);
    if (!scene.hasScalar || (surface && surface->colors == SceneSurface::kPlain)) return kNone;
    const bool own = surface && surface->ownScalar;
    if (needsNormal(scene.ofVectors) && !own)
        return valueOf(scene.ofVectors, vector, normalAt(mesh, place.triangle, place.weight[1], place.weight[2]));
    if (scene.scalarFromField() && !own) {
        if (scene.ofVectors == ArrayPart::length) return glm::length(vector);
        return ofField.inside ? ofField.vector.x : kNone;
    }
    if (!mesh.cellScalars.empty()) return mesh.cellScalars[place.triangle];
    return mesh.pointScalars.empty() ? kNone : between(mesh, place, mesh.pointScalars, 0.0);
}

glm::dvec3 vectorAt(const Scene& scene, const SurfacePlace& place, const FieldVector& ofField)
{
    const SurfaceMesh& mesh = scene.surface;
    const SceneSurface* const surface = surfaceOf(scene, mesh, place.triangle);
    if (surface && !surface->streaks) return glm::dvec3(kNone);
    if (scene.field && !(surface && surface->ownVectors)) return ofField.inside ? ofField.vector : glm::dvec3(kNone);
    if (!mesh.cellVectors.empty()) return mesh.cellVectors[place.triangle];
    return mesh.pointVectors.empty() ? glm::dvec3(kNone) : between(mesh, place, mesh.pointVectors, glm::dvec3(0));
}

std::vector<SurfaceValues> valuesAt(const Scene& scene, const PointFlow& flow, const std::vector<SurfacePlace>& places,
                                    const FieldLookup& lookUp)
{
    std::vector<glm::dvec3> positions;
    positions.reserve(places.size());
    for (const SurfacePlace& place : places) positions.push_back(positionWorld(flow.mesh, place));
    std::vector<FieldVector> scalars(places.size());
    if (scene.hasScalar && scene.scalarField) scalars = lookUp(*scene.scalarField, positions);
    std::vector<SurfaceValues> values;
    values.reserve(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const glm::dvec3 vector = between(flow.mesh, places[i], flow.vectors, glm::dvec3(0));
        const SceneSurface* const surface = surfaceOf(scene, flow.mesh, places[i].triangle);
        const bool isOfOtherArray = surface && surface->colors != 0;
        const double scalar = isOfOtherArray ? kNone : scalarAt(scene, flow.mesh, places[i], vector, scalars[i]);
        values.push_back({{positions[i].x, positions[i].y, positions[i].z}, {vector.x, vector.y, vector.z}, scalar});
    }
    return values;
}

}  // namespace aeolic
