#include "cluster/picture_gather.h"

#include <cstring>
#include <span>
#include <stdexcept>

namespace aeolic {
namespace {

/// From the first to the last row that is painted, and what the others are.
struct PaintedRows {
    std::int32_t y0 = 0, y1 = 0;
    std::array<std::uint8_t, 4> background{};
};
static_assert(sizeof(PaintedRows) == kPaintedRowsBytes);

PaintedRows paintedRows(const Tile& tile)
{
    PaintedRows rows{tile.extent.y0, tile.extent.y1, tile.background};
    const auto isEmpty = [&](int y) { return tile.painted[std::size_t(y - tile.extent.y0)].empty(); };
    while (rows.y0 < rows.y1 && isEmpty(rows.y0)) ++rows.y0;
    while (rows.y0 < rows.y1 && isEmpty(rows.y1 - 1)) --rows.y1;
    return rows;
}

PaintedRows paintedRows(const Bytes& sent, int rank, const Extent& stripe)
{
    PaintedRows rows;
    const bool whole = sent.size() == sizeof rows;
    if (whole) std::memcpy(&rows, sent.data(), sizeof rows);
    if (!whole || rows.y0 < stripe.y0 || rows.y1 > stripe.y1 || rows.y0 > rows.y1)
        throw std::runtime_error("rank 0: the picture: rank " + std::to_string(rank) +
                                 " sends rows that are not its own");
    return rows;
}

}  // namespace

void sendPainted(Communicator& communicator, const Tile& stripe)
{
    const PaintedRows rows = paintedRows(stripe);
    communicator.gather(std::as_bytes(std::span(&rows, 1)));
    if (rows.y0 < rows.y1)
        communicator.exchangeInPlace({{0, std::as_bytes(std::span(stripe.row(rows.y0), stripe.row(rows.y1)))}}, {});
}

void receivePainted(Communicator& communicator, const Stripes& stripes, Tile& picture, BusyClock& busy)
{
    const std::vector<Bytes> sent = communicator.gather({});
    busy.start();
    std::vector<IncomingBytes> parts;
    for (int r = 1; r < communicator.size(); ++r) {
        const Extent stripe = stripes.extent(r, picture.extent.width());
        const PaintedRows rows = paintedRows(sent[std::size_t(r)], r, stripe);
        picture.setBackground(rows.background);
        for (int y = stripe.y0; y < stripe.y1; ++y)
            if (y < rows.y0 || y >= rows.y1) picture.clearBeside(y, {});
        picture.paint(rows.y0, rows.y1);
        if (rows.y0 < rows.y1)
            parts.push_back({r, std::as_writable_bytes(std::span(picture.row(rows.y0), picture.row(rows.y1)))});
    }
    busy.stop();
    communicator.exchangeInPlace({}, std::move(parts));
}

}  // namespace aeolic
