#include "output/polydata_text.h"

#include <fmt/format.h>

#include <bit>
#include <type_traits>

#include "base/text.h"

namespace aeolic {
namespace {

constexpr const char* kVectors = "vectors";

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

}  // namespace

std::int64_t SurfacePolydata::addPlace(const SurfaceValues& at)
{
    positions_.insert(positions_.end(), at.position.begin(), at.position.end());
    vectors_.insert(vectors_.end(), at.vector.begin(), at.vector.end());
    scalars_.push_back(at.scalar);
    return std::int64_t(scalars_.size()) - 1;
}

void SurfacePolydata::addPoint(const SurfaceValues& at)
{
    verts_.push_back(addPlace(at));
    vertEnds_.push_back(std::int64_t(verts_.size()));
}

void SurfacePolydata::addLine(const std::vector<SurfaceValues>& places)
{
    for (const SurfaceValues& place : places) lines_.push_back(addPlace(place));
    lineEnds_.push_back(std::int64_t(lines_.size()));
}

std::string SurfacePolydata::text(const std::string& scalarName) const
{
    static_assert(std::endian::native == std::endian::little);
    Appended data;
    std::string text = "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">";
    text += fmt::format(
        "<PolyData><Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
        "NumberOfStrips=\"0\" NumberOfPolys=\"0\">",
        scalars_.size(), vertEnds_.size(), lineEnds_.size());
    text += "<Points>" + data.array("Points", 3, positions_) + "</Points>";
    text += fmt::format("<PointData Vectors=\"{}\">", kVectors) + data.array(kVectors, 3, vectors_);
    const std::string scalar = scalarName == kVectors ? scalarName + " (scalar)" : scalarName;
    if (!scalar.empty()) text += data.array(scalar, 1, scalars_);
    text += "</PointData><CellData>";
    for (const auto& [name, values] : whole_) text += data.array(name, 1, values);
    for (const auto& [name, values] : numbers_) text += data.array(name, 1, values);
    text += "</CellData>";
    text += "<Verts>" + data.array("connectivity", 1, verts_) + data.array("offsets", 1, vertEnds_) + "</Verts>";
    text += "<Lines>" + data.array("connectivity", 1, lines_) + data.array("offsets", 1, lineEnds_) + "</Lines>";
    text += "</Piece></PolyData><AppendedData encoding=\"raw\">_";
    return text + data.bytes() + "</AppendedData></VTKFile>\n";
}

std::string csvText(const std::string& text)
{
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + '"';
}

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

}  // namespace aeolic
