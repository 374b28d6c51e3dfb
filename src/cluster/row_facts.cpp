#include "cluster/row_facts.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "base/parallel.h"
#include "render/gbuffer.h"
#include "render/near_flow.h"

namespace aeolic {
namespace {

RowFacts factsOf(const std::uint32_t* row, int x0, int x1)
{
    const ColumnSpan flow = flowColumns(row, x0, x1);
    if (flow.empty()) return {};
    int largest = 0;
    for (int x = flow.x0; x < flow.x1; ++x) largest = std::max(largest, std::abs(flow_texel::dy(row[x])));
    return {std::uint16_t(flow.x0), std::uint16_t(flow.x1), std::uint16_t(largest)};
}

}  // namespace

std::vector<RowFacts> rowFacts(const Image<std::uint32_t>& flow, const Extent& own)
{
    std::vector<RowFacts> facts(std::size_t(own.height()));
    parallelRanges(facts.size(), 32, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) facts[i] = factsOf(flow.row(own.y0 + int(i)), own.x0, own.x1);
    });
    return facts;
}

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
