#pragma once

#include "cluster/communicator.h"
#include "data/scene.h"

namespace aeolic {

/// Collective. Loads the scene on every rank: all of the field, or its own brick (`description.run.bricks`; auto splits
/// it where the ranks of a host would not fit their memory otherwise). Largest vector and scalar range are the whole
/// scene's either way. Throws what any rank throws, on all.
Scene loadTogether(Communicator& communicator, const SceneDescription& description, int ranksOnHost,
                   Progress progress = nullptr, void* context = nullptr);

}  // namespace aeolic
