#include "cluster/speed_history.h"

#include <numeric>

namespace aeolic {
namespace {

// A frame's weight falls to a third in five frames: long enough for what a view alone makes slow to average out under a
// moving camera, short enough to follow a node that is throttled.
constexpr double kMemory = 0.8;

// Every rank is given this part of the mean work at the group's speed on top of its own.
constexpr double kAverageShare = 0.02;

}  // namespace

void addFrame(SpeedHistory& history, const std::vector<double>& work, const std::vector<double>& busyMs)
{
    if (history.work.size() != work.size())
        history = {std::vector<double>(work.size(), 0.0), std::vector<double>(work.size(), 0.0)};
    for (std::size_t r = 0; r < work.size(); ++r) {
        if (!(work[r] > 0) || !(busyMs[r] > 0)) continue;
        history.work[r] = kMemory * history.work[r] + work[r];
        history.busyMs[r] = kMemory * history.busyMs[r] + busyMs[r];
    }
}

std::vector<double> relativeSpeeds(const SpeedHistory& history)
{
    const double work = std::accumulate(history.work.begin(), history.work.end(), 0.0);
    const double busyMs = std::accumulate(history.busyMs.begin(), history.busyMs.end(), 0.0);
    if (!(work > 0) || !(busyMs > 0)) return {};
    const double groupSpeed = work / busyMs, extraWork = kAverageShare * work / double(history.work.size());
    std::vector<double> speeds;
    for (std::size_t r = 0; r < history.work.size(); ++r)
        speeds.push_back((history.work[r] + extraWork) / (history.busyMs[r] + extraWork / groupSpeed) / groupSpeed);
    return speeds;
}

}  // namespace aeolic
