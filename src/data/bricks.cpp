#include "data/bricks.h"

#include <algorithm>

#include "data/vector_field.h"

namespace aeolic {
namespace {

constexpr int kNoAxis = -1;

/// The side with the most cells, if it can be cut. Among equal sides the last: a cut across z leaves whole layers of
/// the file together.
int axisToCut(const Brick& box)
{
    int longest = kNoAxis;
    std::int64_t most = 2;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t cells = box.cellHi[std::size_t(axis)] - box.cellLo[std::size_t(axis)];
        if (cells < most) continue;
        longest = axis;
        most = cells;
    }
    return longest;
}

}  // namespace

GridIndex Brick::sampleDims() const
{
    if (empty()) return {0, 0, 0};
    return {cellHi[0] - cellLo[0] + 1, cellHi[1] - cellLo[1] + 1, cellHi[2] - cellLo[2] + 1};
}

std::int64_t Brick::sampleCount() const
{
    const GridIndex dims = sampleDims();
    return dims[0] * dims[1] * dims[2];
}

bool Brick::counts(const GridIndex& sample, const GridIndex& dims) const
{
    return owns({std::min(sample[0], dims[0] - 2), std::min(sample[1], dims[1] - 2), std::min(sample[2], dims[2] - 2)});
}

Brick Brick::grown(const GridIndex& dims) const
{
    if (empty()) return *this;
    Brick larger = *this;
    for (std::size_t a = 0; a < 3; ++a) {
        larger.cellLo[a] = std::max<std::int64_t>(cellLo[a] - 1, 0);
        larger.cellHi[a] = std::min(cellHi[a] + 1, dims[a] - 1);
    }
    return larger;
}

std::int64_t CountedSamples::count() const
{
    std::int64_t samples = own.empty() ? 0 : 1;
    for (std::size_t a = 0; a < 3; ++a) {
        const std::int64_t top = own.cellHi[a] == dims[a] - 1 ? dims[a] : own.cellHi[a];
        samples *= std::max<std::int64_t>(std::min(top, first[a] + held[a]) - std::max(own.cellLo[a], first[a]), 0);
    }
    return samples;
}

BrickTree::BrickTree(const GridIndex& dims, int ranks) : bricks_(std::size_t(ranks))
{
    root_ = split({{0, 0, 0}, {dims[0] - 1, dims[1] - 1, dims[2] - 1}}, 0, ranks);
}

int BrickTree::split(const Brick& box, int firstRank, int ranks)
{
    const int axis = ranks > 1 ? axisToCut(box) : kNoAxis;
    if (axis == kNoAxis) {  // One rank, or one cell: further ranks get nothing.
        bricks_[std::size_t(firstRank)] = box;
        return ~firstRank;
    }
    const auto a = std::size_t(axis);
    const int firstRanks = (ranks + 1) / 2;
    const std::int64_t lo = box.cellLo[a], hi = box.cellHi[a];
    // Rounded to the nearest plane, and never so that a half would be empty.
    const std::int64_t cut = std::clamp(lo + ((hi - lo) * firstRanks * 2 + ranks) / (2 * ranks), lo + 1, hi - 1);

    Brick first = box, second = box;
    first.cellHi[a] = second.cellLo[a] = cut;
    const auto node = nodes_.size();
    nodes_.push_back({axis, cut, {}});
    const int firstChild = split(first, firstRank, firstRanks);
    const int secondChild = split(second, firstRank + firstRanks, ranks - firstRanks);
    nodes_[node].child = {firstChild, secondChild};
    return int(node);
}

Brick brickOf(const GridField& field, const FieldPart& part)
{
    return BrickTree(field.dims, part.ranks).brick(part.rank);
}

int BrickTree::ownerOf(const GridIndex& cell) const
{
    int at = root_;
    while (at >= 0) {
        const Node& node = nodes_[std::size_t(at)];
        at = node.child[cell[std::size_t(node.axis)] < node.cut ? 0 : 1];
    }
    return ~at;
}

}  // namespace aeolic
