#pragma once

#include <array>
#include <cstdint>

#include <vector>

#include "base/image.h"
#include "render/cpu/lic/flow_cells.h"
#include "render/guard_exchange.h"
#include "render/lic/fresh_rows.h"
#include "render/lic/jump_plan.h"
#include "render/lic/lic_kernel.h"

namespace aeolic::cpu {

/// Where the streamline of each pixel is after `stride` steps in one direction, and the noise summed on the way: the
/// hierarchy's φ_k and S_k (Hlawatsch, Sadlo & Weiskopf 2011). 64 bits a pixel, so that a 128-bit load brings two
/// neighbours:
///   bits  0 … 15  displacement in x, signed, in `units.displacementPx`
///   bits 16 … 31  displacement in y
///   bit  32       the pixel and its neighbours are linked to all eight neighbours each
///   bit  33       the trace walked all its steps and may go on
///   bits 34 … 43  pixels walked, weighted by the stream tube's width, in `units.lengthPx`
///   bits 44 … 55  sum of noise bytes times those pixels, signed, in `units.sum`
///   bits 56 … 63  the tube's width at the end, in 255ths of that at the start
struct JumpLevel {
    Image<std::uint64_t> jumps;
    Image<std::uint32_t> weighted;  ///< The two sums weighted by the kernel's pair, 16 bits each, where it has one.
    int stride = 0;
    JumpUnits units{1, 1, 1, 1};
};

/// The jumps in one direction, and what their steps make of weighted sums.
struct JumpHierarchy {
    float sign = 1;  ///< 1 downstream, -1 upstream.
    std::vector<JumpLevel> levels;
    JumpLevel remainder;
    std::vector<Turn> turns;  ///< turnsOf() the kernel.
};

/// Memory of the hierarchical method, kept between frames.
struct Hierarchy {
    std::array<JumpHierarchy, 2> directions;
    JumpPlan plan;
};

/// What the kernels of one convolution read and write.
struct HierarchicalPass {
    GBuffer& buffer;
    const NearFlow& near;
    Hierarchy& memory;
    KernelModel kernel;
    float ownWeight;  ///< The kernel's weight at the pixel itself.
    Streaks streaks;
    ContrastModel contrast;
    LicImage& out;
};

/// Local. Walks the first steps from each pixel of a tile one by one: the lowest level, and the remainder's.
void walkDirectTile(const HierarchicalPass& pass, const FlowCells& flow, const Extent& tile);

/// Local. Joins jumps of level `from` to one of the next for each pixel of a tile.
void joinJumpsTile(const HierarchicalPass& pass, std::size_t from, const Extent& tile);

/// Local. The kernel's whole length for each pixel of a tile: its LIC values.
void finishTile(const HierarchicalPass& pass, const Extent& tile);

/// Boxes without jumps for the stripe `own`, to be filled tile by tile.
JumpBoxes emptyBoxes(const JumpLevel& level, const Extent& own);

/// Local. Those of a tile of `own`, of whole blocks but for the stripe's ends; x0 of the image is 0. `near`: where
/// jumps have been written. One pass over them, best while a cache has them.
void addBoxes(const JumpLevel& level, const NearFlow& near, const Extent& own, const Extent& tile, JumpBoxes& boxes);

/// Local. The line integral by composed jumps (`--lic hierarchical`): a few direct steps, then levels of jumps, each
/// joined from the one below, then as many jumps as the kernel is long. O(log steps) look-ups, two 128-bit loads each.
/// Source: Hlawatsch, Sadlo & Weiskopf, Hierarchical Line Integration, TVCG 17(8), 2011; with mixed radices, sheets,
/// traces that carry their own length, and the Hann kernel as a complex weight (docs/hierarchical.md).
///
/// Without `guards` the levels are computed wherever `buffer` is valid. With them Collective: each level is computed in
/// `compute` alone and then received around it as far as it is looked up, and `buffer`'s links with it; `flow` and
/// links being right as far as `direct` steps reach. `near`: of at least the rows where levels are computed. Without
/// guards, jumps that follow from rows before the fresh ones alone stay.
void convolveHierarchical(GBuffer& buffer, const FlowCells& flow, const NearFlow& near, const LicOptions& lic,
                          const Extent& compute, GuardExchange* guards, const FreshRows& fresh, Hierarchy& memory,
                          LicImage& out);

}  // namespace aeolic::cpu
