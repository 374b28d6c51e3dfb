#pragma once

#include <memory>

#include "data/cells/volume_sampler.h"
#include "data/vector_field.h"

namespace aeolic {

/// Looks values up in a uniform grid that is whole in memory, trilinearly. (BrickSampler does so in one that is not.)
class GridSampler : public VolumeSampler {
public:
    /// `scalars`: null where there is none.
    GridSampler(std::shared_ptr<const GridField> vectors, std::shared_ptr<const GridField> scalars);

    bool findWithin(const glm::dvec3& pointWorld, CellPlace& place) const override;
    bool find(const glm::dvec3& pointWorld, const glm::dvec3& towards, CellPlace& place) const override;
    glm::dvec3 vectorAt(const CellPlace& place) const override;
    double scalarAt(const CellPlace& place) const override;
    glm::dvec3 pointOf(const CellPlace& place) const override;
    double heightOver(const CellPlace& place, const glm::dvec3& pointWorld, const glm::dvec3& normal) const override;
    double widthOf(const CellPlace& place, const glm::dvec3& direction) const override;
    const Bounds& bounds() const override { return bounds_; }
    double maxVector() const override { return vectors_->maxMagnitude; }

protected:
    std::shared_ptr<const GridField> vectors_, scalars_;

private:
    Bounds bounds_;
};

}  // namespace aeolic
