#pragma once

#include <vector>

#include "cluster/balance/stripes.h"
#include "cluster/comm/communicator.h"
#include "render/lic/row_flow.h"

namespace aeolic {

/// Collective. Gathers the facts of the whole image from those of each rank's stripe. Cost: 6 bytes a row, from its
/// owner to everyone.
std::vector<RowFlow> gatherRowFlow(Communicator& communicator, const Stripes& stripes, const std::vector<RowFlow>& own);

}  // namespace aeolic
