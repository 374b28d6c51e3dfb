#include <fstream>
#include <iomanip>

#include "scene_memory_testing.h"

namespace aeolic::testkit {
namespace {

constexpr int side[3] = {6, 5, 4};  // Points.

std::int64_t pointAt(int x, int y, int z)
{
    return (z * side[1] + y) * side[0] + x;
}

template <class Value>
void writeArray(std::ostream& file, const char* type, const char* name, const std::vector<Value>& values,
                std::size_t components = 1)
{
    file << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << components
         << "\" format=\"ascii\">";
    for (const Value value : values) file << +value << ' ';  // A byte as a number.
    file << "</DataArray>\n";
}

}  // namespace

MemoryVolume::MemoryVolume(double stretch, double scale)
{
    for (int z = 0; z < side[2]; ++z)
        for (int y = 0; y < side[1]; ++y)
            for (int x = 0; x < side[0]; ++x) {
                const float at[3] = {float(-0.3 + 0.3 * x + stretch * x * x), float(-0.25 + 0.4 * y),
                                     float(-0.45 + 0.4 * z)};
                points.insert(points.end(), at, at + 3);
                for (const double c : test::sampleVector(double(at[0]), double(at[1]), double(at[2])))
                    u.push_back(float(scale * c));
                p.push_back(float(scale * test::sampleScalar(double(at[0]), double(at[1]), double(at[2]))));
            }
    for (int z = 0; z + 1 < side[2]; ++z)
        for (int y = 0; y + 1 < side[1]; ++y)
            for (int x = 0; x + 1 < side[0]; ++x) {
                std::array<std::int64_t, 8> c;  // As of a hexahedron.
                for (int k = 0; k < 8; ++k)
                    c[std::size_t(k)] = pointAt(x + (k % 4 == 1 || k % 4 == 2), y + (k % 4 > 1), z + (k > 3));
                switch ((x + 2 * y + 3 * z) % 6) {
                    case 0:
                        addCell(12, {c.begin(), c.end()}, scale);
                        break;
                    case 1:
                        addCell(11, {c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6]}, scale);
                        break;
                    case 2:  // Two wedges.
                        addCell(13, {c[0], c[1], c[3], c[4], c[5], c[7]}, scale);
                        addCell(13, {c[1], c[2], c[3], c[5], c[6], c[7]}, scale);
                        break;
                    case 3:  // Five tetrahedra.
                        for (const auto& t : {std::array{0, 1, 3, 4}, std::array{1, 2, 3, 6}, std::array{4, 6, 5, 1},
                                              std::array{4, 7, 6, 3}, std::array{1, 3, 4, 6}}) {
                            std::vector<std::int64_t> ids;
                            for (const int k : t) ids.push_back(c[std::size_t(k)]);
                            addCell(10, ids, scale);
                        }
                        break;
                    case 4:  // Three pyramids, with the same tip.
                        addCell(14, {c[0], c[3], c[7], c[4], c[6]}, scale);
                        addCell(14, {c[0], c[4], c[5], c[1], c[6]}, scale);
                        addCell(14, {c[0], c[1], c[2], c[3], c[6]}, scale);
                        break;
                    default:
                        addCell(42, {c.begin(), c.end()}, scale);
                        faceLocations.back() = std::int64_t(faces.size());
                        faces.push_back(6);
                        for (const auto& face :
                             {std::array{0, 3, 2, 1}, std::array{4, 5, 6, 7}, std::array{0, 1, 5, 4},
                              std::array{1, 2, 6, 5}, std::array{2, 3, 7, 6}, std::array{3, 0, 4, 7}}) {
                            faces.push_back(4);
                            for (const int k : face) faces.push_back(c[std::size_t(k)]);
                        }
                }
            }
}

void MemoryVolume::addCell(std::uint8_t type, const std::vector<std::int64_t>& ids, double scale)
{
    types.push_back(type);
    corners.insert(corners.end(), ids.begin(), ids.end());
    offsets.push_back(std::int64_t(corners.size()));
    faceLocations.push_back(-1);
    double middle[3] = {0, 0, 0};
    for (const std::int64_t id : ids)
        for (std::size_t c = 0; c < 3; ++c) middle[c] += double(points[std::size_t(3 * id) + c]) / double(ids.size());
    for (const double c : test::sampleVector(middle[0], middle[1], middle[2])) cellU.push_back(float(scale * c));
    cellP.push_back(scale * test::sampleScalar(middle[0], middle[1], middle[2]));
}

Volume MemoryVolume::volume() const
{
    const auto count = std::int64_t(p.size()), cells = std::int64_t(types.size());
    Volume v;
    v.points = ArrayView(points.data(), count, 3);
    v.types = ArrayView(types.data(), cells);
    v.offsets = ArrayView(offsets.data(), cells + 1);
    v.connectivity = ArrayView(corners.data(), std::int64_t(corners.size()));
    v.faces = ArrayView(faces.data(), std::int64_t(faces.size()));
    v.faceLocations = ArrayView(faceLocations.data(), cells);
    v.pointArrays = {{"U", ArrayView(u.data(), count, 3)}, {"p", ArrayView(p.data(), count)}};
    v.cellArrays = {{"cellU", ArrayView(cellU.data(), cells, 3)}, {"cellP", ArrayView(cellP.data(), cells)}};
    return v;
}

void MemoryVolume::write(const std::string& path) const
{
    std::ofstream file(path);
    file << std::setprecision(17)
         << "<?xml version=\"1.0\"?><VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
            "header_type=\"UInt64\"><UnstructuredGrid>\n<Piece NumberOfPoints=\""
         << p.size() << "\" NumberOfCells=\"" << types.size() << "\"><PointData>\n";
    writeArray(file, "Float32", "U", u, 3);
    writeArray(file, "Float32", "p", p);
    file << "</PointData><CellData>\n";
    writeArray(file, "Float32", "cellU", cellU, 3);
    writeArray(file, "Float64", "cellP", cellP);
    file << "</CellData><Points>\n";
    writeArray(file, "Float32", "Points", points, 3);
    file << "</Points><Cells>\n";
    writeArray(file, "Int64", "connectivity", corners);
    writeArray(file, "Int64", "offsets", std::vector(offsets.begin() + 1, offsets.end()));
    writeArray(file, "UInt8", "types", types);
    std::vector<std::int64_t> ends;  // A file says where a polyhedron's faces end.
    for (const std::int64_t at : faceLocations) ends.push_back(at < 0 ? -1 : at + 1 + 6 * 5);
    writeArray(file, "Int64", "faces", faces);
    writeArray(file, "Int64", "faceoffsets", ends);
    file << "</Cells></Piece></UnstructuredGrid></VTKFile>\n";
}

}  // namespace aeolic::testkit
