#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "aeolic/error.h"
#include "data/cells/grid_sampler.h"
#include "data/cells/near_wall.h"
#include "data/cells/refine.h"
#include "data/load/blank_surface.h"
#include "data/load/brick_sampler.h"
#include "data/load/loaded_scene_state.h"

namespace aeolic {
namespace {

template <class Value>
void blend(std::vector<Value>& values, const std::vector<Value>& other, double weight)
{
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += float(weight) * (other[i] - values[i]);
}

/// What all ranks together look up at once in bricks, and the least that one of them does.
constexpr std::size_t kPointsAtOnce = 1 << 18, kLeastAtOnce = 1 << 10;

/// So many points of a mesh, with their normals alone.
SurfaceMesh pointsOf(const SurfaceMesh& mesh, std::size_t first, std::size_t count)
{
    SurfaceMesh part;
    part.originWorld = mesh.originWorld;
    const std::size_t begin = std::min(first, mesh.positions.size()),
                      end = std::min(first + count, mesh.positions.size());
    part.positions.assign(mesh.positions.begin() + std::ptrdiff_t(begin), mesh.positions.begin() + std::ptrdiff_t(end));
    part.normals.assign(mesh.normals.begin() + std::ptrdiff_t(begin), mesh.normals.begin() + std::ptrdiff_t(end));
    return part;
}

void append(WallValues& values, const WallValues& more)
{
    values.vectors.insert(values.vectors.end(), more.vectors.begin(), more.vectors.end());
    values.scalars.insert(values.scalars.end(), more.scalars.begin(), more.scalars.end());
    values.within.insert(values.within.end(), more.within.begin(), more.within.end());
    values.inside += more.inside;
}

}  // namespace

std::shared_ptr<const VolumeSampler> LoadedScene::State::samplerOf(const FieldStep& step) const
{
    if (step.cells || !step.vectors) return step.cells;
    return std::make_shared<const GridSampler>(step.vectors, step.scalar);
}

/// Calls take(look(points, sampler)) for the mesh's points: for all at once, or, where the field is in bricks, for so
/// many at a time.
template <class Look, class Take>
void LoadedScene::State::lookAt(const SurfaceMesh& mesh, const FieldStep& step, const Look& look, const Take& take)
{
    if (!step.vectors || !step.vectors->brick) {
        const auto sampler = samplerOf(step);
        return agreement.together([&] { take(look(mesh, *sampler)); });
    }
    const double longest = agreement.greatest(step.vectors->maxMagnitude),
                 most = agreement.greatest(double(mesh.positions.size()));
    const auto different = std::size_t(scene.inPieces ? agreement.part().ranks : 1);
    const std::size_t atOnce = std::max(kPointsAtOnce / different, kLeastAtOnce);
    for (std::size_t first = 0; double(first) < most; first += atOnce) {
        BrickSampler sampler(step.vectors, step.scalar, longest);
        SurfaceMesh points;
        agreement.together([&] {
            points = pointsOf(mesh, first, atOnce);
            look(points, sampler);  // For what it asks.
        });
        sampler.ask(agreement, !scene.inPieces);
        agreement.together([&] { take(look(points, sampler)); });
    }
}

/// The values of lookUpNearWall() for all of the mesh.
WallValues LoadedScene::State::nearWall(const SurfaceMesh& mesh, const FieldStep& step, const WallLookup& lookup)
{
    WallValues all;
    const auto look = [&](const SurfaceMesh& points, const VolumeSampler& sampler) {
        return lookUpNearWall(points, sampler, lookup);
    };
    lookAt(mesh, step, look, [&](const WallValues& some) { append(all, some); });
    return all;
}

/// Finds out on which side of the surface the field is. All pieces vote.
void LoadedScene::State::findFieldSide(const FieldStep& step)
{
    std::int64_t towards = 0;
    lookAt(scene.surface, step, pointsTowardsVolume, [&](std::int64_t some) { towards += some; });
    if (scene.inPieces) towards = agreement.sum(towards);
    fieldSide = towards < 0 ? -1 : 1;
}

/// Whether most of what the field has on the surface is at rest or masked.
bool LoadedScene::State::isMostlyBlank()
{
    SurfaceMesh pieces;
    if (dealsToBricks()) {
        pieces = scene.surface;
        scene.surface = agreement.dealToBricks(std::move(scene.surface), *scene.field, nullptr);
    }
    const BlankAreas areas = blankAreas({});
    if (dealsToBricks()) scene.surface = std::move(pieces);
    return 2 * (areas.still + areas.masked) > areas.within;
}

/// Whether a uniform grid is looked up on the surface beforehand, like other cells: where an offset is given, or where
/// most of what it has on the surface is at rest or masked, as inside of a body, and most points have flow beside them.
/// Anything else is sampled at every pixel.
bool LoadedScene::State::looksUpUniform(const FieldStep& step)
{
    if (!scene.field) return false;
    if (description.field.offset || reader.fieldVectors.shear) return true;
    if (sources.field.anyMoment) return false;  // Built-in flows have no walls, and slices are none.
    if (sources.surfaceSpec.isCut() && sources.surfaceSpec.kind != SurfaceSpec::Kind::boundary) return false;
    scene.maxVector = agreement.greatest(scene.field->maxMagnitude);
    if (!isMostlyBlank()) return false;

    findFieldSide(step);
    std::int64_t more = 0;  // Points with flow beside them than without.
    WallLookup lookup;
    lookup.side = fieldSide;
    const WallValues values = nearWall(scene.surface, step, lookup);
    for (std::size_t i = 0; i < values.within.size(); ++i)
        if (values.within[i]) more += glm::length(values.vectors[i]) > kAtRest * scene.maxVector ? 1 : -1;
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
WallValues LoadedScene::State::lookUp(SurfaceMesh& mesh, const FieldStep& first, const FieldStep& second, double weight)
{
    WallLookup lookup;
    lookup.offsetWorld = description.field.offset;
    lookup.side = fieldSide;
    lookup.scalar = first.hasScalar && !first.scalarIsLength;
    lookup.shear = reader.fieldVectors.shear;
    lookup.shearLength = first.hasScalar && reader.colorsAreShear();
    lookup.length = first.hasScalar && first.scalarIsLength && !lookup.shearLength;
    WallValues values = nearWall(mesh, first, lookup);
    if (weight > 0) {
        const WallValues later = nearWall(mesh, second, lookup);
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
    lookUp(mesh, *first, *second, around.weight);
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
    findFieldSide(*step);
    refine(scene.surface, *sampler);
    WallValues values = lookUp(scene.surface, *step, *step, 0);
    withinField = std::move(values.within);
    const std::int64_t inside = scene.inPieces ? agreement.sum(values.inside) : values.inside;
    fieldBox = sampler->bounds();
    meetsCells = inside > 0;
}

}  // namespace aeolic
