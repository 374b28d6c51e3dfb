#pragma once

#include <string>
#include <vector>

#include "aeolic/renderer.h"

namespace aeolic {

/// What `--stats FILE` tells of a run. Times are wall time in milliseconds, without the writing of files; memory is in
/// bytes. The JSON is one object; its "frames" has one entry for each picture.
struct RunStats {
    SceneDescription scene;
    SceneInfo info;
    std::vector<FrameStats> frames;
    std::vector<std::int64_t> peakRssBytesOfRank;
};

/// The largest resident memory that this process has had so far, in bytes.
std::uint64_t peakRssBytes();

std::string statsToJson(const RunStats& stats);

}  // namespace aeolic
