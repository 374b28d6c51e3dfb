#include "cluster/hosts.h"

#include <unistd.h>

#include <algorithm>
#include <string_view>

namespace aeolic {

int ranksOnThisHost(Communicator& communicator)
{
    char name[256] = {};
    gethostname(name, sizeof name - 1);
    const std::string_view host(name);
    const std::vector<Bytes> hosts = communicator.allGather(std::as_bytes(std::span(host)));
    const Bytes& mine = hosts[std::size_t(communicator.rank())];
    return int(std::count(hosts.begin(), hosts.end(), mine));
}

}  // namespace aeolic
