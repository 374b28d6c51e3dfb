#pragma once

#include <string>

#include "data/scene.h"

namespace aeolic {

/// A few lines that differ where scenes do, for finding out whether all ranks loaded the same: sizes, places, ranges,
/// and a hash of the surface and of some of the field's samples; of none where the field is split into bricks, which
/// differ by rank. Cost: one pass over the surface.
std::string fingerprint(const Scene& scene);

}  // namespace aeolic
