#include "engine/flow_topology.h"

#include <limits>

#include "data/topology/point_flow.h"
#include "data/topology/surface_topology.h"
#include "engine/place_values.h"

namespace aeolic {
namespace {

/// What a scene has at places of the surface.
class Values {
public:
    Values(const Scene& scene, const PointFlow& flow) : scene_(scene), flow_(flow) {}

    SurfaceValues at(const SurfacePlace& place) const
    {
        const glm::dvec3 position = positionWorld(flow_.mesh, place);
        const auto& corners = flow_.mesh.triangles[place.triangle];
        glm::dvec3 vector(0);
        for (int i = 0; i < 3; ++i) vector += place.weight[i] * glm::dvec3(flow_.vectors[corners[std::size_t(i)]]);
        return {
            {position.x, position.y, position.z}, {vector.x, vector.y, vector.z}, scalarOf(place, position, vector)};
    }

private:
    double scalarOf(const SurfacePlace& place, const glm::dvec3& position, const glm::dvec3& vector) const
    {
        const SceneSurface* const surface = surfaceOf(scene_, flow_.mesh, place.triangle);
        if (surface && surface->colors != 0) return std::numeric_limits<double>::quiet_NaN();  // Of another array.
        return scalarAt(scene_, flow_.mesh, place, position, vector);
    }

    const Scene& scene_;
    const PointFlow& flow_;
};

}  // namespace

FlowTopology flowTopology(const Scene& scene, double persistence)
{
    const PointFlow flow = pointFlow(scene);
    const SurfaceTopology found = surfaceTopology(flow.mesh, flow.vectors, {.persistence = persistence});
    const Values values(scene, flow);
    FlowTopology topology;
    topology.scalar = scene.hasScalar ? scene.scalarName : "";
    for (const CriticalPoint& point : found.points)
        topology.points.push_back({values.at(point.place), point.kind, point.attracts, point.index, point.strength});
    for (const TopologyLine& line : found.lines) {
        FlowLine out{line.saddle, line.other, line.direction > 0, line.lengthWorld, {}};
        for (const SurfacePlace& place : line.places) out.places.push_back(values.at(place));
        topology.lines.push_back(std::move(out));
    }
    return topology;
}

}  // namespace aeolic
