#pragma once

#include <memory>

#include "cluster/comm/communicator.h"
#include "data/load/scene_steps.h"
#include "data/scene.h"

namespace aeolic {

/// Collective. Loads the scene on every rank, at its moment: all of it, or its own brick of the field, or its own piece
/// of the surface, or both (`description.run.bricks`; auto splits what the ranks of a host would not fit their memory
/// with otherwise). What is said of the whole scene, ranges and bounds, is the same either way.
/// `steps`: gets what other moments of the scene come from. Throws what any rank throws, on all.
Scene loadTogether(Communicator& communicator, const SceneDescription& description, int ranksOnHost,
                   Progress progress = nullptr, void* context = nullptr, std::unique_ptr<SceneSteps>* steps = nullptr);

/// What of a scene is split among the ranks.
struct Split {
    bool field = false;    ///< Into bricks; and with it an isosurface of it, into the pieces in them.
    bool surface = false;  ///< A surface from a file: into the pieces of that file, or where the field is split too,
                           ///< the triangles in each brick.
};

/// Collective. What loadTogether() splits.
Split splitOf(Communicator& communicator, const SceneDescription& description, int ranksOnHost);

/// Collective. The same with a split that is given, the same on all ranks.
Scene loadSplit(Communicator& communicator, const SceneDescription& description, const Split& split,
                Progress progress = nullptr, void* context = nullptr, std::unique_ptr<SceneSteps>* steps = nullptr);

/// Collective. Makes `scene`, which came with `steps`, that of another moment. Throws what any rank throws, on all; the
/// scene is then as it was.
SceneChange moveTogether(Communicator& communicator, SceneSteps& steps, double moment, Scene& scene,
                         Progress progress = nullptr, void* context = nullptr);

}  // namespace aeolic
