#include "data/cells/cell_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.h"

namespace aeolic {
namespace {

constexpr float kMost = std::numeric_limits<float>::max();
const CellTree::Box kNone{glm::vec3(kMost), glm::vec3(-kMost)};

CellTree::Box united(const CellTree::Box& a, const CellTree::Box& b)
{
    return {glm::min(a.lo, b.lo), glm::max(a.hi, b.hi)};
}

}  // namespace

CellTree::Box CellTree::Box::around(const Bounds& exact)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const glm::dvec3 lo = glm::clamp(exact.lo, -double(kMost), double(kMost)),
                     hi = glm::clamp(exact.hi, -double(kMost), double(kMost));
    Box box{glm::vec3(lo), glm::vec3(hi)};
    for (int c = 0; c < 3; ++c) {
        if (double(box.lo[c]) > lo[c]) box.lo[c] = std::nextafter(box.lo[c], -infinity);
        if (double(box.hi[c]) < hi[c]) box.hi[c] = std::nextafter(box.hi[c], infinity);
    }
    return box;
}

CellTree::CellTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size())
{
    while ((boxes_.size() >> levels_) > kLeaf) ++levels_;
    leaves_ = std::size_t{1} << levels_;
    sortBoxes();
    nodes_.resize(2 * leaves_);
    parallelFor(leaves_, [&](std::size_t i) {
        const std::size_t node = leaves_ + i;
        nodes_[node] = kNone;
        for (std::size_t k = begin(node, levels_); k < begin(node + 1, levels_); ++k)
            nodes_[node] = united(nodes_[node], boxes_[k]);
    });
    for (std::size_t node = leaves_ - 1; node > 0; --node)
        nodes_[node] = united(nodes_[2 * node], nodes_[2 * node + 1]);
}

/// Level by level, the boxes of each node are halved across their longest side, at the median of their centres.
void CellTree::sortBoxes()
{
    struct Item {
        glm::vec3 center;
        std::uint32_t box;
    };
    std::vector<Item> items(boxes_.size());  // Side by side in memory: the medians take most of the time.
    parallelRanges(items.size(), 4096, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i)
            items[i] = {0.5f * boxes_[i].lo + 0.5f * boxes_[i].hi, std::uint32_t(i)};
    });
    for (int level = 0; level < levels_; ++level) {
        parallelFor(std::size_t{1} << level, [&](std::size_t i) {
            const std::size_t node = (std::size_t{1} << level) + i;
            const auto at = [&](std::size_t k) { return items.begin() + std::ptrdiff_t(k); };
            const auto from = at(begin(node, level)), to = at(begin(node + 1, level));
            Box centers = kNone;
            for (auto item = from; item != to; ++item) centers = united(centers, {item->center, item->center});
            const glm::vec3 size = centers.hi - centers.lo;
            const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            std::nth_element(from, at(begin(2 * node + 1, level + 1)), to, [axis](const Item& a, const Item& b) {
                return a.center[axis] != b.center[axis] ? a.center[axis] < b.center[axis] : a.box < b.box;
            });
        });
    }
    std::vector<Box> sorted(boxes_.size());
    parallelRanges(items.size(), 4096, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            order_[i] = items[i].box;
            sorted[i] = boxes_[items[i].box];
        }
    });
    boxes_ = std::move(sorted);
}

}  // namespace aeolic
