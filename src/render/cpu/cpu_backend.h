#pragma once

#include "render/backend_kinds.h"

namespace aeolic::cpu {

/// The stages on all cores of one machine: SIMD by Highway, threads by oneTBB. make() throws InputError where the
/// surface has more points or triangles than 32-bit gathers reach.
extern const BackendKind kind;

}  // namespace aeolic::cpu
