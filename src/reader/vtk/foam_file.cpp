#include "reader/vtk/foam_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "reader/openfoam/foam_surface.h"
#include "reader/vtk/foam_patches.h"
#include "reader/vtk/foam_volume.h"
#include "reader/vtk/summarize.h"

namespace aeolic {
namespace {

ArraySummary summarize(const FoamField& field, const std::vector<float>& values)
{
    ArraySummary summary{field.name, "faces", "float", field.components, std::nullopt, 0, 0, false, {}};
    const auto width = std::size_t(field.components);
    for (std::size_t i = 0; i + width <= values.size(); i += width) {
        double squared = 0;
        for (std::size_t c = 0; c < width; ++c) squared += double(values[i + c]) * double(values[i + c]);
        const double value = width == 1 ? double(values[i]) : std::sqrt(squared);
        if (!std::isfinite(value)) {
            ++summary.nonFinite;
            continue;
        }
        if (!summary.range) summary.range = {value, value};
        summary.range = {std::min((*summary.range)[0], value), std::max((*summary.range)[1], value)};
    }
    return summary;
}

/// The axis along which most of a surface's normals lie, by area.
int axisAcross(const FoamSurface& surface)
{
    glm::dvec3 area(0);
    for (std::size_t face = 0; face + 1 < surface.begins.size(); ++face) {
        const auto corner = [&](std::size_t k) { return surface.points[surface.corners[k]]; };
        const std::size_t first = surface.begins[face];
        glm::dvec3 normal(0);
        for (std::size_t k = first + 2; k < surface.begins[face + 1]; ++k)
            normal += glm::cross(corner(k - 1) - corner(first), corner(k) - corner(first));
        area += glm::abs(normal);
    }
    return area.z >= area.x && area.z >= area.y ? 2 : area.y >= area.x ? 1 : 0;
}

}  // namespace

std::unique_ptr<OwnReader> openFoam(const std::string& path, FileUse use, std::optional<double> time)
{
    if (use == FileUse::surface) return std::make_unique<FoamPatches>(path, time);
    return std::make_unique<FoamVolume>(path, time);
}

std::vector<double> foamTimes(const std::string& path)
{
    return findFoamCase(path).times;
}

std::vector<std::uint64_t> foamPieces(const std::string& path)
{
    return std::vector<std::uint64_t>(findFoamCase(path).folders.size(), 1);
}

std::uint64_t firstFoamStep(const std::string& path, const std::vector<std::string>& arrays)
{
    return firstFoamStepWith(findFoamCase(path), arrays);
}

bool isOneFoamRegion(const std::string& path, const std::vector<std::string>& parts)
{
    const FoamCase foam = findFoamCase(path);
    const auto chosen = chooseFoamParts(foam, foamParts(foam, firstFoamTime(foam)), parts);
    return std::all_of(chosen.begin(), chosen.end(),
                       [&](const FoamPart& part) { return part.region == chosen.front().region; });
}

FileSummary summaryOfFoam(const std::string& path, const ProgressReport& progress)
{
    const FoamCase foam = findFoamCase(path);
    const double time = firstFoamTime(foam);
    const std::vector<FoamPart> parts = foamParts(foam, time);
    FileSummary summary;
    summary.isSurface = summary.isCase = true;
    summary.kind = foam.decomposed() ? fmt::format("an OpenFOAM case in {} processors' folders", foam.folders.size())
                                     : "an OpenFOAM case";
    summary.timeSteps = foam.times;
    const PieceRun all{0, int(foam.folders.size())};
    for (const FoamPart& part : parts) {
        PartSummary side{part.name(), part.type, part.groups, std::int64_t(part.faces)};
        if (side.isSide() && part.faces > 0) side.sideAcross = axisAcross(readFoamSurface(foam, {part}, time, {}, all));
        summary.parts.push_back(std::move(side));
    }
    std::map<double, std::vector<FoamField>> fieldsAt{{time, {}}};  // By the first time that has them.
    for (const FoamField& field : foamFieldsOfAllTimes(foam, foam.regions.front()))
        fieldsAt[field.times.front()].push_back(field);
    const std::vector<FoamField>& fields = fieldsAt[time];
    const FoamSurface surface = readFoamSurface(foam, parts, time, fields, all);
    summary.points = std::int64_t(surface.points.size());
    summary.cells = std::int64_t(surface.begins.size()) - 1;
    for (const glm::dvec3& p : surface.points)
        if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) summary.boundsWorld.add(p);
    for (const auto& [at, some] : fieldsAt) {
        progress("reading", 0.5);
        const FoamSurface other = at == time ? FoamSurface() : readFoamSurface(foam, parts, at, some, all);
        for (const FoamField& field : some) {
            summary.arrays.push_back(summarize(field, (at == time ? surface : other).values.at(field.name)));
            if (field.times.size() < foam.times.size()) summary.arrays.back().times = field.times;
        }
    }
    const bool walls = std::any_of(parts.begin(), parts.end(), [](const FoamPart& p) { return p.type == "wall"; });
    chooseDefaultVectors(foamArrays(fields, walls ? "wallShearStress" : "U"), summary);
    return summary;
}

}  // namespace aeolic
