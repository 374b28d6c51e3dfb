#pragma once

#include <cstdint>

#include "cluster/comm/communicator.h"
#include "data/load/scene_steps.h"
#include "data/scene.h"
#include "description/camera.h"

/// What only all parts of a scene together tell, where each rank holds one. Minima, maxima and whole numbers: the same
/// bits as of the whole scene. Everything is Collective.
namespace aeolic {

PieceFacts unified(Communicator& communicator, PieceFacts facts);

/// Every rank's tallies as one rank would have them that holds everything: added up, in the order of the first rank
/// that has them.
std::vector<Tally> added(Communicator& communicator, const std::vector<Tally>& mine);

/// Largest vector and scalar range.
void unifyRanges(Communicator& communicator, Scene& scene);

/// Of a surface in pieces: bounds, radius and number of triangles. Throws on all InputError where no piece has any, or
/// none meets the field.
void unifyPieces(Communicator& communicator, const SceneSteps& steps, Scene& scene);

/// Of a surface in pieces that may move: makes this rank's piece of the moment prepared. Throws on all InputError where
/// no piece of a step just read has a triangle, or none is left of them in between.
void makePieces(Communicator& communicator, SceneSteps& steps, const Scene& scene);

/// Where the whole surface is at this moment. Local where it is not in pieces.
SurfaceReach reachOf(Communicator& communicator, const Scene& scene);

}  // namespace aeolic
