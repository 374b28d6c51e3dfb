#include "reader/openfoam/foam_volume.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "reader/openfoam/foam_mesh.h"
#include "reader/openfoam/foam_points.h"
#include "reader/openfoam/star_cells.h"

namespace aeolic {
namespace {

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
