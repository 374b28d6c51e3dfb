#pragma once

#include <memory>
#include <vector>

#include "render/cpu/convolve.h"
#include "render/cpu/jumps.h"
#include "render/lic_kernel.h"

namespace aeolic::cpu {

/// cos and signed sin of a number of steps times the Hann kernel's frequency.
struct Rotation {
    float cosine = 1, sine = 0;
};

/// Memory of the hierarchical method, kept between frames.
struct Hierarchy {
    std::vector<std::unique_ptr<JumpLevel>> levels;
    JumpLevel remainder;
    Image<float> lengths;
    std::vector<Rotation> rotations;   ///< [steps + 1], of the direction in work.
};

/// One direction of a convolution: what its kernels read and write.
struct HierarchicalPass {
    Hierarchy* memory;
    const JumpPlan* plan;
    JumpLevel* remainder;   ///< Null where the plan has none.
    float direction;        ///< 1 downstream, -1 upstream.
    bool hann;
    float phaseCosine, phaseSine, ownWeight;
    ContrastModel contrast;
    LicImage* out;

    JumpLevel& level(std::size_t i) const { return *memory->levels[i]; }
    const Rotation& rotation(int steps) const { return memory->rotations[std::size_t(steps)]; }
};

/// Local. The line integral by composed jumps (`--lic hierarchical`): a few direct steps, then levels of jumps, each joined
/// from the one below, then as many jumps as the kernel is long. O(log steps) look-ups, two 128-bit loads each.
/// Source: Hlawatsch, Sadlo & Weiskopf, Hierarchical Line Integration, TVCG 17(8), 2011; with mixed radices, sheets, traces
/// that carry their own length, and the Hann kernel as a complex weight (docs/hierarchical.md).
void convolveHierarchical(const GBuffer& buffer, const FlowCells& flow, const LicOptions& lic, const Extent& compute, Hierarchy& memory,
                          LicImage& out);

}  // namespace aeolic::cpu
