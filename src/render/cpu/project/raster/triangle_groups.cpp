#include "render/cpu/project/raster/triangle_groups.h"

#include <limits>

#include "base/parallel.h"

namespace aeolic::cpu {
namespace {

TriangleGroup groupOf(const SurfaceMesh& mesh, float perUnit, std::size_t begin, std::size_t end)
{
    constexpr float kFar = std::numeric_limits<float>::infinity();
    glm::vec3 lo(kFar), hi(-kFar);
    std::uint32_t first = std::numeric_limits<std::uint32_t>::max(), last = 0;
    for (std::size_t i = begin; i < end; ++i)
        for (const std::uint32_t point : mesh.triangles[i]) {
            lo = glm::min(lo, mesh.positions[point]);
            hi = glm::max(hi, mesh.positions[point]);
            first = std::min(first, point);
            last = std::max(last, point);
        }
    return {perUnit * lo, perUnit * hi, std::uint32_t(first / kBlockPoints), std::uint32_t(last / kBlockPoints)};
}

/// Along an axis of the view.
struct Span {
    double lo, hi;
};

Span spanOf(const TriangleGroup& group, const View& view, const glm::dvec3& axis)
{
    const glm::dvec3 lo(group.loLocal), hi(group.hiLocal);
    const double middle = glm::dot(0.5 * (lo + hi) - glm::dvec3(view.eyeLocal), axis),
                 half = 0.5 * glm::dot(hi - lo, glm::abs(axis));
    return {middle - half, middle + half};
}

bool mayShow(const TriangleGroup& group, const View& view, const Extent& extent)
{
    const Span depth = spanOf(group, view, glm::dvec3(view.forward));
    // Vertices are transformed in single precision: what touches the near plane may lie on either side of it.
    const double near = view.nearDepth, room = 1e-4 * near;
    if (depth.hi < near - room) return false;
    if (depth.lo < near + room) return true;
    const auto shows = [&](const Span& across, double centerPx, int begin, int end) {
        // Nearer is farther out on the image. A pixel more for rounding.
        const double lower = across.lo / (across.lo < 0 ? depth.lo : depth.hi),
                     upper = across.hi / (across.hi > 0 ? depth.lo : depth.hi);
        return centerPx + double(view.focalPx) * upper > begin - 1 && centerPx + double(view.focalPx) * lower < end + 1;
    };
    return shows(spanOf(group, view, glm::dvec3(view.right)), double(view.centerX), extent.x0, extent.x1) &&
           shows(spanOf(group, view, -glm::dvec3(view.up)), double(view.centerY), extent.y0, extent.y1);
}

}  // namespace

std::vector<TriangleGroup> groupTriangles(const SurfaceMesh& mesh, double unitWorld)
{
    const std::size_t triangles = mesh.triangles.size();
    std::vector<TriangleGroup> groups((triangles + kGroupTriangles - 1) / kGroupTriangles);
    parallelRanges(groups.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t g = begin; g < end; ++g)
            groups[g] = groupOf(mesh, float(1 / unitWorld), g * kGroupTriangles,
                                std::min((g + 1) * kGroupTriangles, triangles));
    });
    return groups;
}

void VisibleGroups::find(const std::vector<TriangleGroup>& groups, std::size_t triangles, const View& view,
                         const Extent& extent, const GroupPart& part)
{
    triangles_ = triangles;
    seen_.resize(groups.size());
    constexpr std::size_t kDealt = GroupPart::kDealt;
    parallelRanges((groups.size() + kDealt - 1) / kDealt, 32, [&](std::size_t begin, std::size_t end) {
        for (std::size_t deal = begin; deal < end; ++deal) {
            const bool has = part.has(deal);
            for (std::size_t g = deal * kDealt; g < std::min((deal + 1) * kDealt, groups.size()); ++g)
                seen_[g] = has && mayShow(groups[g], view, extent);
        }
    });
    std::uint32_t blocks = 0;
    for (const TriangleGroup& group : groups) blocks = std::max(blocks, group.lastBlock + 1);
    blocks_.assign(blocks, 0);
    for (std::size_t g = 0; g < groups.size(); ++g)
        if (seen_[g]) std::fill(blocks_.begin() + groups[g].firstBlock, blocks_.begin() + groups[g].lastBlock + 1, 1);
}

}  // namespace aeolic::cpu
