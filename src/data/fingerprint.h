#pragma once

#include <string>

#include "data/scene.h"

namespace aeolic {

/// A few words that differ where scenes do, for finding out whether all ranks loaded the same: sizes, ranges, and a
/// hash of the surface. The field's samples are not read: ranks may hold different parts. Cost: one pass over the
/// surface.
std::string fingerprint(const Scene& scene);

}  // namespace aeolic
