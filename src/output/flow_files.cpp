#include "output/flow_files.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/text.h"

namespace aeolic {
namespace {

constexpr const char* kVectors = "vectors";
constexpr int kSeparation = 5, kAttachment = 6;

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

/// Points and lines on a surface, on the way to a VTK XML polydata file. Cells are the single points first, and then
/// the lines, both in the order in which they came.
class SurfacePolydata {
public:
    void addPoint(const SurfaceValues& at)
    {
        verts_.push_back(addPlace(at));
        vertEnds_.push_back(std::int64_t(verts_.size()));
    }

    void addLine(const std::vector<SurfaceValues>& places)
    {
        for (const SurfaceValues& place : places) lines_.push_back(addPlace(place));
        lineEnds_.push_back(std::int64_t(lines_.size()));
    }

    /// Arrays of the cells: values of the points and then of the lines.
    std::vector<std::pair<const char*, std::vector<std::int64_t>>> whole;
    std::vector<std::pair<const char*, std::vector<double>>> numbers;

    std::string text(const std::string& scalarName) const
    {
        static_assert(std::endian::native == std::endian::little);
        Appended data;
        std::string text =
            "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">";
        text += fmt::format(
            "<PolyData><Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
            "NumberOfStrips=\"0\" NumberOfPolys=\"0\">",
            scalars_.size(), vertEnds_.size(), lineEnds_.size());
        text += "<Points>" + data.array("Points", 3, positions_) + "</Points>";
        text += fmt::format("<PointData Vectors=\"{}\">", kVectors) + data.array(kVectors, 3, vectors_);
        const std::string scalar = scalarName == kVectors ? scalarName + " (scalar)" : scalarName;
        if (!scalar.empty()) text += data.array(scalar, 1, scalars_);
        text += "</PointData><CellData>";
        for (const auto& [name, values] : whole) text += data.array(name, 1, values);
        for (const auto& [name, values] : numbers) text += data.array(name, 1, values);
        text += "</CellData>";
        text += "<Verts>" + data.array("connectivity", 1, verts_) + data.array("offsets", 1, vertEnds_) + "</Verts>";
        text += "<Lines>" + data.array("connectivity", 1, lines_) + data.array("offsets", 1, lineEnds_) + "</Lines>";
        text += "</Piece></PolyData><AppendedData encoding=\"raw\">_";
        return text + data.bytes() + "</AppendedData></VTKFile>\n";
    }

private:
    std::int64_t addPlace(const SurfaceValues& at)
    {
        positions_.insert(positions_.end(), at.position.begin(), at.position.end());
        vectors_.insert(vectors_.end(), at.vector.begin(), at.vector.end());
        scalars_.push_back(at.scalar);
        return std::int64_t(scalars_.size()) - 1;
    }

    std::vector<double> positions_, vectors_, scalars_;
    std::vector<std::int64_t> verts_, vertEnds_, lines_, lineEnds_;
};

/// A text as a field of comma-separated values: in quotes where it has to be.
std::string csvText(const std::string& text)
{
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + '"';
}

/// The columns of a place in comma-separated values, with a comma in front of each: position, vector and, where it has
/// a name, the scalar. The names, and the values.
std::string csvPlaceNames(const std::string& scalarName)
{
    return ",x,y,z,vector x,vector y,vector z" + (scalarName.empty() ? "" : "," + csvText(scalarName));
}

std::string csvPlace(const SurfaceValues& at, bool hasScalar)
{
    std::string text = fmt::format(",{},{},{},{},{},{}", at.position[0], at.position[1], at.position[2], at.vector[0],
                                   at.vector[1], at.vector[2]);
    return hasScalar ? text + fmt::format(",{}", at.scalar) : text;
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
        types.push_back(int(point.kind));
        attracts.push_back(attraction(point));
        indices.push_back(point.index);
        strengths.push_back(point.strength);
        lengths.push_back(0);
    }
    for (const FlowLine& line : topology.lines) {
        data.addLine(line.places);
        types.push_back(line.separates ? kSeparation : kAttachment);
        attracts.push_back(0);
        indices.push_back(0);
        strengths.push_back(line.strength);
        lengths.push_back(line.length);
    }
    data.whole = {{"type", types}, {"attracts", attracts}, {"index", indices}};
    data.numbers = {{"strength", strengths}, {"length", lengths}};
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

std::string streamlinesVtp(const EvenSurfaceLines& lines)
{
    SurfacePolydata data;
    std::vector<double> lengths;
    std::vector<std::int64_t> closed;
    for (const SurfaceStreamline& line : lines.lines) {
        data.addLine(line.places);
        lengths.push_back(line.length);
        closed.push_back(line.closed ? 1 : 0);
    }
    data.whole = {{"closed", closed}};
    data.numbers = {{"length", lengths}};
    return data.text(lines.scalar);
}

std::string streamlinesCsv(const EvenSurfaceLines& lines)
{
    std::string text = "line,length,closed" + csvPlaceNames(lines.scalar) + "\n";
    for (std::size_t i = 0; i < lines.lines.size(); ++i) {
        const SurfaceStreamline& line = lines.lines[i];
        for (const SurfaceValues& place : line.places)
            text += fmt::format("{},{},{}{}\n", i, line.length, line.closed ? 1 : 0,
                                csvPlace(place, !lines.scalar.empty()));
    }
    return text;
}

}  // namespace aeolic
