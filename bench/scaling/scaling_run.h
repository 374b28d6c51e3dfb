#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "aeolic/renderer.h"
#include "aeolic/scene_description.h"
#include "data/scene.h"
#include "scaling/measured_frames.h"

namespace aeolic {

/// Scenes that the same ranks draw in turn, picture by picture, each under several balancers.
struct ScalingSetup {
    /// run.bricks: whether each rank loads its own part of the field. Of as many frames and the same orbit.
    std::vector<SceneDescription> scenes;
    int ranks = 1;
    std::vector<std::string> balancers;
    int repeats = 1;         ///< Times each frame is measured; of each stage's times the least counts.
    bool besideOne = false;  ///< Also by one rank alone, where there are several. Of scenes that are not in bricks.
};

/// What was measured under one balancer: of every frame all ranks' parts, by rank.
struct BalancerSamples {
    std::vector<RanksOfFrame> rotation;  ///< scene.output.frames, turned by orbitDeg in all.
    std::vector<RanksOfFrame> jumps;     ///< First frames after the camera jumped by 90 degrees.
    std::vector<double> wallMs;          ///< Of the rotation, all ranks at once; only where there are as many cores.
};

/// Of one scene.
struct ScalingSamples {
    std::vector<BalancerSamples> of;  ///< [setup.balancers]
    /// The rotation's frames by one rank that draws them whole, each in turn with the ranks' own: a machine that is
    /// slow for a while is slow for both. Where setup.besideOne.
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
/// each would take on a node of its own (MeasuredFrames): every frame of one scene after another, of each under one
/// balancer after another, and by one rank alone. Returns one for each scene. `shared`: what scenes that are not in
/// bricks are when loaded; of others every rank loads its own part. `onFrame(scene)` is called by one rank after each
/// frame that counts.
std::vector<ScalingSamples> drawOnRanks(const ScalingSetup& setup, const Scene& shared, int cores,
                                        const std::function<void(std::size_t)>& onFrame);

}  // namespace aeolic
