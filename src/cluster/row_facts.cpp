#include "cluster/row_facts.h"

#include <cstring>
#include <stdexcept>

namespace aeolic {

std::vector<RowFacts> gatherRowFacts(Communicator& communicator, const Stripes& stripes,
                                     const std::vector<RowFacts>& own)
{
    std::vector<RowFacts> whole(std::size_t(stripes.height()));
    const std::vector<Bytes> all = communicator.allGather(std::as_bytes(std::span(own)));
    for (int r = 0; r < stripes.ranks(); ++r) {
        const Bytes& bytes = all[std::size_t(r)];
        if (bytes.size() != std::size_t(stripes.rows(r)) * sizeof(RowFacts))
            throw std::runtime_error("rank " + std::to_string(r) + " has another stripe than the others think");
        if (!bytes.empty())
            std::memcpy(&whole[std::size_t(stripes.firstRow[std::size_t(r)])], bytes.data(), bytes.size());
    }
    return whole;
}

}  // namespace aeolic
