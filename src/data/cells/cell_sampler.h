#pragma once

#include <memory>
#include <span>
#include <utility>

#include "data/cells/cell_tree.h"
#include "data/cells/volume_cells.h"
#include "data/cells/volume_sampler.h"

namespace aeolic {

/// Looks values up in cells of any shape. Of several cells that hold a point, or else are equally near, the one with
/// the lowest number is taken.
class CellSampler final : public VolumeSampler {
public:
    explicit CellSampler(std::shared_ptr<const VolumeCells> cells);

    /// Samples some cells of a volume with these bounds, perhaps none.
    CellSampler(std::shared_ptr<const VolumeCells> cells, const Bounds& ofVolume);

    bool findWithin(const glm::dvec3& pointWorld, CellPlace& place) const override;
    bool find(const glm::dvec3& pointWorld, const glm::dvec3& towards, CellPlace& place) const override;
    glm::dvec3 vectorAt(const CellPlace& place) const override;
    double scalarAt(const CellPlace& place) const override;
    glm::dvec3 pointOf(const CellPlace& place) const override;
    double heightOver(const CellPlace& place, const glm::dvec3& pointWorld, const glm::dvec3& normal) const override;
    double meanDistanceOfCenters(const glm::dvec3& pointWorld, const glm::dvec3& towards) const override;
    double reachOfCenters(const glm::dvec3& pointWorld, const glm::dvec3& towards) const override;
    double widthOf(const CellPlace& place, const glm::dvec3& direction) const override;
    const Bounds& bounds() const override { return bounds_; }
    double maxVector() const override { return cells_->maxVector; }
    bool meansOfCells() const override { return cells_->meansOfCells; }

private:
    using Ranked = std::pair<bool, std::uint32_t>;  // Not on the side that is preferred, and the cell.
    bool findAmong(std::span<const Ranked> cells, const glm::dvec3& point, CellPlace& place) const;
    bool findBest(const glm::dvec3& point, const glm::dvec3& towards, CellPlace& place) const;

    std::shared_ptr<const VolumeCells> cells_;
    CellTree tree_;
    Bounds bounds_;
    double slackWorld_;
};

}  // namespace aeolic
