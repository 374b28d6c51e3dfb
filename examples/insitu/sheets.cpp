#include "sheets.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace {

constexpr float kBesideWall = 1.5F;      // Cells: nearer, the flow is the wall's.
constexpr int kRound = 96, kAlong = 24;  // Quads of the cylinder's wall.

/// Between the eight cells around a place. Solid ones count as resting.
std::array<float, 3> velocityAt(const Lattice& lattice, const std::array<float, 3>& place)
{
    const auto& size = lattice.size();
    std::array<float, 3> u{};
    const int x0 = std::clamp(int(place[0]), 0, size[0] - 2), y0 = std::clamp(int(place[1]), 0, size[1] - 2);
    const int z0 = int(place[2]);
    for (int corner = 0; corner < 8; ++corner) {
        const int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
        const float fx = place[0] - float(x0), fy = place[1] - float(y0), fz = place[2] - float(z0);
        const float part = (dx ? fx : 1 - fx) * (dy ? fy : 1 - fy) * (dz ? fz : 1 - fz);
        const float* v = lattice.velocity(x0 + dx, y0 + dy, z0 + dz);
        for (std::size_t k = 0; k < 3; ++k) u[k] += part * v[k];
    }
    return u;
}

void writeArray(std::FILE* file, const char* type, const char* attributes, const auto& values, const char* format)
{
    std::fprintf(file, "<DataArray type=\"%s\" %s format=\"ascii\">", type, attributes);
    for (const auto value : values) std::fprintf(file, format, value);
    std::fprintf(file, "</DataArray>\n");
}

}  // namespace

Sheets::Sheets(const Lattice& lattice, MPI_Comm ranks) : ranks_(ranks)
{
    addSheet(lattice);
    addWall(lattice);
    velocities_.resize(points_.size());
    update(lattice);
}

/// A point for each cell of the middle layer x = constant. The next rank's first row belongs to both.
void Sheets::addSheet(const Lattice& lattice)
{
    const int ny = lattice.size()[1], last = std::min(lattice.endLayer(), lattice.size()[2] - 1);
    for (int z = lattice.firstLayer(); z <= last; ++z)
        for (int y = 0; y < ny; ++y)
            for (const int c : {lattice.size()[0] / 2, y, z}) points_.push_back(float(c));
    for (std::int64_t z = 0; z < last - lattice.firstLayer(); ++z)
        for (std::int64_t y = 0; y + 1 < ny; ++y) {
            const float dy = float(y) + 0.5F - lattice.centerY(),
                        dz = float(lattice.firstLayer() + z) + 0.5F - lattice.centerZ();
            if (dy * dy + dz * dz < lattice.radius() * lattice.radius())
                continue;  // Within the cylinder nothing flows.
            const std::int64_t a = z * ny + y, b = a + ny;
            triangles_.insert(triangles_.end(), {a, a + 1, b + 1, a, b + 1, b});
        }
}

void Sheets::addWall(const Lattice& lattice)
{
    const float length = float(lattice.size()[0] - 1), pi = std::acos(-1.0F);
    std::vector<std::array<float, 3>> places;
    for (int i = 0; i <= kAlong; ++i)
        for (int k = 0; k < kRound; ++k) {
            const float angle = 2 * pi * float(k) / kRound, x = length * float(i) / kAlong;
            const auto at = [&](float r) {
                return std::array{x, lattice.centerY() + r * std::sin(angle), lattice.centerZ() + r * std::cos(angle)};
            };
            places.push_back(at(lattice.radius()));
            samples_.push_back(at(lattice.radius() + kBesideWall));
        }
    wallPoints_.assign(places.size(), -1);
    const auto pointOf = [&](std::size_t place) {
        int& point = wallPoints_[place];
        if (point < 0) {
            point = int(points_.size() / 3);
            points_.insert(points_.end(), places[place].begin(), places[place].end());
        }
        return std::int64_t(point);
    };
    for (std::size_t i = 0; i < kAlong; ++i)
        for (std::size_t k = 0; k < kRound; ++k) {
            const std::size_t a = i * kRound + k, b = i * kRound + (k + 1) % kRound, c = b + kRound, d = a + kRound;
            for (const auto& corners : {std::array{a, b, c}, std::array{a, c, d}}) {
                float lowest = places[corners[0]][2];
                for (const std::size_t corner : corners) lowest = std::min(lowest, places[corner][2]);
                if (lowest < float(lattice.firstLayer()) || lowest >= float(lattice.endLayer())) continue;
                for (const std::size_t corner : corners) triangles_.push_back(pointOf(corner));
            }
        }
}

