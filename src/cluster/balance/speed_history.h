#pragma once

#include <vector>

namespace aeolic {

/// What each rank has done in the frames so far, older ones counting less and less: enough to tell a slow node from a
/// rank that merely had much to do.
struct SpeedHistory {
    std::vector<double> work;  ///< [ranks], in stripeCost() units.
    std::vector<double> time;  ///< [ranks], in what a unit takes the frame's middle rank.
};

/// Adds a frame: what each rank's stripe cost by the model, and how long it was busy with it. One frame alone changes
/// little: what held a rank up need not be its own slowness; the first one changes nothing, for it tells how long
/// memory and libraries took to come. A rank with no work or no time nears the average. Another number of ranks than
/// before starts anew.
void addFrame(SpeedHistory& history, const std::vector<double>& work, const std::vector<double>& busyMs);

/// Work per time of each rank, 1 being the group's. Ranks that did little are taken for average: fixed costs would make
/// them look slow, and starve them. Empty where nothing is known.
std::vector<double> relativeSpeeds(const SpeedHistory& history);

}  // namespace aeolic
