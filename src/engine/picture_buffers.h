#pragma once

#include "aeolic/buffers.h"
#include "cluster/comm/communicator.h"
#include "render/backend.h"

namespace aeolic {

/// What the frame that `backend` finished last shows, in some of its rows. Local. Cost: what a probe costs.
PictureBuffers buffersOf(Backend& backend, const View& view, const Scene& scene, const Extent& rows);

/// Collective. Rank 0 gets the rows of all ranks, one below the other, and the others an empty picture.
PictureBuffers gathered(const PictureBuffers& mine, Communicator& ranks);

}  // namespace aeolic
