#include "cluster/guards/gather_row_flow.h"

#include <algorithm>
#include <span>
#include <stdexcept>

#include "cluster/guards/row_exchange.h"

namespace aeolic {

std::vector<RowFlow> gatherRowFlow(Communicator& communicator, const Stripes& stripes, const std::vector<RowFlow>& own)
{
    const int rank = communicator.rank();
    if (int(own.size()) != stripes.rows(rank))
        throw std::runtime_error("rank " + std::to_string(rank) + " has another stripe than it should");
    std::vector<RowFlow> whole(std::size_t(stripes.height()));
    std::copy(own.begin(), own.end(), whole.begin() + stripes.firstRow[std::size_t(rank)]);
    allGatherRows(communicator, stripes, std::as_writable_bytes(std::span(whole)), sizeof(RowFlow));
    return whole;
}

}  // namespace aeolic
