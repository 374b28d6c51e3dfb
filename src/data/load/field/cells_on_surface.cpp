#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "aeolic/error.h"
#include "data/cells/cell_sampler.h"
#include "data/cells/grid_sampler.h"
#include "data/cells/near_wall.h"
#include "data/cells/refine.h"
#include "data/load/blank_surface.h"
#include "data/load/field/brick_sampler.h"
#include "data/load/surface_part.h"

namespace aeolic {
namespace {

template <class Value>
void blend(std::vector<Value>& values, const std::vector<Value>& other, double weight)
{
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += float(weight) * (other[i] - values[i]);
}

/// How often cells are looked for flow off a wall before others are fetched that are farther away.
constexpr int kTriesAtOnce = 1;

/// At first cells are fetched whose middle is no farther from the surface than so many of their own diagonals; more
/// where the distances of their centres from a wall are asked for, too: WallFaces looks at all around a face.
constexpr double kDiagonalsAtOnce = 1.5, kDiagonalsForCenters = 3;

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

/// Shells beside the volume came with values of their own, where all else is NaN. They keep these. A shell at rest
/// takes what is beside it as a wall does, where there is flow.
void keepOwnValues(const SurfaceMesh& mesh, double maxVector, WallValues& values)
{
    const auto flows = [&](const glm::vec3& vector) { return double(glm::length(vector)) > kAtRest * maxVector; };
    const bool vectors = !mesh.pointVectors.empty(), scalars = !mesh.pointScalars.empty() && !values.scalars.empty();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (vectors && std::isfinite(glm::length(mesh.pointVectors[i]))) {
            values.within[i] = 1;
            if (!flows(mesh.pointVectors[i]) && flows(values.vectors[i])) continue;
            values.vectors[i] = mesh.pointVectors[i];
        }
        if (scalars && std::isfinite(mesh.pointScalars[i])) values.scalars[i] = mesh.pointScalars[i];
    }
}

void append(WallValues& values, const WallValues& more)
{
    values.vectors.insert(values.vectors.end(), more.vectors.begin(), more.vectors.end());
    values.scalars.insert(values.scalars.end(), more.scalars.begin(), more.scalars.end());
    values.within.insert(values.within.end(), more.within.begin(), more.within.end());
    values.atRest.insert(values.atRest.end(), more.atRest.begin(), more.atRest.end());
    values.inside += more.inside;
}

}  // namespace

/// The field, or, where it is looked up in its own cells, those near a surface: CellVolume::near().
SurfacePart::Volume SurfacePart::volumeAround(SurfaceZone zone, const FieldStep& step, double diagonals)
{
    Volume volume{&step, nullptr, nullptr};
    CellVolume::Shell shell;
    if (!step.vectors) shell = shellAround(*step.cells, std::move(zone), diagonals, scene.inPieces, agreement_);
    agreement_.together([&] {
        if (step.vectors) {
            volume.sampler = std::make_shared<const GridSampler>(step.vectors, step.scalar);
            return;
        }
        volume.leftOut = std::make_shared<const LeftOut>(std::move(shell.leftOut));
        volume.sampler = std::make_shared<const CellSampler>(
            std::make_shared<const VolumeCells>(std::move(shell.cells)), step.cells->boundsWorld);
    });
    return volume;
}

double SurfacePart::diagonalsAtOnce(const FieldStep& step) const
{
    const bool toCenters = step.cells && step.cells->meansOfCells && context_.reader.fieldVectors.shear;
    return toCenters && !offsetWorld_ ? kDiagonalsForCenters : kDiagonalsAtOnce;
}

/// The cells that touch the surface, and some cells beside it.
SurfacePart::Volume SurfacePart::volumeAt(const SurfaceMesh& mesh, const FieldStep& step)
{
    return volumeAround(SurfaceZone(mesh, {}), step, diagonalsAtOnce(step));
}

