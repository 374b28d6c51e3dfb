#include "engine/flow_lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/append.h"
#include "data/streamlines/even_streamlines.h"
#include "data/streamlines/separation_lines.h"
#include "data/topology/point_flow.h"
#include "data/topology/surface_topology.h"
#include "description/scene_surfaces.h"
#include "engine/place_values.h"
#include "render/overlay/streamline_strokes.h"

namespace aeolic {
namespace {

/// Values that were looked up all at once, given out again in their order.
class ValuesInTurn {
public:
    explicit ValuesInTurn(std::vector<SurfaceValues> values) : values_(std::move(values)) {}

    SurfaceValues next() { return values_[given_++]; }
    std::vector<SurfaceValues> next(std::size_t count)
    {
        const auto begin = values_.begin() + std::ptrdiff_t(given_);
        given_ += count;
        return {begin, begin + std::ptrdiff_t(count)};
    }

private:
    std::vector<SurfaceValues> values_;
    std::size_t given_ = 0;
};

FlowTopology emptyTopology(const Scene& scene)
{
    FlowTopology topology;
    topology.scalar = scene.hasScalar ? scene.scalarName : "";
    return topology;
}

/// Parts of one streamline, from the most upstream on.
using Parts = std::vector<const EvenStreamline*>;

std::vector<Parts> chainsOf(const std::vector<EvenStreamline>& lines, int levels)
{
    std::map<std::uint32_t, Parts> byChain;
    for (const EvenStreamline& line : lines)
        if (line.level < levels) byChain[line.chain].push_back(&line);
    std::vector<Parts> chains;
    for (auto& [chain, parts] : byChain) {
        std::sort(parts.begin(), parts.end(), [](const EvenStreamline* a, const EvenStreamline* b) {
            return a->points.front().arc < b->points.front().arc;
        });
        chains.push_back(parts);
    }
    return chains;
}

/// All places of a streamline. A part begins where the one before ends.
std::vector<SurfacePlace> placesOf(const Parts& parts)
{
    std::vector<SurfacePlace> places;
    for (const EvenStreamline* part : parts)
        for (std::size_t i = part == parts.front() ? 0 : 1; i < part->points.size(); ++i)
            places.push_back(part->points[i].place);
    return places;
}

SurfaceStreamline streamlineOf(const Parts& parts, std::vector<SurfaceValues> places)
{
    SurfaceStreamline line;
    line.closed = parts.size() == 1 && parts[0]->points.front().at == parts[0]->points.back().at;
    line.places = std::move(places);
    for (std::size_t i = 1; i < line.places.size(); ++i)
        line.length += glm::distance(vectorOf(line.places[i].position), vectorOf(line.places[i - 1].position));
    return line;
}

}  // namespace

FlowTopology openLines(const Scene& scene, double persistence, const FieldLookup& lookUp)
{
    const PointFlow flow = pointFlow(scene, lookUp);
    const StreamlineSurface surface(flow.mesh, flow.vectors);
    const std::vector<SeparationLine> found = separationLines(surface, persistence);
    std::vector<SurfacePlace> places;
    for (const SeparationLine& line : found) appendAll(places, line.places);
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
    const SurfaceTopology found = surfaceTopology(flow.mesh, flow.vectors, persistence);
    std::vector<SurfacePlace> places;
    for (const CriticalPoint& point : found.points) places.push_back(point.place);
    for (const TopologyLine& line : found.lines) appendAll(places, line.places);
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

EvenSurfaceLines surfaceStreamlines(const Scene& scene, const View& view, double spacingPx, const FieldLookup& lookUp)
{
    const PointFlow flow = pointFlow(scene, lookUp);
    const glm::vec3 middle = fromEye(view, glm::vec3(0));
    const double depth = std::max(double(middle.z), view.nearDepth) * view.unitWorld;
    const double askedWorld = double(spacingIn(view.camera, spacingPx)) * depth / double(view.focalPx);
    EvenStreamlines all(flow.mesh, flow.vectors, askedWorld);
    EvenSurfaceLines found;
    found.scalar = scene.hasScalar ? scene.scalarName : "";
    const double finer = std::log2(all.spacing(0) * all.unitWorld() / askedWorld);
    const int level = std::isfinite(finer) ? int(std::lround(std::clamp(finer, 0.0, 30.0))) : 0;
    all.refineTo(level);
    if (all.levels() == 0) return found;
    found.spacing = all.spacing(std::min(level, all.levels() - 1)) * all.unitWorld();
    const std::vector<Parts> chains = chainsOf(all.lines(), level + 1);
    std::vector<std::size_t> counts;
    std::vector<SurfacePlace> places;
    for (const Parts& parts : chains) {
        const std::vector<SurfacePlace> own = placesOf(parts);
        counts.push_back(own.size());
        appendAll(places, own);
    }
    ValuesInTurn values(valuesAt(scene, flow, places, lookUp));
    for (std::size_t i = 0; i < chains.size(); ++i)
        found.lines.push_back(streamlineOf(chains[i], values.next(counts[i])));
    return found;
}

}  // namespace aeolic
