#include "reader/vtk/summarize.h"

#include <fmt/format.h>
#include <vtkType.h>

#include <algorithm>
#include <map>
#include <utility>

#include "reader/openfoam/foam_surface.h"
#include "reader/vtk/part_data_set.h"

namespace aeolic {
namespace {

/// The axis along which most of the polygons' normals lie, by area.
int axisAcross(const PartMesh& mesh)
{
    const std::vector<glm::dvec3>& points = *mesh.points;
    const PartCells& polygons = mesh.cells.front();
    glm::dvec3 area(0);
    auto corner = polygons.corners.begin();
    for (const std::int64_t size : polygons.sizes) {
        const auto point = [&](std::int64_t k) { return points[std::size_t(corner[k])]; };
        glm::dvec3 normal(0);
        for (std::int64_t k = 2; k < size; ++k) normal += glm::cross(point(k - 1) - point(0), point(k) - point(0));
        area += glm::abs(normal);
        corner += size;
    }
    return area.z >= area.x && area.z >= area.y ? 2 : area.y >= area.x ? 1 : 0;
}

/// The fields by the first time that has them. Those of the first time are there, even if it has none.
std::map<double, std::vector<FoamField>> fieldsByTime(const FoamCase& foam)
{
    std::map<double, std::vector<FoamField>> fieldsAt{{foam.firstTime(), {}}};
    for (const FoamField& field : foamFields(foam, foam.times)) fieldsAt[field.times.front()].push_back(field);
    return fieldsAt;
}

}  // namespace

FileSummary summaryOfFoam(const std::string& path, const ProgressReport& progress)
{
    const FoamCase foam = findFoamCase(path);
    const double time = foam.firstTime();
    const std::vector<FoamPart> patches = foamPatches(foam, time);
    const PieceRun all{0, int(foam.folders.size())};
    FileSummary summary;
    summary.isSurface = summary.isOfFaces = summary.namesFiles = true;
    summary.kind = foam.decomposed() ? fmt::format("an OpenFOAM case in {} processors' folders", foam.folders.size())
                                     : "an OpenFOAM case";
    summary.timeSteps = foam.times;
    for (const FoamPart& patch : patches) {
        PartSummary part{patch.name(), patch.type, patch.groups, std::int64_t(patch.faces)};
        if (part.isSide() && patch.faces > 0)
            part.sideAcross = axisAcross(readFoamPatches(foam, {patch}, time, {}, all));
        summary.parts.push_back(std::move(part));
    }
    const bool walls = std::ranges::any_of(patches, [](const FoamPart& p) { return p.type == "wall"; });
    for (const auto& [at, fields] : fieldsByTime(foam)) {
        progress("reading", 0.5);
        std::vector<PartArray> arrays;
        std::vector<ArrayInfo> infos;
        for (const FoamField& field : fields) {
            arrays.push_back({field.name, false, field.components});
            infos.push_back({field.name, false, field.components, VTK_FLOAT});
        }
        PartMesh mesh = readFoamPatches(foam, patches, at, fields, all);
        mesh.places.clear();
        const auto set = dataSetOf(std::move(mesh), 2, arrays, path);
        FileSummary some;
        addDataSet(*set, some);
        for (std::size_t i = 0; i < fields.size(); ++i) {
            some.arrays[i].association = "faces";
            if (fields[i].times.size() < foam.times.size()) some.arrays[i].times = fields[i].times;
            summary.arrays.push_back(some.arrays[i]);
        }
        if (at != time) continue;
        summary.points = some.points;
        summary.cells = some.cells;
        summary.boundsWorld = some.boundsWorld;
        const std::string usual = usualFoamVectors(fields, walls);
        for (ArrayInfo& info : infos) info.activeVectors = info.name == usual;
        chooseDefaultVectors(infos, summary);
    }
    return summary;
}

}  // namespace aeolic
