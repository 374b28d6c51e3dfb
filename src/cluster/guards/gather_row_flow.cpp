#include "cluster/guards/gather_row_flow.h"

#include <algorithm>
#include <span>
#include <stdexcept>

namespace aeolic {

std::vector<RowFlow> gatherRowFlow(Communicator& communicator, const Stripes& stripes, const std::vector<RowFlow>& own)
{
    const int rank = communicator.rank();
    if (int(own.size()) != stripes.rows(rank))
        throw std::runtime_error("rank " + std::to_string(rank) + " has another stripe than it should");
    std::vector<RowFlow> whole(std::size_t(stripes.height()));
    std::copy(own.begin(), own.end(), whole.begin() + stripes.firstRow[std::size_t(rank)]);
    std::vector<std::size_t> bytes;
    bytes.reserve(std::size_t(stripes.ranks()));
    for (int r = 0; r < stripes.ranks(); ++r) bytes.push_back(std::size_t(stripes.rows(r)) * sizeof(RowFlow));
    communicator.allGatherInPlace(std::as_writable_bytes(std::span(whole)), bytes);
    return whole;
}

}  // namespace aeolic
