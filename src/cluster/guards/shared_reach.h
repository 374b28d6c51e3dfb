#pragma once

#include <vector>

#include "cluster/balance/stripes.h"
#include "cluster/comm/communicator.h"
#include "render/guard_exchange.h"

namespace aeolic {

/// Collective. What traces from each rank's stripe get to by so many jumps, for each direction of `boxes`, those of
/// this rank's stripe. `limits`: rows that this rank has room for. Cost: two all-gathers, of every rank's boxes and of
/// what each has found (cluster/reached_rows.h).
std::vector<ReachedRows> shareReachedRows(Communicator& communicator, const Stripes& stripes,
                                          const std::vector<JumpBoxes>& boxes, const RowSpan& limits, int jumps);

}  // namespace aeolic
