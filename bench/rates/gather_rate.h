#pragma once

#include <cstddef>

namespace aeolic::cpu {

/// Lanes of 32 bits per second.
struct LaneRate {
    double oneThread = 0, allThreads = 0;
};

/// How fast this machine fetches scattered words when nothing else is to be done: what the LIC stage is measured
/// against.
struct GatherRates {
    LaneRate gather;  ///< The 32-bit gather instruction; where the processor has none, its replacement.
    LaneRate blocks;  ///< What the tracer does instead: plain 128-bit loads, joined and transposed (loadBlocks).
};

/// The working set of a tile's traces: about what a kernel of 128 steps reaches from it.
inline constexpr std::size_t kGatherSetBytes = std::size_t{1} << 20;

/// Local. Measures both, on one thread and on the `threads` of the current arena. The fastest of `repeats` runs counts,
/// because other work on the machine can only slow it down. Addresses are those of streamlines: neighbouring lanes read
/// neighbouring pixels, all move by a pixel a step, a step to the right and one down in turn, and start again a vector
/// further after 128 steps. No address depends on a loaded value, so that this is a rate and not a latency. Cost: about
/// 6 ms a repeat.
inline constexpr int kGatherRepeats = 60;
GatherRates measureGatherRates(int threads, int repeats = kGatherRepeats);

}  // namespace aeolic::cpu
