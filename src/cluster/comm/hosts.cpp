#include "cluster/comm/hosts.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <thread>

namespace aeolic {
namespace {

constexpr std::size_t kMostCores = 8192;  // The largest that Linux is built for.

std::vector<RankPlace> gatherPlaces(Communicator& communicator)
{
    ByteWriter mine;
    mine.add(placeOfThisProcess());
    std::vector<RankPlace> places;
    for (const Bytes& bytes : communicator.allGather(mine.take())) ByteReader(bytes).read(places.emplace_back());
    return places;
}

}  // namespace

RankPlace placeOfThisProcess()
{
    RankPlace place;
    char name[256] = {};
    gethostname(name, sizeof name - 1);
    place.host = name;
    std::vector<cpu_set_t> set(kMostCores / CPU_SETSIZE);
    const std::size_t bytes = set.size() * sizeof(cpu_set_t);
    if (sched_getaffinity(0, bytes, set.data()) != 0) return place;
    for (std::size_t core = 0; core < kMostCores; ++core)
        if (CPU_ISSET_S(core, bytes, set.data())) {
            place.cores.resize(core + 1);
            place.cores[core] = true;
        }
    return place;
}

HostShare shareOf(const std::vector<RankPlace>& places, int rank)
{
    const RankPlace& mine = places[std::size_t(rank)];
    std::vector<const RankPlace*> neighbours;  // The ranks of this host, oneself included.
    for (const RankPlace& place : places)
        if (place.host == mine.host) neighbours.push_back(&place);
    HostShare share;
    share.ranks = int(neighbours.size());
    if (mine.cores.empty()) {
        share.cores = std::max(1, int(std::thread::hardware_concurrency()) / share.ranks);
        return share;
    }
    double cores = 0;
    for (std::size_t core = 0; core < mine.cores.size(); ++core)
        if (mine.cores[core])
            cores += 1.0 / double(std::count_if(neighbours.begin(), neighbours.end(), [&](const RankPlace* place) {
                         return core < place->cores.size() && place->cores[core];
                     }));
    share.cores = std::max(1, int(cores + 1e-6));  // Thirds may add up to a little less than one.
    return share;
}

int indexOnHost(const std::vector<RankPlace>& places, int rank)
{
    const auto mine = places.begin() + rank;
    return int(std::count_if(places.begin(), mine, [&](const RankPlace& place) { return place.host == mine->host; }));
}

HostShare hostShare(Communicator& communicator)
{
    return shareOf(gatherPlaces(communicator), communicator.rank());
}

int indexOnHost(Communicator& communicator)
{
    return indexOnHost(gatherPlaces(communicator), communicator.rank());
}

}  // namespace aeolic
