#include "data/cells/left_out.h"

#include <algorithm>
#include <atomic>

#include "base/parallel.h"

namespace aeolic {
namespace {

/// Cells side by side in a file that are in more boxes than this count as anywhere.
constexpr double kMostBoxes = 1 << 12;

void lower(double& least, double diagonal)
{
    const std::atomic_ref shared(least);
    double known = shared.load(std::memory_order_relaxed);
    while (diagonal < known && !shared.compare_exchange_weak(known, diagonal, std::memory_order_relaxed)) {
    }
}

}  // namespace

void LeftOut::add(const glm::dvec3& middle, double diagonal)
{
    lower(diagonals_.empty() ? anywhere_ : diagonals_[boxes_.indexOf(middle)], diagonal);
}

void LeftOut::add(const CellTree::Box& middles, double leastDiagonal)
{
    const Bounds bounds{glm::dvec3(middles.lo), glm::dvec3(middles.hi)};
    if (diagonals_.empty() || boxes_.countIn(bounds) > kMostBoxes) return addAnywhere(leastDiagonal);
    boxes_.forEachIn(bounds, [&](std::size_t box) { lower(diagonals_[box], leastDiagonal); });
}

void LeftOut::addAnywhere(double leastDiagonal)
{
    lower(anywhere_, leastDiagonal);
}

double LeftOut::least() const
{
    double least = anywhere_;
    for (const double diagonal : diagonals_) least = std::min(least, diagonal);
    return least;
}

double LeftOut::leastIn(const Bounds& box) const
{
    double least = anywhere_;
    if (!diagonals_.empty()) boxes_.forEachIn(box, [&](std::size_t i) { least = std::min(least, diagonals_[i]); });
    return least;
}

bool LeftOut::mayLack(const SurfaceMesh& mesh, const std::vector<double>& reach, double diagonals) const
{
    constexpr double aHairMore = 1 + 1e-6;
    // A cell at least as large as `enough` within the reach and its own diagonal is within `diagonals` of its own. Any
    // other one is nearer than the reach and `enough`.
    const double all = least(), timesReach = aHairMore / (diagonals - 1);
    std::atomic<bool> lacks = false;
    parallelRanges(mesh.triangles.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && !lacks; ++i) {
            Bounds box;
            double most = 0;
            for (const std::uint32_t corner : mesh.triangles[i]) {
                box.add(mesh.originWorld + glm::dvec3(mesh.positions[corner]));
                most = std::max(most, reach[corner]);
            }
            const double enough = timesReach * most;
            if (enough <= all) continue;
            const glm::dvec3 around(aHairMore * most + enough);
            if (leastIn({box.lo - around, box.hi + around}) < enough) lacks = true;
        }
    });
    return lacks;
}

}  // namespace aeolic
