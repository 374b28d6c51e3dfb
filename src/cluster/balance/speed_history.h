#pragma once

#include <vector>

namespace aeolic {

/// What each rank has done in the frames so far; older frames count less and less. It tells a slow node from a rank
/// that merely had much to do.
struct SpeedHistory {
    std::vector<double> work;  ///< [ranks], in stripeCost() units.
    std::vector<double> time;  ///< [ranks]; the unit is how long the frame's middle rank takes for a unit of work.
};

/// Adds a frame: what each rank's stripe cost by the model, and how long the rank was busy with it. One frame alone
/// changes little, because a rank may have been held up by something else. The first frame changes nothing: it tells
/// how long memory and libraries took to come. A rank with no work or no time nears the average. With another number of
/// ranks than before the history starts anew.
void addFrame(SpeedHistory& history, const std::vector<double>& work, const std::vector<double>& busyMs);

/// Work per time of each rank; 1 is the group's. Ranks that did little are taken for average: fixed costs would make
/// them look slow, and they would get too little to do. Empty where nothing is known.
std::vector<double> relativeSpeeds(const SpeedHistory& history);

}  // namespace aeolic
