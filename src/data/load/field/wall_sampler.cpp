#include "data/load/field/wall_sampler.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "base/append.h"
#include "base/byte_message.h"
#include "data/cells/cell_sampler.h"
#include "data/cells/grid_sampler.h"
#include "data/surface_range.h"

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

bool isBefore(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// The places of all ranks, one after the other. `first` becomes where this rank's begin.
std::vector<glm::dvec3> placesOfAll(Agreement& agreement, const std::vector<glm::dvec3>& mine, std::size_t& first)
{
    const std::vector<Bytes> all = agreement.gatherAll(byteMessage(mine));
    std::vector<glm::dvec3> places, some;
    for (std::size_t rank = 0; rank < all.size(); ++rank) {
        if (rank == std::size_t(agreement.part().rank)) first = places.size();
        ByteReader(all[rank]).read(some);
        appendAll(places, some);
    }
    return places;
}

/// Looks values up in a uniform grid of which every rank holds a brick, to the bit as GridSampler does in the whole.
///
/// Every place is looked up twice. At first no value is known (NaN), and the places that were asked for are kept. Then
/// ask() brings their values from the ranks that own them, and the second time they are known. The second time may ask
/// for fewer places, but for no others. That suits a search that goes on from place to place.
class BrickSampler final : public GridSampler {
public:
    /// `scalars`: null where there is none. `longest`: of the vectors of all bricks.
    BrickSampler(std::shared_ptr<const GridField> vectors, std::shared_ptr<const GridField> scalars, double longest)
        : GridSampler(std::move(vectors), std::move(scalars)), longest_(longest)
    {
    }

    glm::dvec3 vectorAt(const CellPlace& place) const override
    {
        const Values values = valuesAt(place);
        return {values[0], values[1], values[2]};
    }

    double scalarAt(const CellPlace& place) const override { return valuesAt(place)[3]; }

    double maxVector() const override { return longest_; }

    /// Collective. `samePlaces`: every rank asked for the same ones. Cost: 32 bytes for each place that any rank asked
    /// for, on every rank; unless they are the same, 24 more.
    void ask(Agreement& agreement, bool samePlaces)
    {
        std::ranges::sort(places_, isBefore);
        places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
        std::size_t first = 0;
        const std::vector<glm::dvec3> places = samePlaces ? places_ : placesOfAll(agreement, places_, first);
        std::vector<double> values(4 * places.size());
        for (std::size_t i = 0; i < places.size(); ++i)
            std::ranges::copy(ownValuesAt(places[i]), values.begin() + std::ptrdiff_t(4 * i));
        agreement.sum(values);  // Of each place one rank alone has other terms than zero, so this rounds nothing.
        known_.resize(places_.size());
        for (std::size_t i = 0; i < places_.size(); ++i)
            std::copy_n(values.begin() + std::ptrdiff_t(4 * (first + i)), 4, known_[i].begin());
        answers_ = true;
    }

private:
    using Values = std::array<double, 4>;  // The vector and the scalar.
    Values valuesAt(const CellPlace& place) const
    {
        const glm::dvec3 at = pointOf(place);
        if (!answers_) {
            const std::lock_guard lock(asking_);
            places_.push_back(at);
            constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
            return {unknown, unknown, unknown, unknown};
        }
        const auto found = std::lower_bound(places_.begin(), places_.end(), at, isBefore);
        if (found == places_.end() || *found != at) throw std::logic_error("a place of a brick was not asked for");
        return known_[std::size_t(found - places_.begin())];
    }

    /// Zeros where another rank knows it.
    Values ownValuesAt(const glm::dvec3& pointWorld) const
    {
        const FieldVector vector = aeolic::vectorAt(*vectors_, pointWorld);
        if (!vector.inside || vector.elsewhere) return {};
        const double scalar = scalars_ ? aeolic::vectorAt(*scalars_, pointWorld).vector.x : 0.0;
        return {vector.vector.x, vector.vector.y, vector.vector.z, scalar};
    }

    double longest_;
    mutable std::mutex asking_;
    mutable std::vector<glm::dvec3> places_;  // Sorted once they are known.
    std::vector<Values> known_;               // [places]
    bool answers_ = false;
};

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
