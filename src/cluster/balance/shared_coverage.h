#pragma once

#include "cluster/comm/communicator.h"
#include "render/coverage_bits.h"

namespace aeolic {

/// Collective. What any rank's part covers: each gives an image of the same size and gets all of them in one, in
/// ⌈log2 ranks⌉ messages of one image each. Throws where another rank's has another size.
void uniteCoverage(Communicator& communicator, CoverageBits& bits);

}  // namespace aeolic
