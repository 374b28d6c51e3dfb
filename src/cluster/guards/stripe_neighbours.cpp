#include "cluster/guards/stripe_neighbours.h"

#include <algorithm>

#include "cluster/guards/row_exchange.h"

namespace aeolic {
namespace {

// The rows that `user` reads of `owner`'s stripe: above its own or below, for ranks own rows in order.
RowSpan rowsRead(const Stripes& stripes, int user, int owner, int rows)
{
    if (user == owner || stripes.rows(user) == 0) return {};
    const Extent mine = stripes.extent(user, 1), theirs = stripes.extent(owner, 1);
    const RowSpan side = owner < user ? RowSpan{mine.y0 - rows, mine.y0} : RowSpan{mine.y1, mine.y1 + rows};
    return {std::max(side.y0, theirs.y0), std::min(side.y1, theirs.y1)};
}

}  // namespace

void StripeNeighbours::receive(const ImageRows& image, int rows)
{
    const int me = communicator_.rank(), ranks = communicator_.size();
    const std::vector<ImageRows> images{image};
    const auto loadOf = [&](int user, int owner) {
        const RowSpan read = rowsRead(stripes_, user, owner, rows);
        std::vector<RowLoad> load;
        if (read.y0 < read.y1) load.push_back({&images, {{image.valid.x0, read.y0, image.valid.x1, read.y1}}});
        return load;
    };
    std::vector<std::vector<RowLoad>> toRank, fromRank;
    for (int r = 0; r < ranks; ++r) {
        toRank.push_back(loadOf(r, me));
        fromRank.push_back(loadOf(me, r));
    }
    Bytes room;
    exchangeRows(communicator_, toRank, fromRank, room);
}

}  // namespace aeolic
