#include "data/load/field/wall_sampler.h"

#include <algorithm>
#include <utility>

#include "base/append.h"
#include "data/cells/cell_sampler.h"
#include "data/cells/grid_sampler.h"
#include "data/load/field/brick_sampler.h"

namespace aeolic {
namespace {

/// How often cells are looked for flow off a wall before others are fetched that are farther away.
constexpr int kTriesAtOnce = 1;

/// At first cells are fetched whose middle is no farther from the surface than so many of their own diagonals; more
/// where the distances of their centres from a wall are asked for, too: WallFaces looks at all around a face.
constexpr double kDiagonalsAtOnce = 1.5, kDiagonalsForCenters = 3;

/// What all ranks together look up at once in bricks, and the least that one of them does.
constexpr std::size_t kPointsAtOnce = 1 << 18, kLeastAtOnce = 1 << 10;

void appendValues(WallValues& values, const WallValues& more)
{
    appendAll(values.vectors, more.vectors);
    appendAll(values.scalars, more.scalars);
    appendAll(values.within, more.within);
    appendAll(values.atRest, more.atRest);
    values.inside += more.inside;
}

}  // namespace

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

/// The field, or, where it is looked up in its own cells, those near a surface: CellVolume::near().
WallSampler::Volume WallSampler::around(SurfaceZone zone, const FieldStep& step, double diagonals) const
{
    Volume volume{&step, nullptr, nullptr};
    CellVolume::Shell shell;
    if (!step.vectors) shell = shellAround(*step.cells, std::move(zone), diagonals, inPieces_, agreement_);
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

double WallSampler::diagonalsAtOnce(const FieldStep& step) const
{
    const bool toCenters = step.cells && step.cells->meansOfCells && shear_;
    return toCenters && !offsetWorld_ ? kDiagonalsForCenters : kDiagonalsAtOnce;
}

WallSampler::Volume WallSampler::touching(const SurfaceMesh& mesh, const FieldStep& step) const
{
    return around(SurfaceZone(mesh, {}), step, diagonalsAtOnce(step));
}

/// Flow is looked for kTriesAtOnce times.
WallSampler::Volume WallSampler::aroundWall(const SurfaceMesh& mesh, Volume touching) const
{
    const FieldStep& step = *touching.step;
    if (!step.cells) return touching;
    std::vector<double> reach;
    bool lacks = false;
    agreement_.together([&] {
        WallLookup lookup;
        lookup.offsetWorld = offsetWorld_;
        lookup.shear = shear_;
        lookup.tries = kTriesAtOnce;
        reach = lookUpReach(mesh, *touching.sampler, lookup);
        lacks = touching.leftOut->mayLack(mesh, reach, diagonalsAtOnce(step));
    });
    if (inPieces_) lacks = agreement_.any(lacks);
    // Mostly all that can be found is there, because cells are as large as the way to the middle of their neighbour.
    if (!lacks) return touching;
    return around(SurfaceZone(mesh, reach), step, 1);
}

/// Calls take(look(points, sampler)) for the mesh's points: for all at once, or, where the field is in bricks, for so
/// many at a time.
template <class Look, class Take>
void WallSampler::lookAt(const SurfaceMesh& mesh, const Volume& volume, const Look& look, const Take& take) const
{
    const FieldStep& step = *volume.step;
    if (!step.vectors || !step.vectors->brick) return agreement_.together([&] { take(look(mesh, *volume.sampler)); });
    const double longest = agreement_.greatest(step.vectors->maxMagnitude),
                 most = agreement_.greatest(double(mesh.positions.size()));
    const auto different = std::size_t(inPieces_ ? agreement_.part().ranks : 1);
    const std::size_t atOnce = std::max(kPointsAtOnce / different, kLeastAtOnce);
    for (std::size_t first = 0; double(first) < most; first += atOnce) {
        BrickSampler sampler(step.vectors, step.scalar, longest);
        SurfaceMesh points;
        agreement_.together([&] {
            points = pointsOf(mesh, first, atOnce);
            look(points, sampler);  // For what it asks.
        });
        sampler.ask(agreement_, !inPieces_);
        agreement_.together([&] { take(look(points, sampler)); });
    }
}

WallValues WallSampler::values(const SurfaceMesh& mesh, const Volume& volume, WallLookup lookup) const
{
    lookup.offsetWorld = offsetWorld_;
    lookup.shear = shear_;
    WallLookup some = lookup;
    if (volume.step->cells) some.tries = kTriesAtOnce;
    WallValues all;
    const auto look = [&](const SurfaceMesh& points, const VolumeSampler& sampler) {
        return lookUpNearWall(points, sampler, some);
    };
    lookAt(mesh, volume, look, [&](const WallValues& values) { appendValues(all, values); });
    if (volume.step->cells) lookFarther(mesh, volume, lookup, all);
    return all;
}

/// Most points of a wall have flow in the cell beside them. Cells farther off are fetched for the others alone.
void WallSampler::lookFarther(const SurfaceMesh& mesh, const Volume& volume, const WallLookup& lookup,
                              WallValues& all) const
{
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < all.atRest.size(); ++i)
        if (all.atRest[i]) places.push_back(i);
    if (inPieces_ ? !agreement_.any(!places.empty()) : places.empty()) return;
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
    const Volume wider = around(SurfaceZone(pointsWorld, reach), *volume.step, 1);
    agreement_.together([&] {
        const WallValues found = lookUpNearWall(points, *wider.sampler, lookup);
        for (std::size_t k = 0; k < places.size(); ++k) {
            all.vectors[places[k]] = found.vectors[k];
            if (!all.scalars.empty()) all.scalars[places[k]] = found.scalars[k];
        }
    });
}

double WallSampler::side(const SurfaceMesh& mesh, const Volume& volume) const
{
    std::int64_t towards = 0;
    lookAt(mesh, volume, pointsTowardsVolume, [&](std::int64_t some) { towards += some; });
    if (inPieces_) towards = agreement_.sum(towards);
    return towards < 0 ? -1 : 1;
}

}  // namespace aeolic