/// All that is looked up, where flow is looked for kTriesAtOnce times. `touching`: volumeAt() the same surface.
SurfacePart::Volume SurfacePart::volumeToLookUp(const SurfaceMesh& mesh, Volume touching)
{
    const FieldStep& step = *touching.step;
    if (!step.cells) return touching;
    std::vector<double> reach;
    bool lacks = false;
    agreement_.together([&] {
        WallLookup lookup;
        lookup.offsetWorld = offsetWorld_;
        lookup.shear = context_.reader.fieldVectors.shear;
        lookup.tries = kTriesAtOnce;
        reach = lookUpReach(mesh, *touching.sampler, lookup);
        lacks = touching.leftOut->mayLack(mesh, reach, diagonalsAtOnce(step));
    });
    if (scene.inPieces) lacks = agreement_.any(lacks);
    // Mostly all that can be found is there, because cells are as large as the way to the middle of their neighbour.
    if (!lacks) return touching;
    return volumeAround(SurfaceZone(mesh, reach), step, 1);
}

/// Calls take(look(points, sampler)) for the mesh's points: for all at once, or, where the field is in bricks, for so
/// many at a time.
template <class Look, class Take>
void SurfacePart::lookAt(const SurfaceMesh& mesh, const Volume& volume, const Look& look, const Take& take)
{
    const FieldStep& step = *volume.step;
    if (!step.vectors || !step.vectors->brick) return agreement_.together([&] { take(look(mesh, *volume.sampler)); });
    const double longest = agreement_.greatest(step.vectors->maxMagnitude),
                 most = agreement_.greatest(double(mesh.positions.size()));
    const auto different = std::size_t(scene.inPieces ? agreement_.part().ranks : 1);
    const std::size_t atOnce = std::max(kPointsAtOnce / different, kLeastAtOnce);
    for (std::size_t first = 0; double(first) < most; first += atOnce) {
        BrickSampler sampler(step.vectors, step.scalar, longest);
        SurfaceMesh points;
        agreement_.together([&] {
            points = pointsOf(mesh, first, atOnce);
            look(points, sampler);  // For what it asks.
        });
        sampler.ask(agreement_, !scene.inPieces);
        agreement_.together([&] { take(look(points, sampler)); });
    }
}

/// The values of lookUpNearWall() for all of the mesh.
WallValues SurfacePart::nearWall(const SurfaceMesh& mesh, const Volume& volume, const WallLookup& lookup)
{
    WallLookup some = lookup;
    if (volume.step->cells) some.tries = kTriesAtOnce;
    WallValues all;
    const auto look = [&](const SurfaceMesh& points, const VolumeSampler& sampler) {
        return lookUpNearWall(points, sampler, some);
    };
    lookAt(mesh, volume, look, [&](const WallValues& values) { append(all, values); });
    if (volume.step->cells) lookFarther(mesh, volume, lookup, all);
    return all;
}

/// Most points of a wall have flow in the cell beside them. Cells farther off are fetched for the others alone.
void SurfacePart::lookFarther(const SurfaceMesh& mesh, const Volume& volume, const WallLookup& lookup, WallValues& all)
{
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < all.atRest.size(); ++i)
        if (all.atRest[i]) places.push_back(i);
    if (scene.inPieces ? !agreement_.any(!places.empty()) : places.empty()) return;
    SurfaceMesh points;
    std::vector<glm::dvec3> pointsWorld;
    points.originWorld = mesh.originWorld;
    for (const std::size_t i : places) {
        points.positions.push_back(mesh.positions[i]);
        points.normals.push_back(mesh.normals[i]);
        pointsWorld.push_back(mesh.originWorld + glm::dvec3(mesh.positions[i]));
    }
    std::vector<double> reach;
    agreement_.together([&] { reach = lookUpReach(points, *volume.sampler, lookup); });
    const Volume wider = volumeAround(SurfaceZone(pointsWorld, reach), *volume.step, 1);
    agreement_.together([&] {
        const WallValues found = lookUpNearWall(points, *wider.sampler, lookup);
        for (std::size_t k = 0; k < places.size(); ++k) {
            all.vectors[places[k]] = found.vectors[k];
            if (!all.scalars.empty()) all.scalars[places[k]] = found.scalars[k];
        }
    });
}

