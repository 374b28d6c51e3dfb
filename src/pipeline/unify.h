#pragma once

#include <cstdint>

#include "cluster/communicator.h"
#include "data/scene.h"
#include "data/scene_steps.h"
#include "scene/camera.h"

/// What only all parts of a scene together tell, where each rank holds one. Minima, maxima and whole numbers: the same
/// bits as of the whole scene. Everything is Collective.
namespace aeolic {

PieceFacts unified(Communicator& communicator, PieceFacts facts);

/// Largest vector and scalar range.
void unifyRanges(Communicator& communicator, Scene& scene);

/// Of a surface in pieces: bounds, radius and number of triangles. Throws on all InputError where no piece has any, or
/// none meets the field.
void unifyPieces(Communicator& communicator, const SceneSteps& steps, Scene& scene);

/// Throws on all InputError unless the pieces of each isosurface last read have a triangle, and `drawn` are left.
void requireCutsOfAll(Communicator& communicator, const SceneSteps& steps, std::uint64_t drawn);

/// Where the whole surface is at this moment. Local where it is not in pieces.
SurfaceReach reachOf(Communicator& communicator, const Scene& scene);

}  // namespace aeolic
