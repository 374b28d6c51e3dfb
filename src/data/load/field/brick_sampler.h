#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "data/cells/grid_sampler.h"
#include "data/load/agreement.h"

namespace aeolic {

/// Looks values up in a uniform grid of which every rank holds a brick, to the bit as GridSampler does in the whole.
///
/// It is asked twice for the same. At first no value is known (NaN), and the places that were asked for are kept. Then
/// ask() brings their values from the ranks that own them, and the second time they are known. The second time may ask
/// for fewer places, but for no others. That suits a search that goes on from place to place.
class BrickSampler final : public GridSampler {
public:
    /// `scalars`: null where there is none. `longest`: of the vectors of all bricks.
    BrickSampler(std::shared_ptr<const GridField> vectors, std::shared_ptr<const GridField> scalars, double longest);

    glm::dvec3 vectorAt(const CellPlace& place) const override;
    double scalarAt(const CellPlace& place) const override;
    double maxVector() const override { return longest_; }

    /// Collective. `samePlaces`: every rank asked for the same ones. Cost: 32 bytes for each place that any rank asked
    /// for, on every rank; unless they are the same, 24 more.
    void ask(Agreement& agreement, bool samePlaces);

private:
    using Values = std::array<double, 4>;  // The vector and the scalar.
    Values valuesAt(const CellPlace& place) const;
    Values ownValuesAt(const glm::dvec3& pointWorld) const;

    double longest_;
    mutable std::mutex asking_;
    mutable std::vector<glm::dvec3> places_;  // Sorted once they are known.
    std::vector<Values> known_;               // [places]
    bool answers_ = false;
};

}  // namespace aeolic
