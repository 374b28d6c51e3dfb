#include "cluster/guards/stripe_neighbours.h"

#include <algorithm>
#include <cstring>

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

std::size_t rowBytes(const ImageRows& image)
{
    return std::size_t(image.valid.width()) * std::size_t(image.pixelBytes);
}

}  // namespace

void StripeNeighbours::receive(const ImageRows& image, int rows)
{
    const int me = communicator_.rank(), ranks = communicator_.size();
    const std::size_t bytes = rowBytes(image);
    const auto count = static_cast<std::size_t>(ranks);
    std::vector<Bytes> sent(count), received(count);
    std::vector<OutgoingBytes> outgoing;
    std::vector<IncomingBytes> incoming;
    for (int r = 0; r < ranks; ++r) {
        const RowSpan theirs = rowsRead(stripes_, r, me, rows), mine = rowsRead(stripes_, me, r, rows);
        for (int y = theirs.y0; y < theirs.y1; ++y) {
            const std::byte* row = image.at(image.valid.x0, y);
            sent[std::size_t(r)].insert(sent[std::size_t(r)].end(), row, row + bytes);
        }
        received[std::size_t(r)].resize(std::size_t(std::max(mine.y1 - mine.y0, 0)) * bytes);
        outgoing.push_back({r, sent[std::size_t(r)]});
        incoming.push_back({r, received[std::size_t(r)]});
    }
    communicator_.exchangeInPlace(std::move(outgoing), std::move(incoming));
    for (int r = 0; r < ranks; ++r) {
        const std::byte* from = received[std::size_t(r)].data();
        const RowSpan mine = rowsRead(stripes_, me, r, rows);
        for (int y = mine.y0; y < mine.y1; ++y, from += bytes) std::memcpy(image.at(image.valid.x0, y), from, bytes);
    }
}

}  // namespace aeolic
