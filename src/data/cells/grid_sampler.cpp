#include "data/cells/grid_sampler.h"

#include <cmath>

#include "data/cells/cell_tree.h"
#include "data/surface_range.h"

namespace aeolic {
namespace {

glm::dvec3 cellOf(const GridField& grid, std::uint64_t cell)
{
    const auto nx = std::uint64_t(grid.dims[0] - 1), ny = std::uint64_t(grid.dims[1] - 1);
    return {double(cell % nx), double(cell / nx % ny), double(cell / nx / ny)};
}

}  // namespace

GridSampler::GridSampler(std::shared_ptr<const GridField> vectors, std::shared_ptr<const GridField> scalars)
    : vectors_(std::move(vectors)), scalars_(std::move(scalars)), bounds_(boundsOf(*vectors_))
{
}

bool GridSampler::findWithin(const glm::dvec3& pointWorld, CellPlace& place) const
{
    const double slack = 0x1p-22 * bounds_.diagonal();
    return CellTree::distanceSquared(bounds_, pointWorld) <= slack * slack && find(pointWorld, glm::dvec3(0), place);
}

bool GridSampler::find(const glm::dvec3& pointWorld, const glm::dvec3&, CellPlace& place) const
{
    if (!std::isfinite(pointWorld.x + pointWorld.y + pointWorld.z)) return false;
    const GridField& grid = *vectors_;
    place.distanceSquared = CellTree::distanceSquared(bounds_, pointWorld);
    if (place.distanceSquared > 0.25 * glm::dot(grid.spacingWorld, grid.spacingWorld)) return false;
    const glm::dvec3 cells(double(grid.dims[0] - 1), double(grid.dims[1] - 1), double(grid.dims[2] - 1));
    const glm::dvec3 at = glm::clamp((pointWorld - grid.originWorld) / grid.spacingWorld, glm::dvec3(0), cells);
    const glm::dvec3 cell = glm::min(glm::floor(at), cells - 1.0);
    place.cell = (std::uint64_t(cell.z) * std::uint64_t(cells.y) + std::uint64_t(cell.y)) * std::uint64_t(cells.x) +
                 std::uint64_t(cell.x);
    place.weights = {at.x - cell.x, at.y - cell.y, at.z - cell.z, 0};
    return true;
}

glm::dvec3 GridSampler::pointOf(const CellPlace& place) const
{
    const glm::dvec3 fraction(place.weights[0], place.weights[1], place.weights[2]);
    return vectors_->originWorld + vectors_->spacingWorld * (cellOf(*vectors_, place.cell) + fraction);
}

glm::dvec3 GridSampler::vectorAt(const CellPlace& place) const
{
    return aeolic::vectorAt(*vectors_, pointOf(place)).vector + 0.0;  // No -0, as in a sum of bricks.
}

double GridSampler::scalarAt(const CellPlace& place) const
{
    return aeolic::vectorAt(*scalars_, pointOf(place)).vector.x + 0.0;
}

double GridSampler::heightOver(const CellPlace& place, const glm::dvec3&, const glm::dvec3& normal) const
{
    return widthOf(place, normal);
}

double GridSampler::widthOf(const CellPlace&, const glm::dvec3& direction) const
{
    return glm::dot(glm::abs(direction), vectors_->spacingWorld);
}

}  // namespace aeolic