/// Finds out on which side of the surface the field is. All pieces vote.
void SurfacePart::findFieldSide(const SurfaceMesh& mesh, const Volume& volume)
{
    std::int64_t towards = 0;
    lookAt(mesh, volume, pointsTowardsVolume, [&](std::int64_t some) { towards += some; });
    if (scene.inPieces) towards = agreement_.sum(towards);
    fieldSide_ = towards < 0 ? -1 : 1;
}

/// Whether most of what the field has on the surface is at rest or masked.
bool SurfacePart::isMostlyBlank()
{
    SurfaceMesh pieces;
    if (context_.dealsToBricks()) {
        pieces = scene.surface;
        scene.surface = agreement_.dealToBricks(std::move(scene.surface), *scene.field, nullptr);
    }
    const BlankAreas areas = blankAreas({});
    if (context_.dealsToBricks()) scene.surface = std::move(pieces);
    return 2 * (areas.still + areas.masked) > areas.within;
}

/// Whether a uniform grid is looked up on the surface beforehand, like other cells: where an offset is given, or where
/// most of what it has on the surface is at rest or masked, as inside of a body, and most points have flow beside them.
/// Anything else is sampled at every pixel.
bool SurfacePart::looksUpUniform(const FieldStep& step)
{
    if (!scene.field) return false;
    if (context_.description.field.offset || context_.reader.fieldVectors.shear) return true;
    if (context_.sources.field.anyMoment) return false;  // Built-in flows have no walls, slices are not walls.
    if (source().spec.isCut() && source().spec.kind != SurfaceSpec::Kind::boundary) return false;
    scene.maxVector = agreement_.greatest(scene.field->maxMagnitude);
    if (!isMostlyBlank()) return false;

    const Volume volume = volumeToLookUp(scene.surface, volumeAt(scene.surface, step));
    findFieldSide(scene.surface, volume);
    std::int64_t more = 0;  // Points with flow beside them than without.
    WallLookup lookup;
    lookup.side = fieldSide_;
    const WallValues values = nearWall(scene.surface, volume, lookup);
    for (std::size_t i = 0; i < values.within.size(); ++i)
        if (values.within[i]) more += glm::length(values.vectors[i]) > kAtRest * scene.maxVector ? 1 : -1;
    return (scene.inPieces ? agreement_.sum(more) : more) > 0;
}

/// Cuts the surface's triangles until they are as fine as the field's cells. All pieces stop in the same round.
void SurfacePart::refine(SurfaceMesh& mesh, const Volume& volume)
{
    const auto tooLong = [&](const glm::dvec3& a, const glm::dvec3& b) {
        return longerThanCell(*volume.sampler, a, b);
    };
    const auto sumOf = [&](std::uint64_t own) {
        return scene.inPieces ? std::uint64_t(agreement_.sum(std::int64_t(own))) : own;
    };
    const std::uint64_t most = mostRefinedTriangles(volume.step->countCells(), sumOf(mesh.triangles.size()));
    for (int round = 0; round < kMostRefinements; ++round) {
        EdgeCuts cuts;
        agreement_.together([&] { cuts = findCuts(mesh, tooLong); });
        const std::uint64_t all = sumOf(cuts.triangles);
        if (sumOf(cuts.ends.size()) == 0 || all > most) return;
        agreement_.together([&] { cutEdges(mesh, cuts); });
    }
}

