#include "engine/flow_topology.h"

#include "data/streamlines/separation_lines.h"
#include "data/topology/point_flow.h"
#include "data/topology/surface_topology.h"
#include "engine/flow_values.h"

namespace aeolic {
namespace {

FlowLine lineOf(const std::vector<SurfacePlace>& places, bool separates, const FlowValues& values)
{
    FlowLine line;
    line.separates = separates;
    for (const SurfacePlace& place : places) line.places.push_back(values.at(place));
    return line;
}

}  // namespace

FlowTopology openLines(const Scene& scene, double persistence)
{
    const PointFlow flow = pointFlow(scene);
    const StreamlineSurface surface(flow.mesh, flow.vectors);
    const FlowValues values(scene, flow);
    FlowTopology topology;
    topology.scalar = scene.hasScalar ? scene.scalarName : "";
    for (const SeparationLine& line : separationLines(surface, persistence)) {
        topology.lines.push_back(lineOf(line.places, line.separates, values));
        topology.lines.back().length = line.lengthWorld;
        topology.lines.back().strength = line.strength;
    }
    return topology;
}

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
        FlowLine out = lineOf(line.places, line.direction > 0, values);
        out.saddle = line.saddle;
        out.end = line.other;
        out.length = line.lengthWorld;
        out.strength = found.points[line.saddle].strength;
        topology.lines.push_back(std::move(out));
    }
    return topology;
}

}  // namespace aeolic
