#include "reader/openfoam/foam_volume.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <iterator>
#include <utility>

#include "reader/openfoam/foam_mesh.h"
#include "reader/openfoam/foam_points.h"

namespace aeolic {
namespace {

using FaceCorners = std::span<const std::uint32_t>;

/// Whether the face's last corner lies on the edge between those beside it, about. A triangle of these three is flat.
bool isFlatAtLast(FaceCorners face, const std::vector<glm::dvec3>& points)
{
    const auto point = [&](std::size_t k) { return glm::vec3(points[face[k]]); };
    const glm::vec3 last = point(face.size() - 1), one = point(0) - last, other = point(face.size() - 2) - last;
    float oneSquared = 0, otherSquared = 0, product = 0;
    for (int c = 0; c < 3; ++c) {
        oneSquared += one[c] * one[c];
        otherSquared += other[c] * other[c];
        product += one[c] * other[c];
    }
    return product * std::abs(product) / (oneSquared * otherSquared) < -1.0f + 1.0e-3f;
}

class StarMaker {
public:
    StarMaker(const CellsOfFaces& all, std::vector<glm::dvec3>& points) : all_(all), points_(points) {}

    /// Cells that come in the place of those of a list of polyhedra, which begins with the cell `first`.
    void take(const PartCells& polyhedra, std::size_t first, std::vector<PartCells>& to)
    {
        for (std::size_t cell = first; cell < first + polyhedra.count; ++cell) {
            cell_ = cell;
            to_ = &to;
            const auto apex = std::int64_t(points_.size());
            points_.push_back(middleOf(cell));
            for (const std::int32_t number : all_.facesOf(cell))
                takeFace(all_.faces().face(std::size_t(std::abs(number)) - 1), number > 0, apex);
        }
    }

    std::vector<PartCells> others;
    std::vector<std::size_t> ofCells;

private:
    glm::dvec3 middleOf(std::size_t cell)
    {
        corners_.clear();
        glm::dvec3 sum{0};
        for (const std::int32_t number : all_.facesOf(cell))
            for (const std::uint32_t corner : all_.faces().face(std::size_t(std::abs(number)) - 1)) {
                if (std::find(corners_.begin(), corners_.end(), corner) != corners_.end()) continue;
                corners_.push_back(corner);
                sum += points_[corner];
            }
        const double weight = 1.0 / double(corners_.size());
        return {nearestFloat(sum.x * weight), nearestFloat(sum.y * weight), nearestFloat(sum.z * weight)};
    }

    /// Two triangles of a fan at a time make a pyramid's base; the last one, if it is left over, that of a tetrahedron.
    void takeFace(FaceCorners face, bool inside, std::int64_t apex)
    {
        const std::size_t size = face.size(), odd = size % 2;
        std::size_t k = size >= 5 && odd && isFlatAtLast(face, points_) ? 1 : 2;
        const std::int64_t base = k == 2 ? face[0] : face[size - 1];
        for (; k < size - 1 - odd; k += 2) {
            if (inside)
                add(CellShape::pyramid, {base, face[k + 1], face[k], face[k - 1], apex});
            else
                add(CellShape::pyramid, {base, face[k - 1], face[k], face[k + 1], apex});
        }
        if (odd && inside) add(CellShape::tetra, {base, face[k], face[k - 1], apex});
        if (odd && !inside) add(CellShape::tetra, {base, face[k - 1], face[k], apex});
    }

    void add(CellShape shape, std::initializer_list<std::int64_t> corners)
    {
        const bool isFirst = to_ != nullptr;
        std::vector<PartCells>& cells = isFirst ? *std::exchange(to_, nullptr) : others;
        if (!isFirst) ofCells.push_back(cell_);
        if (cells.empty() || cells.back().shape != shape) cells.push_back({shape, 0, {}, {}, {}});
        ++cells.back().count;
        cells.back().corners.insert(cells.back().corners.end(), corners);
    }

