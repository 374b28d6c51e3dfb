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
    /// All have the same frames and the same orbit. run.bricks says whether each rank loads its own part of the field.
    std::vector<SceneDescription> scenes;
    int ranks = 1;
    std::vector<std::string> balancers;
    int repeats = 1;         ///< Times each frame is measured; in each stage the least of a rank's times counts.
    bool besideOne = false;  ///< Several ranks: one rank alone draws the frames too. Not for scenes in bricks.
};

/// The measurements under one balancer: all ranks' parts of every frame.
struct BalancerSamples {
    std::vector<RanksOfFrame> rotation;  ///< scene.output.frames, turned by the orbit in all.
    std::vector<RanksOfFrame> jumps;     ///< First frames after the camera jumped by 90 degrees.
    std::vector<double> wallMs;          ///< The rotation by all ranks at once; only where there are as many cores.
};

/// The measurements of one scene.
struct ScalingSamples {
    std::vector<BalancerSamples> of;  ///< [setup.balancers]
    /// The rotation's frames by one rank that draws them whole, each in turn with the ranks' own: a machine that is
    /// slow for a while is slow for both. Empty without setup.besideOne.
    std::vector<RanksOfFrame> alone;
    std::vector<double> aloneWallMs;  ///< Wall times of that one rank, in turn with wallMs.
};

/// Frames drawn before those that count: memory is there then, and balancers that look back have something to look at.
inline constexpr int kWarmUpFrames = 3;

/// Turns by 90 degrees, each from a view on which balancers had some frames to settle.
inline constexpr int kJumps = 4, kSettlingFrames = 2;

/// Frames after a jump are measured so many times as often as others, because the worst of these few is shown.
inline constexpr int kJumpRepeats = 2;

/// Draws the rotation and the jumps on ranks that are threads of this process, each with one thread, and measures what
/// each would take on a node of its own (MeasuredFrames). A frame is drawn for one scene after another, under one
/// balancer after another, and then by one rank alone. Returns the samples of each scene. `shared` is the loaded scene
/// of all that are not in bricks; of one in bricks every rank loads its own part. `onFrame(scene)` is called by one
/// rank after each frame that counts.
std::vector<ScalingSamples> drawOnRanks(const ScalingSetup& setup, const Scene& shared, int cores,
                                        const std::function<void(std::size_t)>& onFrame);

}  // namespace aeolic
