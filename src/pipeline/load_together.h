#pragma once

#include <memory>

#include "cluster/communicator.h"
#include "data/scene.h"
#include "data/scene_steps.h"

namespace aeolic {

/// Collective. Loads the scene on every rank, at its moment: all of the field, or its own brick
/// (`description.run.bricks`; auto splits it where the ranks of a host would not fit their memory otherwise). Largest
/// vector and scalar range are the whole scene's either way. `steps`: gets what other moments of the scene come from.
/// Throws what any rank throws, on all.
Scene loadTogether(Communicator& communicator, const SceneDescription& description, int ranksOnHost,
                   Progress progress = nullptr, void* context = nullptr, std::unique_ptr<SceneSteps>* steps = nullptr);

/// Collective. Makes `scene`, which came with `steps`, that of another moment. Throws what any rank throws, on all; the
/// scene is then as it was.
SceneChange moveTogether(Communicator& communicator, SceneSteps& steps, double moment, Scene& scene,
                         Progress progress = nullptr, void* context = nullptr);

}  // namespace aeolic
