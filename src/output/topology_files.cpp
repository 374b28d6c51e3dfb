#include "output/topology_files.h"

#include <fmt/format.h>

#include <cstdint>
#include <vector>

#include "output/polydata_text.h"

namespace aeolic {
namespace {

constexpr int kSeparation = 5, kAttachment = 6;

int typeOf(const FlowPoint& point)
{
    return int(point.kind);
}

int typeOf(const FlowLine& line)
{
    return line.separates ? kSeparation : kAttachment;
}

}  // namespace

const char* nameOf(CriticalPointKind kind)
{
    static constexpr const char* names[] = {"node", "focus", "centre", "saddle", "multiple"};
    return names[std::size_t(kind)];
}

int attraction(const FlowPoint& point)
{
    const bool isEither = point.kind == CriticalPointKind::node || point.kind == CriticalPointKind::focus;
    return !isEither ? 0 : point.attracts ? 1 : -1;
}

std::string topologyVtp(const FlowTopology& topology)
{
    SurfacePolydata data;
    std::vector<double> strengths, lengths;
    std::vector<std::int64_t> types, attracts, indices;
    for (const FlowPoint& point : topology.points) {
        data.addPoint(point.at);
        types.push_back(typeOf(point));
        attracts.push_back(attraction(point));
        indices.push_back(point.index);
        strengths.push_back(point.strength);
        lengths.push_back(0);
    }
    for (const FlowLine& line : topology.lines) {
        data.addLine(line.places);
        types.push_back(typeOf(line));
        attracts.push_back(0);
        indices.push_back(0);
        strengths.push_back(line.strength);
        lengths.push_back(line.length);
    }
    data.addWhole("type", types);
    data.addWhole("attracts", attracts);
    data.addWhole("index", indices);
    data.addNumbers("strength", strengths);
    data.addNumbers("length", lengths);
    return data.text(topology.scalar);
}

std::string topologyCsv(const FlowTopology& topology)
{
    const bool hasScalar = !topology.scalar.empty();
    std::string text = "line,type,attracts,index,strength,length" + csvPlaceNames(topology.scalar) + "\n";
    for (const FlowPoint& point : topology.points)
        text += fmt::format(",{},{},{},{},0{}\n", nameOf(point.kind), attraction(point), point.index, point.strength,
                            csvPlace(point.at, hasScalar));
    for (std::size_t i = 0; i < topology.lines.size(); ++i) {
        const FlowLine& line = topology.lines[i];
        for (const SurfaceValues& place : line.places)
            text += fmt::format("{},{},0,0,{},{}{}\n", i, line.separates ? "separation" : "attachment", line.strength,
                                line.length, csvPlace(place, hasScalar));
    }
    return text;
}

}  // namespace aeolic
