#include "engine/unify.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "cluster/comm/agreement.h"
#include "data/mesh_tools.h"
#include "data/surface_range.h"

namespace aeolic {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void unifyBounds(Communicator& communicator, Bounds& bounds)
{
    for (int c = 0; c < 3; ++c) {
        bounds.lo[c] = communicator.allReduce(bounds.lo[c], Reduction::min);
        bounds.hi[c] = communicator.allReduce(bounds.hi[c], Reduction::max);
    }
}

std::vector<CutFacts> unified(Communicator& communicator, std::vector<CutFacts> cuts)
{
    for (CutFacts& cut : cuts) {
        const bool some = cut.range[0] <= cut.range[1];
        cut.range[0] = communicator.allReduce(some ? cut.range[0] : kInfinity, Reduction::min);
        cut.range[1] = communicator.allReduce(some ? cut.range[1] : -kInfinity, Reduction::max);
        cut.triangles = std::uint64_t(communicator.allReduce(std::int64_t(cut.triangles), Reduction::sum));
    }
    return cuts;
}

/// Throws on all InputError unless the pieces of each isosurface last read have a triangle, and `drawn` are left.
void requireCutsOfAll(Communicator& communicator, const SceneSteps& steps, std::uint64_t drawn)
{
    const std::vector<CutFacts> cuts = unified(communicator, steps.cuts());
    runTogether(communicator, [&] { steps.requireTriangles(cuts, drawn); });
}

}  // namespace

PieceFacts unified(Communicator& communicator, PieceFacts facts)
{
    unifyBounds(communicator, facts.pointsWorld);
    facts.normals = communicator.allReduce(std::int64_t(facts.normals), Reduction::min) > 0;
    return facts;
}

std::vector<Tally> added(Communicator& communicator, const std::vector<Tally>& mine)
{
    std::vector<std::string> things;
    things.reserve(mine.size());
    for (const Tally& tally : mine) things.push_back(char(tally.of) + tally.where);
    std::vector<Tally> all;
    for (const std::string& thing : distinctOfAll(communicator, things)) {
        Tally tally{Tally::Of(thing[0]), thing.substr(1)};
        const auto own = std::find_if(mine.begin(), mine.end(), [&](const Tally& t) { return t.sameThing(tally); });
        if (own != mine.end()) tally = *own;
        std::array<std::int64_t, 3> counts{tally.found, tally.also, tally.all};
        communicator.allReduce(std::span<std::int64_t>(counts), Reduction::sum);
        tally.longest = communicator.allReduce(tally.longest, Reduction::max);
        tally.found = counts[0], tally.also = counts[1], tally.all = counts[2];
        all.push_back(tally);
    }
    return all;
}

SurfaceReach reachOf(Communicator& communicator, const Scene& scene)
{
    SurfaceReach reach{scene.surface.bounds(), radiusAbout(scene.surface, scene.boundsWorld.center())};
    if (!scene.inPieces) return reach;
    reach.radius = communicator.allReduce(reach.radius, Reduction::max);
    unifyBounds(communicator, reach.boundsWorld);
    return reach;
}

void unifyRanges(Communicator& communicator, Scene& scene)
{
    scene.maxVector = communicator.allReduce(scene.maxVector, Reduction::max);
    auto& [lo, hi] = scene.scalarRange;
    const double least = communicator.allReduce(scene.scalarRangeKnown ? lo : kInfinity, Reduction::min);
    const double greatest = communicator.allReduce(scene.scalarRangeKnown ? hi : -kInfinity, Reduction::max);
    scene.scalarRangeKnown = least <= greatest;
    if (scene.scalarRangeKnown) scene.scalarRange = {least, greatest};
}

void makePieces(Communicator& communicator, SceneSteps& steps, const Scene& scene)
{
    std::vector<PieceFacts> facts = steps.unplacedPieces();
    for (PieceFacts& step : facts) step = unified(communicator, step);
    runTogether(communicator, [&] { steps.placePieces(facts); });
    const bool meets = communicator.allReduce(std::int64_t(steps.surfaceMeets()), Reduction::min) > 0;
    std::optional<std::size_t> made;
    runTogether(communicator, [&] { made = steps.make(meets); });
    std::uint64_t triangles = scene.allTriangles;
    if (made) triangles = std::uint64_t(communicator.allReduce(std::int64_t(*made), Reduction::sum));
    requireCutsOfAll(communicator, steps, triangles);
}

void unifyPieces(Communicator& communicator, const SceneSteps& steps, Scene& scene)
{
    unifyBounds(communicator, scene.boundsWorld);
    scene.fitRadius = reachOf(communicator, scene).radius;
    const bool meetsHere = scene.field && meets(scene.surface, boundsOf(*scene.field));
    const bool meetsField = communicator.allReduce(std::int64_t(meetsHere), Reduction::max) > 0;
    scene.allTriangles = std::uint64_t(communicator.allReduce(std::int64_t(scene.allTriangles), Reduction::sum));
    requireCutsOfAll(communicator, steps, scene.allTriangles);
    runTogether(communicator, [&] { steps.requireOverlap(scene, meetsField); });
}

}  // namespace aeolic
