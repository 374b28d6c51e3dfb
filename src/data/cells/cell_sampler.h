#pragma once

#include <memory>

#include "data/cells/cell_tree.h"
#include "data/cells/volume_cells.h"
#include "data/cells/volume_sampler.h"

namespace aeolic {

/// Looks values up in cells of any shape. Of several cells that hold a point, or are equally near, the one with the
/// lowest number is taken.
class CellSampler final : public VolumeSampler {
public:
    explicit CellSampler(std::shared_ptr<const VolumeCells> cells);

    bool findWithin(const glm::dvec3& pointWorld, CellPlace& place) const override;
    bool find(const glm::dvec3& pointWorld, CellPlace& place) const override;
    glm::dvec3 vectorAt(const CellPlace& place) const override;
    double scalarAt(const CellPlace& place) const override;
    glm::dvec3 centerOf(const CellPlace& place) const override;
    double widthOf(const CellPlace& place, const glm::dvec3& direction) const override;
    const Bounds& bounds() const override { return tree_.bounds(); }
    double maxVector() const override { return cells_->maxVector; }

private:
    std::shared_ptr<const VolumeCells> cells_;
    CellTree tree_;
};

}  // namespace aeolic
