#include "cluster/guards/shared_reach.h"

#include <algorithm>
#include <span>

#include "cluster/guards/reached_rows.h"

namespace aeolic {
namespace {

std::vector<JumpBox> gatherBoxes(Communicator& communicator, const Stripes& stripes, const std::vector<JumpBoxes>& mine)
{
    std::vector<std::size_t> bytes;
    bytes.reserve(std::size_t(communicator.size()));
    std::size_t before = 0, all = 0;
    for (int r = 0; r < communicator.size(); ++r) {
        const std::size_t count = mine.size() * ImageBoxes::countOf(stripes, r, mine.front().columns);
        if (r == communicator.rank()) before = all;
        all += count;
        bytes.push_back(count * sizeof(JumpBox));
    }
    std::vector<JumpBox> boxes(all);
    auto to = boxes.begin() + std::ptrdiff_t(before);
    for (const JumpBoxes& direction : mine) to = std::copy(direction.boxes.begin(), direction.boxes.end(), to);
    communicator.allGatherInPlace(std::as_writable_bytes(std::span(boxes)), bytes);
    return boxes;
}

}  // namespace

std::vector<ReachedRows> shareReachedRows(Communicator& communicator, const Stripes& stripes,
                                          const std::vector<JumpBoxes>& boxes, const RowSpan& limits, int jumps)
{
    const std::vector<JumpBox> all = gatherBoxes(communicator, stripes, boxes);
    const Extent stripe = stripes.extent(communicator.rank(), 1);
    const int directions = int(boxes.size()), columns = boxes.front().columns;
    const auto ranks = std::size_t(communicator.size()), mine = std::size_t(directions) * std::size_t(columns);
    std::vector<RowSpan> rows(ranks * mine);
    auto to = rows.begin() + std::ptrdiff_t(std::size_t(communicator.rank()) * mine);
    for (int d = 0; d < directions; ++d) {
        const ImageBoxes image(stripes, boxes[std::size_t(d)], all, directions, d);
        const std::vector<RowSpan> found = reachedRows(image, {stripe.y0, stripe.y1}, limits, jumps);
        to = std::copy(found.begin(), found.end(), to);
    }
    communicator.allGatherInPlace(std::as_writable_bytes(std::span(rows)),
                                  std::vector<std::size_t>(ranks, mine * sizeof(RowSpan)));
    std::vector<ReachedRows> reached(boxes.size(), {columns, {}});
    for (auto from = rows.begin(); from != rows.end();)
        for (ReachedRows& direction : reached) {
            direction.rows.insert(direction.rows.end(), from, from + columns);
            from += columns;
        }
    return reached;
}

}  // namespace aeolic
