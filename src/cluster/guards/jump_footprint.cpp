#include "cluster/guards/jump_footprint.h"

#include <algorithm>
#include <cmath>

#include "render/limits.h"

namespace aeolic {
namespace {

constexpr int kBlock = JumpBoxes::kColumns;

/// Adds to the rows reached of each column what jumps from some rows of a column of blocks lead to.
class Spread {
public:
    Spread(const ImageBoxes& boxes, const RowSpan& limits, std::vector<RowSpan>& reached)
        : boxes_(boxes), limits_(limits), reached_(reached)
    {
    }

    void from(int column, const RowSpan& rows)
    {
        for (int y = rows.y0; y < rows.y1;) {
            const ImageBoxes::Blocks& blocks = boxes_.at(y);
            const int end = std::min(rows.y1, blocks.rows.y1);
            const JumpBox& box = blocks.boxes[column];
            if (!box.empty()) along(box, column, {y, end});
            y = end;
        }
    }

private:
    int least(int units) const { return int(std::floor(float(units) * boxes_.unitPx())) - limits::kJumpMarginPx; }
    int most(int units) const { return int(std::ceil(float(units + 1) * boxes_.unitPx())) + limits::kJumpMarginPx; }

    void along(const JumpBox& box, int column, const RowSpan& rows)
    {
        const RowSpan to{std::max(rows.y0 + least(box.y0), limits_.y0), std::min(rows.y1 + most(box.y1), limits_.y1)};
        const int x0 = std::max(column * kBlock + least(box.x0), 0) / kBlock,
                  x1 = std::min((column * kBlock + kBlock - 1 + most(box.x1)) / kBlock, boxes_.columns() - 1);
        for (int c = x0; c <= x1; ++c) {
            RowSpan& reached = reached_[std::size_t(c)];
            reached.y0 = std::min(reached.y0, to.y0);
            reached.y1 = std::max(reached.y1, to.y1);
        }
    }

    const ImageBoxes& boxes_;
    const RowSpan limits_;
    std::vector<RowSpan>& reached_;
};

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

ImageBoxes::ImageBoxes(const Stripes& stripes, const JumpBoxes& like, std::span<const JumpBox> given, int directions,
                       int direction)
    : columns_(like.columns), unitPx_(like.unitPx), blocksOf_(std::size_t(stripes.height()))
{
    const JumpBox* first = given.data();
    for (int r = 0; r < stripes.ranks(); ++r) {
        const Extent stripe = stripes.extent(r, 1);
        const std::size_t count = countOf(stripes, r, columns_);
        const JumpBox* next = first + std::size_t(direction) * count;
        for (int y = stripe.y0; y < stripe.y1; y += JumpBoxes::kRows, next += columns_) {
            const RowSpan rows{y, std::min(y + JumpBoxes::kRows, stripe.y1)};
            std::fill(blocksOf_.begin() + rows.y0, blocksOf_.begin() + rows.y1, int(blocks_.size()));
            blocks_.push_back({rows, next});
        }
        first += std::size_t(directions) * count;
    }
}

std::size_t ImageBoxes::countOf(const Stripes& stripes, int rank, int columns)
{
    return std::size_t(JumpBoxes::rowsOf(stripes.rows(rank))) * std::size_t(columns);
}

std::vector<RowSpan> footprintOf(const ImageBoxes& boxes, const RowSpan& stripe, const RowSpan& limits, int jumps)
{
    std::vector<RowSpan> reached(std::size_t(boxes.columns()), stripe), before;
    for (int jump = 0; jump < jumps; ++jump) {
        const std::vector<RowSpan> now = reached;  // What this jump starts from: more of it comes by the next.
        Spread spread(boxes, limits, reached);
        for (int c = 0; c < boxes.columns(); ++c) {
            const RowSpan& rows = now[std::size_t(c)];
            if (jump == 0) {
                spread.from(c, rows);
            } else {  // From where the jump before has led for the first time.
                spread.from(c, {rows.y0, before[std::size_t(c)].y0});
                spread.from(c, {before[std::size_t(c)].y1, rows.y1});
            }
        }
        before = now;
    }
    for (RowSpan& rows : reached) {
        const auto down = [](int y) { return y / JumpFootprint::kRows * JumpFootprint::kRows; };
        rows.y0 = rows.y0 < stripe.y0 ? std::max(down(rows.y0), limits.y0) : stripe.y0;
        rows.y1 = rows.y1 > stripe.y1 ? std::min(down(rows.y1 + JumpFootprint::kRows - 1), limits.y1) : stripe.y1;
    }
    return reached;
}

std::vector<JumpFootprint> shareFootprints(Communicator& communicator, const Stripes& stripes,
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
        const std::vector<RowSpan> found = footprintOf(image, {stripe.y0, stripe.y1}, limits, jumps);
        to = std::copy(found.begin(), found.end(), to);
    }
    communicator.allGatherInPlace(std::as_writable_bytes(std::span(rows)),
                                  std::vector<std::size_t>(ranks, mine * sizeof(RowSpan)));
    std::vector<JumpFootprint> reached(boxes.size(), {columns, {}});
    for (auto from = rows.begin(); from != rows.end();)
        for (JumpFootprint& direction : reached) {
            direction.rows.insert(direction.rows.end(), from, from + columns);
            from += columns;
        }
    return reached;
}

}  // namespace aeolic
