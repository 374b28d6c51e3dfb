#include "data/cells/cell_tree.h"

#include <algorithm>
#include <numeric>

#include "base/parallel.h"

namespace aeolic {

CellTree::CellTree(std::vector<Bounds> boxes) : boxes_(std::move(boxes)), order_(boxes_.size())
{
    std::iota(order_.begin(), order_.end(), 0u);
    while ((boxes_.size() >> levels_) > kLeaf) ++levels_;
    nodes_.resize(std::size_t{2} << levels_);
    for (int level = 0; level <= levels_; ++level) {
        parallelFor(std::size_t{1} << level, [&](std::size_t i) {
            const std::size_t node = (std::size_t{1} << level) + i;
            const auto from = order_.begin() + std::ptrdiff_t(begin(node, level)),
                       to = order_.begin() + std::ptrdiff_t(begin(node + 1, level));
            Bounds all, centers;
            for (auto k = from; k != to; ++k) {
                all.add(boxes_[*k].lo);
                all.add(boxes_[*k].hi);
                centers.add(boxes_[*k].center());
            }
            nodes_[node] = all;
            if (level == levels_ || from == to) return;
            const glm::dvec3 size = centers.hi - centers.lo;
            const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            const auto middle = order_.begin() + std::ptrdiff_t(begin(2 * node + 1, level + 1));
            std::nth_element(from, middle, to, [&](std::uint32_t a, std::uint32_t b) {
                const double ca = boxes_[a].lo[axis] + boxes_[a].hi[axis], cb = boxes_[b].lo[axis] + boxes_[b].hi[axis];
                return ca != cb ? ca < cb : a < b;
            });
        });
    }
}

}  // namespace aeolic
