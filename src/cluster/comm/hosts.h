#pragma once

#include <string>
#include <vector>

#include "cluster/comm/communicator.h"

namespace aeolic {

/// Where a rank runs.
struct RankPlace {
    std::string host;
    std::vector<bool> cores;  ///< [core]: it may run there. Empty: not told.
};

/// Local. Where this process runs, as the launcher or the batch system bound it.
RankPlace placeOfThisProcess();

/// What a rank has of its host.
struct HostShare {
    int ranks = 1;  ///< That run there, this one included.
    int cores = 1;  ///< To be used by this one: those it may run on, each shared with the others that may. At least 1.
    bool operator==(const HostShare&) const = default;
};

/// Local. The share of `rank`, given where all are. All shares of a host together are no more than its cores, but for
/// ranks that get less than one.
HostShare shareOf(const std::vector<RankPlace>& places, int rank);

/// Collective. This rank's share.
HostShare hostShare(Communicator& communicator);

/// Local. How many ranks of the same host come before `rank`: by it the ranks of a host share its GPUs.
int indexOnHost(const std::vector<RankPlace>& places, int rank);

/// Collective. This rank's.
int indexOnHost(Communicator& communicator);

}  // namespace aeolic
