#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "data/load/agreement.h"
#include "data/loaded_surface.h"
#include "data/scene.h"

namespace aeolic {

/// Finds the largest vector and the scalar range of what `scene` shows; where it is a part, of that part.
void measure(Scene& scene);

/// Whether the ranges of a first moment are of no use for an animation, because nothing moves yet or all colours are
/// the same. The ranges of the last moment are taken then.
bool atRest(const Scene& scene);

/// Turns tallies into warnings, and warns that nothing flows, where there are to be streaks, or that nothing can be
/// coloured. Only the whole scene tells: ranges and tallies are those of all parts by now.
void finishScene(Scene& scene, bool hasStreaks);

/// The texts, each once.
std::vector<std::string> distinctTexts(const std::vector<std::string>& texts);

/// What a piece of an isosurface tells.
struct CutFacts {
    std::array<double, 2> range{0, 0};  ///< The finite values around it; lo > hi: there is none.
    std::uint64_t triangles = 0;
};

CutFacts factsOfCut(const LoadedSurface& cut);

// What follows is Collective: what only all parts of a scene together tell, where every rank holds one. Least and
// greatest values and whole numbers have the same bits as those of the whole scene.

PieceFacts uniteFacts(Agreement& agreement, PieceFacts facts);
CutFacts uniteFacts(Agreement& agreement, CutFacts facts);

/// The tallies that one rank would have if it held everything: every rank's are added up, in the order of the first
/// rank that has them.
std::vector<Tally> sumTallies(Agreement& agreement, const std::vector<Tally>& mine);

/// Largest vector and scalar range.
void uniteRanges(Agreement& agreement, Scene& scene);

void uniteBounds(Agreement& agreement, Bounds& bounds);

/// Where the whole surface is. Local where it is not in pieces.
SurfaceReach reachOf(Agreement& agreement, const Scene& scene);

}  // namespace aeolic
