#pragma once

#include "data/scene.h"

namespace aeolic {

/// Kernels multiply up to four lengths in floats, and square vectors. Where a scene's would leave the range of a float,
/// they count in another unit: a power of two, so that nothing is rounded. It is 1 for ordinary sizes. Both follow from
/// the whole scene, so they are the same on all ranks and for all moments.

/// World units in a kernel's unit of length.
double lengthUnit(const Scene& scene);

/// Units of the scene's vectors in a kernel's.
double vectorUnit(const Scene& scene);

}  // namespace aeolic
