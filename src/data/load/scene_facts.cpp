#include "data/load/scene_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/append.h"
#include "base/parallel.h"
#include "data/mesh/mesh_tools.h"
#include "data/surface_range.h"

namespace aeolic {
namespace {

constexpr double kShortestVector = 1e-32, kLongestVector = 1e38;

double longest(const std::vector<glm::vec3>& vectors)
{
    std::vector<float> lengths(vectors.size());
    parallelRanges(vectors.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)  // The squares of what a float holds need a double.
            lengths[i] =
                float(std::min(glm::length(glm::dvec3(vectors[i])), double(std::numeric_limits<float>::max())));
    });
    const auto range = finiteRange(lengths);
    return range ? (*range)[1] : 0.0;
}

/// The range of all ranks' values; lo > hi where no rank knows any.
std::array<double, 2> uniteRange(Agreement& agreement, const std::array<double, 2>& mine, bool known)
{
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {agreement.least(known ? mine[0] : kInfinity), agreement.greatest(known ? mine[1] : -kInfinity)};
}

}  // namespace

void measure(Scene& scene)
{
    const SurfaceMesh& mesh = scene.surface;
    scene.maxVector =
        scene.field ? scene.field->maxMagnitude : std::max(longest(mesh.pointVectors), longest(mesh.cellVectors));
    scene.maxTangential = 0;
    if (scene.maxVector > 0)
        if (const auto along = scene.field ? rangeOnSurface(mesh, *scene.field, ArrayPart::tangential)
                                           : rangeOfVectors(mesh, ArrayPart::tangential))
            scene.maxTangential = (*along)[1];
    if (!scene.hasScalar) return;
    const auto valuesOf = [&] {
        if (scene.scalarField) return rangeOnSurface(mesh, *scene.scalarField);
        if (scene.ofVectors == ArrayPart::whole)
            return finiteRange(mesh.pointScalars.empty() ? mesh.cellScalars : mesh.pointScalars);
        return scene.field ? rangeOnSurface(mesh, *scene.field, scene.ofVectors)
                           : rangeOfVectors(mesh, scene.ofVectors);
    };
    const auto range = valuesOf();
    scene.scalarRangeKnown = range.has_value();
    if (range) scene.scalarRange = *range;
}

bool atRest(const Scene& scene)
{
    return scene.maxVector == 0 ||
           (scene.hasScalar && (!scene.scalarRangeKnown || scene.scalarRange[0] == scene.scalarRange[1]));
}

std::vector<std::string> distinctTexts(const std::vector<std::string>& texts)
{
    std::vector<std::string> distinct;
    for (const std::string& text : texts)
        if (std::ranges::find(distinct, text) == distinct.end()) distinct.push_back(text);
    return distinct;
}

void finishScene(Scene& scene, bool hasStreaks)
{
    if (scene.maxVector == 0 && hasStreaks)
        scene.warnings.push_back(
            scene.surface.name +
            ": all vectors are zero or masked; try --vectors with another array, or --field with the flow around it");
    // Beyond, differences of floats are infinite, or a millionth of the longest is not a normal one.
    if (hasStreaks && scene.maxVector > 0 && (scene.maxVector < kShortestVector || scene.maxVector > kLongestVector))
        scene.warnings.push_back(
            fmt::format("{}: the longest vector is {:.3g}; streaks need vectors of {} to {}, in another unit",
                        scene.surface.name, scene.maxVector, kShortestVector, kLongestVector));
    if (scene.hasScalar && !scene.scalarRangeKnown)
        scene.warnings.push_back(scene.surface.name + ": '" + scene.scalarName +
                                 "' has no finite value on the surface");
    std::vector<std::string> all;
    for (const Tally& tally : scene.tallies)
        for (std::string& warning : warningsOf(tally)) all.push_back(std::move(warning));
    appendAll(all, scene.warnings);
    scene.tallies.clear();
    scene.warnings = distinctTexts(all);  // An array that serves twice is judged twice.
}

CutFacts factsOfCut(const LoadedSurface& cut)
{
    return {cut.cutRange, cut.mesh.triangles.size()};
}

void uniteBounds(Agreement& agreement, Bounds& bounds)
{
    for (int c = 0; c < 3; ++c) {
        bounds.lo[c] = agreement.least(bounds.lo[c]);
        bounds.hi[c] = agreement.greatest(bounds.hi[c]);
    }
}

PieceFacts uniteFacts(Agreement& agreement, PieceFacts facts)
{
    uniteBounds(agreement, facts.pointsWorld);
    facts.normals = agreement.all(facts.normals);
    return facts;
}

CutFacts uniteFacts(Agreement& agreement, CutFacts facts)
{
    facts.range = uniteRange(agreement, facts.range, facts.range[0] <= facts.range[1]);
    facts.triangles = std::uint64_t(agreement.sum(std::int64_t(facts.triangles)));
    return facts;
}

std::vector<Tally> sumTallies(Agreement& agreement, const std::vector<Tally>& mine)
{
    std::vector<std::string> things;
    things.reserve(mine.size());
    for (const Tally& tally : mine) things.push_back(char(tally.of) + tally.where);
    std::vector<Tally> all;
    for (const std::string& thing : agreement.distinct(things)) {
        Tally tally{Tally::Of(thing[0]), thing.substr(1)};
        const auto own = std::ranges::find_if(mine, [&](const Tally& t) { return t.sameThing(tally); });
        if (own != mine.end()) tally = *own;
        for (std::int64_t* count : {&tally.found, &tally.also, &tally.all}) *count = agreement.sum(*count);
        tally.longest = agreement.greatest(tally.longest);
        all.push_back(tally);
    }
    return all;
}

void uniteRanges(Agreement& agreement, Scene& scene)
{
    scene.maxVector = agreement.greatest(scene.maxVector);
    scene.maxTangential = agreement.greatest(scene.maxTangential);
    const std::array<double, 2> range = uniteRange(agreement, scene.scalarRange, scene.scalarRangeKnown);
    scene.scalarRangeKnown = range[0] <= range[1];
    if (scene.scalarRangeKnown) scene.scalarRange = range;
}

SurfaceReach reachOf(Agreement& agreement, const Scene& scene)
{
    SurfaceReach reach{scene.surface.bounds(), radiusAbout(scene.surface, scene.boundsWorld.center())};
    if (!scene.inPieces) return reach;
    reach.radius = agreement.greatest(reach.radius);
    uniteBounds(agreement, reach.boundsWorld);
    return reach;
}

}  // namespace aeolic
