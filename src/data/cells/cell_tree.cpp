#include "data/cells/cell_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/parallel.h"

namespace aeolic {
namespace {

glm::vec3 centerOf(const CellTree::Box& box)
{
    return 0.5f * box.lo + 0.5f * box.hi;
}

}  // namespace

CellTree::Box CellTree::Box::around(const Bounds& exact)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr double most = std::numeric_limits<float>::max();
    const glm::dvec3 lo = glm::clamp(exact.lo, -most, most), hi = glm::clamp(exact.hi, -most, most);
    Box box{glm::vec3(lo), glm::vec3(hi)};
    for (int c = 0; c < 3; ++c) {
        if (double(box.lo[c]) > lo[c]) box.lo[c] = std::nextafter(box.lo[c], -infinity);
        if (double(box.hi[c]) < hi[c]) box.hi[c] = std::nextafter(box.hi[c], infinity);
    }
    return box;
}

CellTree::CellTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size())
{
    std::iota(order_.begin(), order_.end(), 0u);
    while ((boxes_.size() >> levels_) > kLeaf) ++levels_;
    nodes_.resize(std::size_t{2} << levels_);
    for (int level = 0; level <= levels_; ++level) {
        parallelFor(std::size_t{1} << level, [&](std::size_t i) {
            const std::size_t node = (std::size_t{1} << level) + i;
            const auto from = order_.begin() + std::ptrdiff_t(begin(node, level)),
                       to = order_.begin() + std::ptrdiff_t(begin(node + 1, level));
            constexpr float most = std::numeric_limits<float>::max();
            Box all{glm::vec3(most), glm::vec3(-most)}, centers = all;
            for (auto k = from; k != to; ++k) {
                const Box& box = boxes_[*k];
                const glm::vec3 center = centerOf(box);
                all = {glm::min(all.lo, box.lo), glm::max(all.hi, box.hi)};
                centers = {glm::min(centers.lo, center), glm::max(centers.hi, center)};
            }
            nodes_[node] = all;
            if (level == levels_ || from == to) return;
            const glm::vec3 size = centers.hi - centers.lo;
            const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            const auto middle = order_.begin() + std::ptrdiff_t(begin(2 * node + 1, level + 1));
            std::nth_element(from, middle, to, [&](std::uint32_t a, std::uint32_t b) {
                const float ca = centerOf(boxes_[a])[axis], cb = centerOf(boxes_[b])[axis];
                return ca != cb ? ca < cb : a < b;
            });
        });
    }
}

}  // namespace aeolic
