#pragma once

#include <cstdint>
#include <vector>

#include "aeolic/scene_description.h"
#include "render/gbuffer.h"
#include "render/lic/jump_plan.h"

namespace aeolic::cpu {

/// Counts what the LIC stage fetches for one trace (one pixel, one direction), in lanes of 32 bits: a sample of the
/// flow is one 128-bit block, 4 lanes; a jump looked up is two blocks, and with weighted sums 4 gathered pairs. What
/// it reads in a row (the pixel's own texel, its first jump) or only at silhouettes (links) is not counted.
class TraceLanes {
public:
    explicit TraceLanes(const LicOptions& lic);

    /// Lanes for a trace that ends after `walkedSteps` of the kernel's steps. The step it cannot take is looked at too.
    std::int64_t of(int walkedSteps) const;

    /// Lanes for a trace that never ends early: no trace fetches more.
    std::int64_t most() const { return of(steps_); }

private:
    LicMethod method_;
    int steps_, samplesPerStep_, lanesPerJump_;
    JumpPlan plan_;  ///< Used by the hierarchical method alone.
};

/// How many steps traces walk before they end at a silhouette, a sink or the image's border, at most `steps`: in both
/// directions from about `count` pixels with flow, spread evenly over the image. An estimate for statistics alone: it
/// takes whole pixels and first order, while the LIC stage interpolates. Cost: about 10 ns a step.
std::vector<int> sampleWalkedSteps(const GBuffer& buffer, int steps, int count);

}  // namespace aeolic::cpu
