#include "data/load/field/surface_lookup.h"

#include <utility>

#include "data/cells/refine.h"
#include "data/load/blank_surface.h"

namespace aeolic {
namespace {

template <class Value>
void blend(std::vector<Value>& values, const std::vector<Value>& other, double weight)
{
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += float(weight) * (other[i] - values[i]);
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

}  // namespace

/// Whether most of what the field has on the surface is at rest or masked.
bool SurfaceLookup::isMostlyBlank()
{
    SurfaceMesh pieces;
    if (context_.dealsToBricks()) {
        pieces = scene_.surface;
        scene_.surface = agreement_.dealToBricks(std::move(scene_.surface), *scene_.field, nullptr);
    }
    const BlankAreas areas = blankAreasOf(scene_, {}, agreement_);
    if (context_.dealsToBricks()) scene_.surface = std::move(pieces);
    return 2 * (areas.still + areas.masked) > areas.within;
}

/// Whether a uniform grid is looked up on the surface beforehand, like other cells: where an offset is given, or where
/// most of what it has on the surface is at rest or masked, as inside of a body, and most points have flow beside them.
/// Anything else is sampled at every pixel.
bool SurfaceLookup::isGridLookedUp(const FieldStep& step)
{
    if (!scene_.field) return false;
    if (context_.description.field.offset || isShear()) return true;
    if (context_.sources.field.anyMoment) return false;  // Built-in flows have no walls, slices are not walls.
    if (source().spec.isCut() && source().spec.kind != SurfaceSpec::Kind::boundary) return false;
    scene_.maxVector = agreement_.greatest(scene_.field->maxMagnitude);
    if (!isMostlyBlank()) return false;

    const WallSampler::Volume volume = wall().aroundWall(scene_.surface, step);
    std::int64_t more = 0;  // Points with flow beside them than without.
    WallLookup lookup;
    lookup.side = side_ = wall().side(scene_.surface, volume);
    const WallValues values = wall().values(scene_.surface, volume, lookup);
    for (std::size_t i = 0; i < values.within.size(); ++i)
        if (values.within[i]) more += glm::length(values.vectors[i]) > kAtRest * scene_.maxVector ? 1 : -1;
    return (scene_.inPieces ? agreement_.sum(more) : more) > 0;
}

/// A surface with vectors of its own carries colours of the field, too. A surface with the field's colours at every
/// pixel has the field's vectors.
bool SurfaceLookup::isWanted(const FieldStep& step)
{
    const bool isCut = source().spec.isCut();
    if (!(ask().fieldVectors || colors_) || (isCut && !step.vectors && !step.cells)) return false;
    if (step.cells ? !isCut || source().spec.kind == SurfaceSpec::Kind::boundary : isGridLookedUp(step)) return true;
    if (!ask().ownVectors || !step.vectors) return false;
    offsetWorld_ = 0;  // It has no walls, or they would have been found.
    return true;
}

/// Cuts the surface's triangles until they are as fine as the field's cells. All pieces stop in the same round.
void SurfaceLookup::refine(SurfaceMesh& mesh, const WallSampler::Volume& volume)
{
    const auto tooLong = [&](const glm::dvec3& a, const glm::dvec3& b) {
        return longerThanCell(*volume.sampler, a, b);
    };
    const auto sumOf = [&](std::uint64_t own) {
        return scene_.inPieces ? std::uint64_t(agreement_.sum(std::int64_t(own))) : own;
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
WallValues SurfaceLookup::take(SurfaceMesh& mesh, const WallSampler::Volume& volume, const FieldStep* later,
                               double weight)
{
    const FieldStep& first = *volume.step;
    WallLookup lookup;
    lookup.side = side_;
    lookup.scalar = colors_ && first.ofVectors == ArrayPart::whole;
    lookup.shearLength = colors_ && context_.reader.colorsAreShear() && !needsNormal(first.ofVectors);
    lookup.length = colors_ && first.ofVectors == ArrayPart::length && !lookup.shearLength;
    WallValues values = wall().values(mesh, volume, lookup);
    if (later) {
        const WallValues more = wall().values(mesh, wall().aroundWall(mesh, *later), lookup);
        blend(values.vectors, more.vectors, weight);
        blend(values.scalars, more.scalars, weight);
    }
    if (const auto component = componentOf(context_.reader.shearColors()); component && colors_)
        for (std::size_t i = 0; i < values.scalars.size(); ++i) values.scalars[i] = values.vectors[i][*component];
    if (source().spec.isCut()) keepOwnValues(mesh, first.cells ? first.cells->maxVector : 0, values);
    if (ask().fieldVectors) {
        mesh.pointVectors = std::move(values.vectors);
        mesh.cellVectors = {};
    }
    if (!colors_) return values;
    mesh.pointScalars = std::move(values.scalars);
    mesh.cellScalars = {};
    return values;
}

std::uint64_t SurfaceLookup::lookUpAt(SurfaceMesh& mesh, const Around& around)
{
    const auto first = context_.fieldStep(around.first), second = context_.fieldStep(around.second);
    const WallSampler::Volume touching = wall().touching(mesh, *first);
    refine(mesh, touching);
    const FieldStep* later = around.weight > 0 ? &*second : nullptr;
    within_ = take(mesh, wall().aroundWall(mesh, touching), later, around.weight).within;
    const auto mine = std::int64_t(mesh.triangles.size());
    return std::uint64_t(scene_.inPieces ? agreement_.sum(mine) : mine);
}

void SurfaceLookup::lookUpFirst(const std::shared_ptr<const FieldStep>& step, bool colors)
{
    colors_ = colors;
    if (!isWanted(*step)) return;
    const bool surfaceMoves = context_.sources.moves(source());
    const bool otherFields = context_.sources.field.moves() || context_.reader.memory.hasField();
    const bool otherSurfaces = surfaceMoves || context_.reader.memory.surface;
    if (otherFields && !surfaceMoves) plain_ = scene_.surface;
    if (otherSurfaces && !context_.sources.field.moves()) context_.keepStep(step);
    carried_ = true;
    scene_.field = scene_.scalarField = nullptr;
    if (scene_.ofVectors == ArrayPart::length) scene_.ofVectors = ArrayPart::whole;
    const std::size_t ownPoints = scene_.surface.positions.size();
    const WallSampler::Volume touching = wall().touching(scene_.surface, *step);
    refine(scene_.surface, touching);
    const WallSampler::Volume volume = wall().aroundWall(scene_.surface, touching);
    side_ = wall().side(pointsOf(scene_.surface, 0, ownPoints), volume);
    WallValues values = take(scene_.surface, volume, nullptr, 0);
    within_ = std::move(values.within);
    meets_ = (scene_.inPieces ? agreement_.sum(values.inside) : values.inside) > 0;
    box_ = volume.sampler->bounds();
}

}  // namespace aeolic
