#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/scene_description.h"
#include "common/measuring.h"
#include "rates/fetch_rate.h"
#include "rates/gather_rate.h"

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
    bool fillWide = false;                  ///< Whether filling() zooms each picture.
    int repeats = 5;                        ///< Frames of each combination, besides those to warm up.
    int rateRepeats = cpu::kGatherRepeats;  ///< Runs that measure what the processor can fetch.
};

/// One combination. Times are milliseconds, medians of the repeats. Without a GPU all are wall time; on a GPU those of
/// single stages are by its own clock.
struct StagesBenchRow {
    StagesBenchPlan::Size size;
    LicMethod method;
    int steps;
    std::int64_t coveredPixels = 0;
    double projectMs = 0, convolveMs = 0, shadeMs = 0;
    double totalMs = 0;  ///< Always wall time, until the pixels are in this process's memory.
    /// What only a GPU has.
    struct Device {
        double stagesMs = 0;     ///< All three stages by its own clock, without reading the pixels back.
        double readBackMs = 0;   ///< Reading them back.
        double followingMs = 0;  ///< Wall time of a frame with its read-back, where frames follow each other.
    };
    std::optional<Device> device = std::nullopt;
    /// Covered pixels * 2 directions * steps in a second of the LIC stage. Steps that are walked in parts
    /// (inShortSteps()) count each part.
    double pixelStepsPerS = 0;
    double walkedShare = 0;  ///< How many of those steps traces walk before they end; estimated from a sample.
    /// Lanes that the LIC stage fetches in a second, of traces that still go on. It fetches more, because a vector goes
    /// on until its last trace ends.
    double lanesPerS = 0;
    double mostLanesPerS = 0;      ///< What it would fetch if no trace ended early: an upper bound.
    double shareOfGatherRate = 0;  ///< lanesPerS by what the gather instruction fetches, all threads.
    double shareOfBlockRate = 0;   ///< lanesPerS by what block loads fetch.
    double shareOfFetchRate = 0;   ///< lanesPerS by what a GPU gathers.
};

struct StagesBench {
    std::string backend, device, simd;
    int threads = 1;
    std::vector<std::string> warnings;            ///< About the scene, one line each.
    std::optional<gl::FetchRates> fetchRates;     ///< On the gl backend: rows' lanes are then texels gathered.
    std::optional<cpu::GatherRates> gatherRates;  ///< On the cpu backend.
    std::vector<StagesBenchRow> rows;             ///< By size, then method, then steps.
};

/// Loads the scene once, measures the machine, then every combination. Throws InputError for a scene that is not valid
/// or cannot be loaded, and for sizes that do not fit the memory.
StagesBench benchStages(const StagesBenchPlan& plan, const Watch<StagesBench>& watch = {});

}  // namespace aeolic
