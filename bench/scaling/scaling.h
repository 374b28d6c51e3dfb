#pragma once

#include <optional>
#include <string>
#include <vector>

#include "aeolic/renderer.h"
#include "aeolic/scene_description.h"
#include "cluster/balance/network_model.h"
#include "common/measuring.h"
#include "scaling/critical_path.h"
#include "scaling/simulation.h"

namespace aeolic {

/// Which of the measurements of bachthaler2006parallel, section 7, a row repeats.
enum class ScalingPart {
    nodes,   ///< Table 1: every number of ranks, every balancer, the whole field on each rank.
    bricks,  ///< The most ranks: the whole field on each, the same field in bricks, and a large field in bricks.
    mesh     ///< Figure 6: a finer surface in the large field.
};

struct ScalingBenchPlan {
    /// The scene of `nodes`. Its frames and orbit are the rotation. Its choice of a balancer and of a backend is not
    /// used, and each rank computes with one thread.
    SceneDescription scene;
    std::vector<int> ranks{1, 2, 3, 4, 5, 6, 7, 8};
    std::vector<std::string> balancers{"static", "timing", "pixels", "hybrid"};
    std::vector<ScalingPart> parts{ScalingPart::nodes, ScalingPart::bricks, ScalingPart::mesh};
    std::string largeField = "abc:512,512,512";
    std::string mesh = "torus:25000";
    int repeats = 3;  ///< Times every frame is measured; in each stage the least of a rank's times counts.
    NetworkModel network;
    bool fillWide = false;  ///< Whether filling() zooms the picture.
    bool simulate = false;  ///< Also clusters that are not there, in the scene's size and in kSimulatedSize squared.
};

inline constexpr int kSimulatedSize = 16384;

/// The built-in flow that `field` names, on 512 samples a side; abc where it names none.
std::string defaultLargeField(const std::string& field);

/// One scene on so many ranks under one balancer. Times are milliseconds, medians over the frames of the rotation.
struct ScalingRow {
    ScalingPart part = ScalingPart::nodes;
    std::string surface, field;
    bool bricked = false;
    int ranks = 1;
    std::string balance;

    double totalMs = 0;            ///< Critical path with plan.network.
    double paperNetworkMs = 0;     ///< Critical path with kPaperNetwork.
    double cpuMs = 0;              ///< CPU time of all ranks together.
    std::optional<double> wallMs;  ///< Wall time, all ranks at once; none where there are fewer cores than ranks.

    /// How much faster than one rank alone. That one draws the same pictures in turn with these ranks, so that what
    /// slows the machine for a while slows both: the median, over the pictures, of its time by theirs. None but in
    /// `nodes` with several ranks.
    std::optional<double> speedup, paperNetworkSpeedup, wallSpeedup;
    std::optional<double> work;  ///< All ranks' CPU time by that of the one, compared in the same way.

    /// How much slower than the scene in the rows before, which is drawn in turn with it: the median, over the
    /// pictures, of its time by that one's. None but in `bricks` from the second scene on.
    std::optional<double> slowdown;

    double loadBalance = 1;         ///< Mean busy / max busy.
    std::vector<double> afterJump;  ///< Mean busy / max busy in the first frame after each of some turns by 90 degrees.
    std::vector<RankStats> ofRanks;  ///< All ranks in the frame whose critical path is the median.
    CriticalPath path;               ///< The critical path of that frame, with plan.network.
};

struct ScalingBench {
    std::string backend, device, simd;
    int cores = 1;
    std::vector<std::string> warnings;  ///< About the scenes, one line each.
    std::vector<ScalingRow> rows;  ///< By part, then scene, then ranks, then balancer. One rank: only once, "static".

    // What `nodes` tells, once all its rows are there.
    /// What the frames cost; the simulation goes by it. None where `nodes` is not measured.
    std::optional<MeasuredCosts> costs;
    /// How steady the machine was: one rank draws the same pictures beside each number of ranks, and this is the most
    /// it took by the least. None where there are no two to compare.
    std::optional<double> steadiness;

    std::vector<ScalingSimulation> simulations;  ///< Where asked for.

    /// The row of one rank in `nodes`. Null where that is not measured.
    const ScalingRow* oneRank() const;
};

/// Ranks are threads of this process that compute one at a time, so that no rank's time is another's noise; times are
/// their own CPU times. Throws InputError for a scene that is not valid, cannot be loaded or does not fit the
/// memory.
ScalingBench benchScaling(const ScalingBenchPlan& plan, const Watch<ScalingBench>& watch = {});

}  // namespace aeolic
