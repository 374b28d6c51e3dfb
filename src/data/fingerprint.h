#pragma once

#include <string>

#include "data/scene.h"

namespace aeolic {

/// A few lines that differ where scenes do, to find out whether all ranks loaded the same: sizes, places, ranges, and a
/// hash of the surface and of some of the field's samples. What is split differs by rank and is left out of the hash.
/// Cost: one pass over the surface.
std::string fingerprint(const Scene& scene);

}  // namespace aeolic
