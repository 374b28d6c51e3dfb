#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/scene_description.h"
#include "common/bench_progress.h"
#include "rates/gather_rate.h"
#include "render/gl/device/fetch_rate.h"

namespace aeolic {

/// One scene drawn in every combination of sizes, methods and steps.
struct StagesBenchPlan {
    struct Size {
        int width, height;  ///< Pixels.
    };
    SceneDescription scene;  ///< Its own size, method and steps are not used.
    std::vector<Size> sizes{{800, 800}, {1920, 1080}, {3840, 2160}};
    std::vector<int> steps{16, 32, 64, 128, 256, 512, 1024};
    std::vector<LicMethod> methods{LicMethod::direct, LicMethod::hierarchical};
    bool fillWide =
        false;        ///< Zooms by the root of the sides' ratio, so that wide pictures are covered like square ones.
    int repeats = 5;  ///< Frames of each combination, besides those to warm up.
};

/// One combination; times are medians of the repeats, milliseconds of wall time (of a GPU's clock: see `device`).
struct StagesBenchRow {
    StagesBenchPlan::Size size;
    LicMethod method;
    int steps;
    std::int64_t coveredPixels = 0;
    double projectMs = 0, convolveMs = 0, shadeMs = 0, totalMs = 0;
    struct Device {
        double stagesMs = 0;     ///< All three, by its own clock, without reading the pixels back.
        double readBackMs = 0;   ///< That.
        double followingMs = 0;  ///< Wall time of a frame with its read-back, where frames follow each other.
    };
    std::optional<Device> device =
        std::nullopt;           ///< On a GPU; the stages' times are then its own too. `totalMs` stays wall time.
    double pixelStepsPerS = 0;  ///< Covered pixels * 2 directions * steps (in parts: inShortSteps()), in the LIC stage.
    double walkedShare = 0;     ///< Of those steps, what traces walk before they end; estimated from a sample.
    double mostLanesPerS = 0;   ///< Lanes the LIC stage fetches if no trace ends early: an upper bound.
    double lanesPerS = 0;  ///< … for traces that still go on: a lower bound, as vectors go on with their last lane.
    double shareOfGatherRate = 0;  ///< lanesPerS per second of the gather instruction, all threads.
    double shareOfBlockRate = 0;   ///< … of block loads.
    double shareOfFetchRate = 0;   ///< lanesPerS per second of a GPU's gathers.
};

struct StagesBench {
    std::string backend, device, simd;
    int threads = 1;
    std::vector<std::string> warnings;            ///< Of the scene, one line each.
    std::optional<gl::FetchRates> fetchRates;     ///< On the gl backend: rows' lanes are then texels gathered.
    std::optional<cpu::GatherRates> gatherRates;  ///< On the cpu backend; elsewhere rows have no lanes either.
    std::vector<StagesBenchRow> rows;             ///< By size, then method, then steps.
};

/// Loads the scene once, measures the machine, then every combination. Throws InputError for a scene that is not valid
/// or cannot be loaded, and for sizes that do not fit the memory.
StagesBench benchStages(const StagesBenchPlan& plan, const BenchProgress& progress = {});

}  // namespace aeolic
