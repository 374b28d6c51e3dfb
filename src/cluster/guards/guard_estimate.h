#pragma once

#include <vector>

#include "base/extent.h"
#include "render/guard_exchange.h"
#include "render/lic/row_flow.h"

namespace aeolic {

/// How many rows beyond a stripe its traces may read. The same on every rank, for every rank's stripe.
class GuardEstimate {
public:
    virtual ~GuardEstimate() = default;
    virtual GuardRows rows(const Extent& stripe, int steps) const = 0;
    /// Whether it goes by the vectors that are there.
    virtual bool estimates() const = 0;
};

/// The worst case (section 5.2): every step as long as the longest that any pixel could have.
class BoundReach final : public GuardEstimate {
public:
    explicit BoundReach(double maxStepPx) : maxStepPx_(maxStepPx) {}
    GuardRows rows(const Extent& stripe, int steps) const override;
    bool estimates() const override { return false; }

private:
    double maxStepPx_;
};

/// What the vectors really there allow (the paper's "more sophisticated estimates"): to cross a row takes a trace at
/// least one over the largest vertical displacement around it in steps. Never more than the worst case, and never too
/// few (docs/cluster.md has the proof).
class VectorReach final : public GuardEstimate {
public:
    /// `facts`: one for each row of the image. `levels`: TraceReach::levels. Cost: as many passes over the rows as
    /// there are rows looked at around each.
    VectorReach(const std::vector<RowFlow>& facts, double flowUnitPx, double maxStepPx, int levels);
    GuardRows rows(const Extent& stripe, int steps) const override;
    bool estimates() const override { return true; }

private:
    int rowsFrom(int row, int direction, int steps) const;

    BoundReach bound_;
    /// [height]: no trace crosses this row, up or down, in fewer steps; infinite where there is no flow around.
    std::vector<double> steps_;
};

}  // namespace aeolic
