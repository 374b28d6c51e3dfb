#pragma once

#include <functional>
#include <string>
#include <vector>

#include "aeolic/renderer.h"
#include "aeolic/scene_description.h"
#include "data/scene.h"
#include "pipeline/measured_frames.h"

namespace aeolic {

/// One scene on so many ranks, under several balancers.
struct ScalingSetup {
    SceneDescription scene;  ///< scene.run.bricks: whether each rank loads its own part of the field.
    int ranks = 1;
    std::vector<std::string> balancers;
    int repeats = 1;  ///< Times each frame is measured; of each stage's times the least counts.
};

/// What was measured under one balancer: of every frame all ranks' parts, by rank.
struct BalancerSamples {
    std::vector<RanksOfFrame> rotation;  ///< scene.output.frames, turned by orbitDeg in all.
    std::vector<RanksOfFrame> jumps;     ///< First frames after the camera jumped by 90 degrees.
    std::vector<double> wallMs;          ///< Of the rotation, all ranks at once; only where there are as many cores.
};

struct ScalingSamples {
    std::vector<BalancerSamples> of;  ///< [setup.balancers]
    /// The rotation's frames by one rank that draws them whole, each in turn with the ranks' own: a machine that is
    /// slow for a while is slow for both. Only where ranks share a scene.
    std::vector<RanksOfFrame> alone;
    std::vector<double> aloneWallMs;  ///< Likewise, in turn with wallMs.
};

/// Frames drawn before those that count: memory is there, and balancers that look back have something to look at.
inline constexpr int kWarmUpFrames = 3;

/// Turns by 90 degrees, each from a view that balancers had some frames to settle on.
inline constexpr int kJumps = 4, kSettlingFrames = 2;

/// Each measured so many times as often as others: of a few frames the worst tells.
inline constexpr int kJumpRepeats = 2;

/// Draws the rotation and the jumps on ranks that are threads of this process, each with one thread, and measures what
/// each would take on a node of its own (MeasuredFrames): every frame under one balancer after another, and by one rank
/// alone. `shared`: the loaded scene, or null where every rank is to load its own. `onFrame` is called by one rank
/// after each frame that counts.
ScalingSamples drawOnRanks(const ScalingSetup& setup, const Scene* shared, int cores,
                           const std::function<void()>& onFrame);

}  // namespace aeolic