void Sheets::update(const Lattice& lattice)
{
    const int ny = lattice.size()[1], last = std::min(lattice.endLayer(), lattice.size()[2] - 1);
    std::size_t point = 0;
    for (int z = lattice.firstLayer(); z <= last; ++z)
        for (int y = 0; y < ny; ++y, ++point)
            std::copy_n(lattice.velocity(lattice.size()[0] / 2, y, z), 3, &velocities_[3 * point]);
    // A corner of a rank's triangles may lie in another one's layers: who has the layer looks the flow up for all.
    std::vector<float> wall(3 * samples_.size(), 0);
    for (std::size_t i = 0; i < samples_.size(); ++i)
        if (samples_[i][2] >= float(lattice.firstLayer()) && samples_[i][2] < float(lattice.endLayer())) {
            const auto u = velocityAt(lattice, samples_[i]);
            std::copy(u.begin(), u.end(), &wall[3 * i]);
        }
    MPI_Allreduce(MPI_IN_PLACE, wall.data(), int(wall.size()), MPI_FLOAT, MPI_SUM, ranks_);  // All but one are 0.
    for (std::size_t i = 0; i < samples_.size(); ++i)
        if (wallPoints_[i] >= 0) std::copy_n(&wall[3 * i], 3, &velocities_[3 * std::size_t(wallPoints_[i])]);
}

aeolic::Data Sheets::data() const
{
    const auto points = std::int64_t(points_.size() / 3);
    aeolic::Data data;
    data.surface.emplace();
    data.surface->points = aeolic::ArrayView(points_.data(), points, 3);
    data.surface->triangles = aeolic::ArrayView(triangles_.data(), std::int64_t(triangles_.size() / 3), 3);
    data.surface->pointArrays = {{"velocity", aeolic::ArrayView(velocities_.data(), points, 3)}};
    return data;
}

void Sheets::write(const std::string& folder, const std::string& name) const
{
    int rank = 0, count = 1;
    MPI_Comm_rank(ranks_, &rank);
    MPI_Comm_size(ranks_, &count);
    const auto pieceOf = [&](int of) { return name + "-" + std::to_string(of) + ".vtp"; };
    std::FILE* file = std::fopen((folder + "/" + pieceOf(rank)).c_str(), "w");
    if (!file) throw std::runtime_error(folder + "/" + pieceOf(rank) + ": cannot be written");
    std::vector<std::int64_t> ends;
    for (std::size_t i = 3; i <= triangles_.size(); i += 3) ends.push_back(std::int64_t(i));
    std::fprintf(
        file,
        "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"><PolyData>\n"
        "<Piece NumberOfPoints=\"%zu\" NumberOfPolys=\"%zu\"><PointData>\n",
        points_.size() / 3, ends.size());
    writeArray(file, "Float32", "Name=\"velocity\" NumberOfComponents=\"3\"", velocities_, "%.9g ");
    std::fprintf(file, "</PointData><Points>\n");
    writeArray(file, "Float32", "Name=\"Points\" NumberOfComponents=\"3\"", points_, "%.9g ");
    std::fprintf(file, "</Points><Polys>\n");
    writeArray(file, "Int64", "Name=\"connectivity\"", triangles_, "%ld ");
    writeArray(file, "Int64", "Name=\"offsets\"", ends, "%ld ");
    std::fprintf(file, "</Polys></Piece></PolyData></VTKFile>\n");
    if (std::fclose(file) != 0) throw std::runtime_error(folder + "/" + pieceOf(rank) + ": cannot be written");
    if (rank != 0) return;
    file = std::fopen((folder + "/" + name + ".pvtp").c_str(), "w");
    if (!file) throw std::runtime_error(folder + "/" + name + ".pvtp: cannot be written");
    std::fprintf(
        file,
        "<VTKFile type=\"PPolyData\" version=\"1.0\" byte_order=\"LittleEndian\"><PPolyData GhostLevel=\"0\">\n"
        "<PPointData><PDataArray type=\"Float32\" Name=\"velocity\" NumberOfComponents=\"3\"/></PPointData>\n"
        "<PPoints><PDataArray type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\"/></PPoints>\n");
    for (int of = 0; of < count; ++of) std::fprintf(file, "<Piece Source=\"%s\"/>\n", pieceOf(of).c_str());
    std::fprintf(file, "</PPolyData></VTKFile>\n");
    std::fclose(file);
}
