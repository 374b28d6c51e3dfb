#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "aeolic/error.h"
#include "data/cells/grid_sampler.h"
#include "data/cells/near_wall.h"
#include "data/cells/refine.h"
#include "data/load/blank_surface.h"
#include "data/load/loaded_scene_state.h"

namespace aeolic {
namespace {

template <class Value>
void blend(std::vector<Value>& values, const std::vector<Value>& other, double weight)
{
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += float(weight) * (other[i] - values[i]);
}

}  // namespace

std::shared_ptr<const VolumeSampler> LoadedScene::State::samplerOf(const FieldStep& step) const
{
    if (step.cells || !step.vectors) return step.cells;
    return std::make_shared<const GridSampler>(step.vectors, step.scalar);
}

/// Finds out on which side of the surface the field is. All pieces vote.
void LoadedScene::State::findFieldSide(const VolumeSampler& sampler)
{
    std::int64_t towards = 0;
    agreement.together([&] { towards = pointsTowardsVolume(scene.surface, sampler); });
    if (scene.inPieces) towards = agreement.sum(towards);
    fieldSide = towards < 0 ? -1 : 1;
}

/// Whether a uniform grid is looked up on the surface beforehand, like other cells: where an offset is given, or where
/// most of what it has on the surface is at rest or masked, as inside of a body, and most points have flow beside them.
/// Anything else is sampled at every pixel.
bool LoadedScene::State::looksUpUniform(const FieldStep& step)
{
    if (!scene.field || scene.bricked()) return false;
    if (description.field.offset || reader.fieldVectors.shear) return true;
    if (sources.field.anyMoment) return false;  // Built-in flows have no walls, and slices are none.
    if (sources.surfaceSpec.isCut() && sources.surfaceSpec.kind != SurfaceSpec::Kind::boundary) return false;
    scene.maxVector = scene.field->maxMagnitude;
    BlankAreas areas;
    agreement.together([&] { areas = blankAreasOf(scene, {}, true); });
    if (scene.inPieces)
        for (std::int64_t* area : {&areas.all, &areas.outside, &areas.masked, &areas.still})
            *area = agreement.sum(*area);
    if (2 * (areas.still + areas.masked) <= areas.all - areas.outside) return false;

    const auto sampler = samplerOf(step);
    findFieldSide(*sampler);
    std::int64_t more = 0;  // Points with flow beside them than without.
    agreement.together([&] {
        WallLookup lookup;
        lookup.side = fieldSide;
        const WallValues values = lookUpNearWall(scene.surface, *sampler, lookup);
        for (std::size_t i = 0; i < values.within.size(); ++i)
            if (values.within[i]) more += glm::length(values.vectors[i]) > kAtRest * scene.maxVector ? 1 : -1;
    });
    return (scene.inPieces ? agreement.sum(more) : more) > 0;
}

/// Cuts the surface's triangles until they are as fine as the field's cells. All pieces stop in the same round.
void LoadedScene::State::refine(SurfaceMesh& mesh, const VolumeSampler& sampler)
{
    const auto tooLong = [&](const glm::dvec3& a, const glm::dvec3& b) { return longerThanCell(sampler, a, b); };
    for (int round = 0; round < kMostRefinements; ++round) {
        EdgeCuts cuts;
        agreement.together([&] { cuts = findCuts(mesh, tooLong); });
        std::uint64_t all = cuts.triangles;
        if (scene.inPieces) all = std::uint64_t(agreement.sum(std::int64_t(all)));
        const bool none = scene.inPieces ? agreement.sum(std::int64_t(cuts.ends.size())) == 0 : cuts.ends.empty();
        if (none || all > kMostRefinedTriangles) return;
        agreement.together([&] { cutEdges(mesh, cuts); });
    }
}

/// Gives the surface what the field has between two steps. What is returned has no values left, but which points are in
/// the field.
WallValues LoadedScene::State::lookUp(SurfaceMesh& mesh, const FieldStep& first, const FieldStep& second,
                                      double weight) const
{
    WallLookup lookup;
    lookup.offsetWorld = description.field.offset;
    lookup.side = fieldSide;
    lookup.scalar = first.hasScalar && !first.scalarIsLength;
    lookup.shear = reader.fieldVectors.shear;
    lookup.shearLength = first.hasScalar && reader.colorsAreShear();
    lookup.length = first.hasScalar && first.scalarIsLength && !lookup.shearLength;
    WallValues values = lookUpNearWall(mesh, *samplerOf(first), lookup);
    if (weight > 0) {
        const WallValues later = lookUpNearWall(mesh, *samplerOf(second), lookup);
        blend(values.vectors, later.vectors, weight);
        blend(values.scalars, later.scalars, weight);
    }
    mesh.pointVectors = std::move(values.vectors);
    mesh.cellVectors = {};
    if (!first.hasScalar) return values;
    mesh.pointScalars = std::move(values.scalars);
    mesh.cellScalars = {};
    return values;
}

/// The same for another moment than the first. Returns how many triangles there are in all.
std::uint64_t LoadedScene::State::lookUpAt(SurfaceMesh& mesh, const Around& around)
{
    const auto step = [&](double key) { return fields.holds(key) ? fields.at(key) : onlyStep; };
    const auto first = step(around.first), second = step(around.second);
    refine(mesh, *samplerOf(*first));
    agreement.together([&] { lookUp(mesh, *first, *second, around.weight); });
    const auto mine = std::int64_t(mesh.triangles.size());
    return std::uint64_t(scene.inPieces ? agreement.sum(mine) : mine);
}

void LoadedScene::State::lookUpFirst(const std::shared_ptr<const FieldStep>& step)
{
    const bool otherFields = sources.field.moves() || reader.memory.grid;
    const bool otherSurfaces = sources.surfaceMoves() || reader.memory.surface;
    if (otherFields && !sources.surfaceMoves()) plainSurface = scene.surface;
    if (otherSurfaces && !sources.field.moves()) onlyStep = step;
    inCells = true;
    scene.field = scene.scalarField = nullptr;
    scene.colorByFieldMagnitude = false;
    const auto sampler = samplerOf(*step);
    findFieldSide(*sampler);
    refine(scene.surface, *sampler);
    std::int64_t inside = 0;
    agreement.together([&] {
        WallValues values = lookUp(scene.surface, *step, *step, 0);
        inside = values.inside;
        withinField = std::move(values.within);
    });
    if (scene.inPieces) inside = agreement.sum(inside);
    fieldBox = sampler->bounds();
    meetsCells = inside > 0;
}

}  // namespace aeolic
