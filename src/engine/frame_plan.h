#pragma once

#include "base/extent.h"
#include "cluster/balance/balancer.h"
#include "cluster/balance/frame_costs.h"
#include "render/lic/jump_plan.h"

namespace aeolic {

/// The rows one rank has to do with in a frame.
struct FrameRows {
    Extent stripe;  ///< Convolved and shaded here.
    Extent drawn;   ///< Projected here: the stripe, and its guard where that is drawn again.
    Extent valid;   ///< What traces read at most.
    Extent read;    ///< What traces read as far as is known; `valid` until guards() knows better.
};

/// Which rank draws which rows of a frame, and all else that is needed until it is finished.
struct FramePlan {
    FrameRows rows;  ///< This rank's.
    Stripes stripes;
    int width = 0, guardRows = 0;
    int edgeRows = 0;  ///< Rows next to the stripe that shading reads.
    GuardSource source = GuardSource::project;
    double maxStepPx = 0, flowUnitPx = 1;
    TraceReach reach;      ///< The LIC method's.
    StripeCosts costs;     ///< What the balancer reckoned with.
    RowCoverage coverage;  ///< Empty where the balancer needed none.
    bool again = false;    ///< It is that of the frame before, whose sums are used again.
};

}  // namespace aeolic