/// Gives the surface what the field has, between its step and a later one where there is one. What is returned has no
/// values left, but which points are in the field.
WallValues SurfacePart::lookUp(SurfaceMesh& mesh, const Volume& volume, const FieldStep* later, double weight)
{
    const FieldStep& first = *volume.step;
    WallLookup lookup;
    lookup.offsetWorld = offsetWorld_;
    lookup.side = fieldSide_;
    lookup.scalar = scalarOfField_ && !first.scalarIsLength;
    lookup.shear = context_.reader.fieldVectors.shear;
    lookup.shearLength = scalarOfField_ && context_.reader.colorsAreShear();
    lookup.length = scalarOfField_ && first.scalarIsLength && !lookup.shearLength;
    WallValues values = nearWall(mesh, volume, lookup);
    if (later) {
        const WallValues more = nearWall(mesh, volumeToLookUp(mesh, volumeAt(mesh, *later)), lookup);
        blend(values.vectors, more.vectors, weight);
        blend(values.scalars, more.scalars, weight);
    }
    if (const auto component = componentOf(context_.reader.shearColors()); component && scalarOfField_)
        for (std::size_t i = 0; i < values.scalars.size(); ++i) values.scalars[i] = values.vectors[i][*component];
    if (isCut()) keepOwnValues(mesh, first.cells ? first.cells->maxVector : 0, values);
    if (ask().fieldVectors) {
        mesh.pointVectors = std::move(values.vectors);
        mesh.cellVectors = {};
    }
    if (!scalarOfField_) return values;
    mesh.pointScalars = std::move(values.scalars);
    mesh.cellScalars = {};
    return values;
}

/// Looks the volume up at another moment than the first. Returns how many triangles there are in all.
std::uint64_t SurfacePart::lookUpAt(SurfaceMesh& mesh, const Around& around)
{
    const auto first = context_.fieldStep(around.first), second = context_.fieldStep(around.second);
    const Volume touching = volumeAt(mesh, *first);
    refine(mesh, touching);
    withinField_ =
        lookUp(mesh, volumeToLookUp(mesh, touching), around.weight > 0 ? &*second : nullptr, around.weight).within;
    const auto mine = std::int64_t(mesh.triangles.size());
    return std::uint64_t(scene.inPieces ? agreement_.sum(mine) : mine);
}

/// A surface with vectors of its own carries colours of the field, too. A surface with the field's colours at every
/// pixel has the field's vectors.
void SurfacePart::lookUpWhereNeeded(const std::shared_ptr<const FieldStep>& step)
{
    if (!usesField() || (isCut() && !step->vectors && !step->cells)) return;
    if (step->cells ? !isCut() || source().spec.kind == SurfaceSpec::Kind::boundary : looksUpUniform(*step))
        return lookUpFirst(step);
    if (!ask().ownVectors || !step->vectors) return;
    offsetWorld_ = 0;  // It has no walls, or they would have been found.
    lookUpFirst(step);
}

void SurfacePart::lookUpFirst(const std::shared_ptr<const FieldStep>& step)
{
    const bool otherFields = context_.sources.field.moves() || context_.reader.memory.hasField();
    const bool otherSurfaces = moves() || context_.reader.memory.surface;
    if (otherFields && !moves()) plainSurface_ = scene.surface;
    if (otherSurfaces && !context_.sources.field.moves()) context_.keepStep(step);
    inCells_ = true;
    scene.field = scene.scalarField = nullptr;
    scene.colorByFieldMagnitude = false;
    const std::size_t ownPoints = scene.surface.positions.size();
    const Volume touching = volumeAt(scene.surface, *step);
    refine(scene.surface, touching);
    const Volume volume = volumeToLookUp(scene.surface, touching);
    findFieldSide(pointsOf(scene.surface, 0, ownPoints), volume);
    WallValues values = lookUp(scene.surface, volume, nullptr, 0);
    withinField_ = std::move(values.within);
    const std::int64_t inside = scene.inPieces ? agreement_.sum(values.inside) : values.inside;
    fieldBox_ = volume.sampler->bounds();
    meetsCells_ = inside > 0;
}

}  // namespace aeolic
