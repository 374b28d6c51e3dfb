#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/byte_message.h"
#include "cluster/comm/communicator.h"

namespace aeolic {

/// Where a rank runs.
struct RankPlace {
    std::string host;
    std::vector<std::uint8_t> cores;  ///< [core]: whether it may run there. Empty: not told.
};

template <PerhapsConst<RankPlace> Place, class Visit>
void withMembers(Place& place, const Visit& visit)
{
    visit(place.host, place.cores);
}

/// Local. Where this process runs, as the launcher or the batch system bound it.
RankPlace placeOfThisProcess();

/// A rank's share of its host.
struct HostShare {
    int ranks = 1;  ///< How many run there, this one included.
    int cores = 1;  ///< How many this rank is to use, at least 1. It shares a core with the others that may run on it.
    bool operator==(const HostShare&) const = default;
};

/// Local. The share of `rank`, given where all ranks are. All shares of a host together are no more than its cores,
/// unless some ranks would get less than one.
HostShare shareOf(const std::vector<RankPlace>& places, int rank);

/// Collective. This rank's share.
HostShare hostShare(Communicator& communicator);

/// Local. How many ranks of the same host come before `rank`. The ranks of a host share its GPUs by this number.
int indexOnHost(const std::vector<RankPlace>& places, int rank);

/// Collective. How many ranks of this rank's host come before it.
int indexOnHost(Communicator& communicator);

}  // namespace aeolic
