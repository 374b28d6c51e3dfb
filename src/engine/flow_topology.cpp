#include "engine/flow_topology.h"

#include <vector>

#include "data/streamlines/separation_lines.h"
#include "data/topology/point_flow.h"
#include "data/topology/surface_topology.h"
#include "engine/place_values.h"

namespace aeolic {
namespace {

FlowTopology emptyTopology(const Scene& scene)
{
    FlowTopology topology;
    topology.scalar = scene.hasScalar ? scene.scalarName : "";
    return topology;
}

void append(std::vector<SurfacePlace>& all, const std::vector<SurfacePlace>& more)
{
    all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

FlowTopology openLines(const Scene& scene, double persistence, const FieldLookup& lookUp)
{
    const PointFlow flow = pointFlow(scene, lookUp);
    const StreamlineSurface surface(flow.mesh, flow.vectors);
    const std::vector<SeparationLine> found = separationLines(surface, persistence);
    std::vector<SurfacePlace> places;
    for (const SeparationLine& line : found) append(places, line.places);
    ValuesInTurn values(valuesAt(scene, flow, places, lookUp));
    FlowTopology topology = emptyTopology(scene);
    for (const SeparationLine& line : found) {
        FlowLine out;
        out.separates = line.separates;
        out.length = line.lengthWorld;
        out.strength = line.strength;
        out.places = values.next(line.places.size());
        topology.lines.push_back(std::move(out));
    }
    return topology;
}

FlowTopology flowTopology(const Scene& scene, double persistence, const FieldLookup& lookUp)
{
    const PointFlow flow = pointFlow(scene, lookUp);
    const SurfaceTopology found = surfaceTopology(flow.mesh, flow.vectors, {.persistence = persistence});
    std::vector<SurfacePlace> places;
    for (const CriticalPoint& point : found.points) places.push_back(point.place);
    for (const TopologyLine& line : found.lines) append(places, line.places);
    ValuesInTurn values(valuesAt(scene, flow, places, lookUp));
    FlowTopology topology = emptyTopology(scene);
    for (const CriticalPoint& point : found.points)
        topology.points.push_back({values.next(), point.kind, point.attracts, point.index, point.strength});
    for (const TopologyLine& line : found.lines) {
        FlowLine out;
        out.separates = line.direction > 0;
        out.saddle = line.saddle;
        out.end = line.other;
        out.length = line.lengthWorld;
        out.strength = found.points[line.saddle].strength;
        out.places = values.next(line.places.size());
        topology.lines.push_back(std::move(out));
    }
    return topology;
}

}  // namespace aeolic
