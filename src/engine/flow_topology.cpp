#include "engine/flow_topology.h"

#include "data/topology/point_flow.h"
#include "data/topology/surface_topology.h"
#include "engine/flow_values.h"

namespace aeolic {
FlowTopology flowTopology(const Scene& scene, double persistence)
{
    const PointFlow flow = pointFlow(scene);
    const SurfaceTopology found = surfaceTopology(flow.mesh, flow.vectors, {.persistence = persistence});
    const FlowValues values(scene, flow);
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