    const CellsOfFaces& all_;
    std::vector<glm::dvec3>& points_;
    std::vector<std::uint32_t> corners_;
    std::size_t cell_ = 0;
    std::vector<PartCells>* to_ = nullptr;  // Null once the cell's place is taken.
};

/// The cells of one region in one folder.
struct Volume {
    std::vector<glm::dvec3> points;
    std::vector<PartCells> cells;
    std::vector<std::vector<float>> values;  ///< [fields]
};

Volume readOne(const FoamCase& foam, const FoamPath& folder, const std::string& region, double time,
               const std::vector<FoamField>& fields, bool polyhedra)
{
    FoamMesh mesh = readFoamMesh(folder, region, time);
    Volume volume;
    volume.points = std::move(mesh.points);
    std::vector<std::size_t> added;  // Of which cell each is that stands behind the others.
    if (mesh.cells > 0) {
        const CellsOfFaces all(std::move(mesh.faces), mesh.cells, FirstCorner::first,
                               foamFileOf(foamMeshFile(folder, region, time, "owner")));
        volume.cells = all.cells(1, std::int64_t(mesh.cells));
        if (!polyhedra) added = cutIntoStars(all, volume.cells, volume.points);
    }
    for (const FoamField& field : fields) {
        const auto width = std::size_t(field.components);
        std::vector<float>& values = volume.values.emplace_back();
        if (foamHasField(foam, region, time, field))
            values = readFoamCells(foamFieldFile(folder, region, time, field.name), field, mesh.cells);
        else
            values.assign(mesh.cells * width, kMissing);
        values.reserve(values.size() + added.size() * width);
        for (const std::size_t cell : added)
            for (std::size_t c = 0; c < width; ++c) values.push_back(values[cell * width + c]);
    }
    return volume;
}

/// Puts a volume behind the others. The first one's points keep their numbers, unless they are merged.
void append(Volume volume, FoamPoints& points, PartMesh& mesh, std::vector<std::vector<float>>& values)
{
    const bool isFirst = points.all.empty();
    if (isFirst && !points.merges()) {
        points.all = std::move(volume.points);
    } else {
        std::vector<std::int64_t> ids;
        ids.reserve(volume.points.size());
        for (const glm::dvec3& point : volume.points) ids.push_back(points.add(point));
        for (PartCells& cells : volume.cells)
            for (std::int64_t& corner : cells.corners) corner = ids[std::size_t(corner)];
    }
    std::move(volume.cells.begin(), volume.cells.end(), std::back_inserter(mesh.cells));
    if (isFirst)
        values = std::move(volume.values);
    else
        for (std::size_t f = 0; f < values.size(); ++f)
            values[f].insert(values[f].end(), volume.values[f].begin(), volume.values[f].end());
}

}  // namespace

std::vector<std::size_t> cutIntoStars(const CellsOfFaces& all, std::vector<PartCells>& cells,
                                      std::vector<glm::dvec3>& points)
{
    StarMaker maker(all, points);
    std::vector<PartCells> cut;
    std::size_t cell = 0;
    for (PartCells& each : cells) {
        const std::size_t count = each.count;
        if (each.shape == CellShape::polyhedron)
            maker.take(each, cell, cut);
        else
            cut.push_back(std::move(each));
        cell += count;
    }
    std::move(maker.others.begin(), maker.others.end(), std::back_inserter(cut));
    cells = std::move(cut);
    return std::move(maker.ofCells);
}

PartMesh readFoamVolume(const FoamCase& foam, const std::vector<std::string>& regions, double time,
                        const std::vector<FoamField>& fields, const PieceRun& run, bool polyhedra)
{
    FoamPoints points(run.end - run.begin > 1);
    std::vector<std::vector<float>> values(fields.size());
    PartMesh mesh;
    for (int folder = run.begin; folder < run.end; ++folder)
        for (const std::string& region : regions)
            append(readOne(foam, foam.folders[std::size_t(folder)], region, time, fields, polyhedra), points, mesh,
                   values);
    mesh.points = std::make_shared<const std::vector<glm::dvec3>>(std::move(points.all));
    for (auto& each : values) mesh.values.push_back(std::make_shared<const std::vector<float>>(std::move(each)));
    mesh.floatPoints = true;
    return mesh;
}

}  // namespace aeolic
