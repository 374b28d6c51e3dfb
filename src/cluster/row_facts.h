#pragma once

#include <vector>

#include "cluster/communicator.h"
#include "cluster/stripes.h"
#include "render/row_facts.h"

namespace aeolic {

/// Collective. The whole image's facts from those of each rank's stripe. Cost: 6 bytes a row from its owner to
/// everyone.
std::vector<RowFacts> gatherRowFacts(Communicator& communicator, const Stripes& stripes,
                                     const std::vector<RowFacts>& own);

}  // namespace aeolic
