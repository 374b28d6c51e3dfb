#pragma once

#include <string>
#include <vector>

#include "aeolic/renderer.h"

namespace aeolic {

/// What `--stats FILE` writes about a run: times in milliseconds of wall time, without writing files; memory in bytes.
/// The JSON is one object with one entry of "frames" per picture.
struct RunStats {
    SceneDescription scene;
    SceneInfo info;
    std::vector<FrameStats> frames;
    std::vector<std::int64_t> peakRssBytesOfRank;
};

/// The largest resident memory this process ever had.
std::uint64_t peakRssBytes();

std::string statsToJson(const RunStats& stats);

}  // namespace aeolic
