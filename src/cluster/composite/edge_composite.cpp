#include "cluster/composite/edge_composite.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

#include "cluster/composite/pixel_messages.h"
#include "cluster/guards/row_exchange.h"

namespace aeolic {

EdgeMask EdgeComposite::gather(const EdgeMask& mine)
{
    EdgeMask all;
    all.clear({0, 0, width_, stripes_.height()});
    const std::size_t bytesPerRow = all.bits.wordsPerRow * sizeof(std::uint64_t);
    const int own = stripes_.rows(communicator_.rank());
    if (!mine.rows.empty()) std::memcpy(all.row(mine.rows.y0), mine.bits.words.data(), std::size_t(own) * bytesPerRow);
    allGatherRows(communicator_, stripes_, std::as_writable_bytes(std::span(all.bits.words)), bytesPerRow);
    return all;
}

std::vector<EdgePixelSeen> EdgeComposite::exchange(const std::vector<EdgePixelSeen>& mine)
{
    std::vector<Message> outgoing;
    outgoing.reserve(std::size_t(stripes_.ranks()));
    for (int r = 0; r < stripes_.ranks(); ++r) outgoing.push_back({r, {}});
    for (const EdgePixelSeen& pixel : mine)
        appendBytes(outgoing[std::size_t(stripes_.ownerOf(pixel.y))].bytes, &pixel, 1);
    const Extent rows = stripes_.extent(communicator_.rank(), width_);
    std::vector<EdgePixelSeen> all;
    for (const Message& message : communicator_.exchange(std::move(outgoing))) {
        const auto pixels = valuesOf<EdgePixelSeen>(message);
        if (!std::ranges::all_of(pixels, [&](const EdgePixelSeen& pixel) { return rows.contains(pixel.x, pixel.y); }))
            throw std::runtime_error("samples of edges from rank " + std::to_string(message.rank) +
                                     " are of other rows");
        all.insert(all.end(), pixels.begin(), pixels.end());
    }
    return all;
}

}  // namespace aeolic
