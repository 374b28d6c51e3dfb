#include "output/topology_files.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <type_traits>

#include "base/text.h"

namespace aeolic {
namespace {

constexpr int kSeparation = 5, kAttachment = 6;
constexpr const char* kVectors = "vectors";

int typeOf(const FlowPoint& point)
{
    return int(point.kind);
}

int typeOf(const FlowLine& line)
{
    return line.separates ? kSeparation : kAttachment;
}

/// Arrays of a VTK XML file, whose numbers stand behind it as they are in memory: in text VTK 9.1 reads no NaN.
class Appended {
public:
    template <class Number>
    std::string array(const std::string& name, int components, const std::vector<Number>& numbers)
    {
        std::string element = fmt::format(
            "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>",
            std::is_floating_point_v<Number> ? "Float64" : "Int64", xmlText(name), components, bytes_.size());
        const std::uint64_t size = sizeof(Number) * numbers.size();
        bytes_.append(reinterpret_cast<const char*>(&size), sizeof(size));
        bytes_.append(reinterpret_cast<const char*>(numbers.data()), size);
        return element;
    }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

std::string csvText(const std::string& text)
{
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + '"';
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
    static_assert(std::endian::native == std::endian::little);
    std::vector<double> positions, vectors, scalars, strengths, lengths;
    std::vector<std::int64_t> verts, lines, lineEnds, vertEnds, types, attracts, indices;
    const auto addPlace = [&](const SurfaceValues& at) {
        positions.insert(positions.end(), at.position.begin(), at.position.end());
        vectors.insert(vectors.end(), at.vector.begin(), at.vector.end());
        scalars.push_back(at.scalar);
        return std::int64_t(scalars.size()) - 1;
    };
    for (const FlowPoint& point : topology.points) {
        verts.push_back(addPlace(point.at));
        vertEnds.push_back(std::int64_t(verts.size()));
        types.push_back(typeOf(point));
        attracts.push_back(attraction(point));
        indices.push_back(point.index);
        strengths.push_back(point.strength);
        lengths.push_back(0);
    }
    for (const FlowLine& line : topology.lines) {
        for (const SurfaceValues& place : line.places) lines.push_back(addPlace(place));
        lineEnds.push_back(std::int64_t(lines.size()));
        types.push_back(typeOf(line));
        attracts.push_back(0);
        indices.push_back(0);
        strengths.push_back(topology.points[line.saddle].strength);
        lengths.push_back(line.length);
    }
    Appended data;
    std::string text = "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">";
    text += fmt::format(
        "<PolyData><Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
        "NumberOfStrips=\"0\" NumberOfPolys=\"0\">",
        scalars.size(), vertEnds.size(), lineEnds.size());
    text += "<Points>" + data.array("Points", 3, positions) + "</Points>";
    text += fmt::format("<PointData Vectors=\"{}\">", kVectors) + data.array(kVectors, 3, vectors);
    const std::string scalar = topology.scalar == kVectors ? topology.scalar + " (scalar)" : topology.scalar;
    if (!scalar.empty()) text += data.array(scalar, 1, scalars);
    text += "</PointData><CellData>" + data.array("type", 1, types) + data.array("attracts", 1, attracts) +
            data.array("index", 1, indices) + data.array("strength", 1, strengths) + data.array("length", 1, lengths) +
            "</CellData>";
    text += "<Verts>" + data.array("connectivity", 1, verts) + data.array("offsets", 1, vertEnds) + "</Verts>";
    text += "<Lines>" + data.array("connectivity", 1, lines) + data.array("offsets", 1, lineEnds) + "</Lines>";
    text += "</Piece></PolyData><AppendedData encoding=\"raw\">_";
    return text + data.bytes() + "</AppendedData></VTKFile>\n";
}

std::string topologyCsv(const FlowTopology& topology)
{
    const bool hasScalar = !topology.scalar.empty();
    std::string text = "line,type,attracts,index,strength,length,x,y,z,vector x,vector y,vector z";
    text += hasScalar ? "," + csvText(topology.scalar) + "\n" : "\n";
    const auto addPlace = [&](const SurfaceValues& at) {
        text += fmt::format(",{},{},{},{},{},{}", at.position[0], at.position[1], at.position[2], at.vector[0],
                            at.vector[1], at.vector[2]);
        text += hasScalar ? fmt::format(",{}\n", at.scalar) : "\n";
    };
    for (const FlowPoint& point : topology.points) {
        text += fmt::format(",{},{},{},{},0", nameOf(point.kind), attraction(point), point.index, point.strength);
        addPlace(point.at);
    }
    for (std::size_t i = 0; i < topology.lines.size(); ++i) {
        const FlowLine& line = topology.lines[i];
        for (const SurfaceValues& place : line.places) {
            text += fmt::format("{},{},0,0,{},{}", i, line.separates ? "separation" : "attachment",
                                topology.points[line.saddle].strength, line.length);
            addPlace(place);
        }
    }
    return text;
}

}  // namespace aeolic
