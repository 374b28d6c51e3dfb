#pragma once

#include <optional>
#include <string>
#include <vector>

#include "aeolic/renderer.h"
#include "aeolic/scene_description.h"
#include "cluster/balance/network_model.h"
#include "common/bench_progress.h"
#include "scaling/critical_path.h"
#include "scaling/scaling_simulation.h"

namespace aeolic {

/// Which of the measurements of bachthaler2006parallel, section 7, a row repeats.
enum class ScalingPart {
    nodes,   ///< Table 1: every number of ranks, every balancer, the field on each of them.
    bricks,  ///< The field and a large one, split among the most ranks; and, to compare with, the field on each.
    mesh     ///< Figure 6: a more complex surface in the large field.
};

struct ScalingBenchPlan {
    /// Of `nodes`. Its frames and orbit are the rotation; who draws what is not used. Ranks compute with one thread.
    SceneDescription scene;
    std::vector<int> ranks{1, 2, 3, 4, 5, 6, 7, 8};
    std::vector<std::string> balancers{"static", "timing", "pixels", "hybrid"};
    std::vector<ScalingPart> parts{ScalingPart::nodes, ScalingPart::bricks, ScalingPart::mesh};
    std::string largeField = "abc:512,512,512";
    std::string mesh = "torus:25000";
    int repeats = 3;  ///< Times every frame is measured: of a rank's times in each stage the least counts.
    NetworkModel network;
    bool fillWide = false;  ///< Zooms by the root of the sides' ratio: wide pictures are covered like square ones.
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
    double paperNetworkMs = 0;     ///< … with kPaperNetwork.
    double cpuMs = 0;              ///< CPU time of all ranks together.
    std::optional<double> wallMs;  ///< Wall time, all ranks at once: where there are as many cores.
    /// By one rank alone, which draws the same pictures in turn with these ranks: its time by theirs, of each picture,
    /// and of those the median. A machine's moods are in both, and cancel. Of `nodes` with several ranks; else none.
    std::optional<double> speedup, paperNetworkSpeedup, wallSpeedup;
    std::optional<double> work;  ///< … all ranks' CPU time by the one's, likewise.
    /// Of `bricks`, all rows but the first's: its time by that of the scene in the rows before, which is drawn in turn
    /// with it, of each picture, and of those the median.
    std::optional<double> slowdown;
    double loadBalance = 1;          ///< Mean busy / max busy.
    std::vector<double> afterJump;   ///< The same of the first frame after each of some turns by 90 degrees.
    std::vector<RankStats> ofRanks;  ///< In the frame whose critical path is the median …
    CriticalPath path;               ///< … and that, with plan.network.
};

struct ScalingBench {
    std::string backend, device, simd;
    int cores = 1;
    std::vector<std::string> warnings;  ///< Of the scenes, one line each.
    /// What one rank took beside the first of `nodes` with several ranks, beside the second …, the most by the least:
    /// how steady the machine was. None where there are no two.
    std::optional<double> steadiness;
    std::vector<ScalingRow> rows;  ///< By part, then setting, then ranks, then balancer. One rank: only once, "static".

    MeasuredCosts costs;                         ///< Of `nodes`: what the simulation goes by.
    std::vector<ScalingSimulation> simulations;  ///< Where asked for.

    /// Of `nodes`, one rank: what speedups refer to. Null where that was not measured.
    const ScalingRow* reference() const;
};

/// Ranks are threads of this process that compute one at a time, so that no rank's time is another's noise; times are
/// their own CPU times. Throws InputError for a scene that is not valid or cannot be loaded, and for what does not fit
/// the memory.
ScalingBench benchScaling(const ScalingBenchPlan& plan, const BenchProgress& progress = {});

}  // namespace aeolic
