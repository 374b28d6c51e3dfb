#pragma once

#include <memory>

#include "render/backend.h"

namespace aeolic::cpu {

/// The stages on all cores of one machine: SIMD by Highway, threads by oneTBB.
/// Throws InputError where the surface has more points or triangles than 32-bit gathers reach.
std::unique_ptr<Backend> makeCpuBackend(const Scene& scene);

}  // namespace aeolic::cpu
