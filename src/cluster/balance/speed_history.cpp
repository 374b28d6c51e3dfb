#include "cluster/balance/speed_history.h"

#include <algorithm>
#include <numeric>

#include "base/median.h"

namespace aeolic {
namespace {

// A frame's weight falls to a third in five frames. That is long enough for a moving camera to average out views that
// are slow for one rank, and short enough to follow a node that is throttled.
constexpr double kMemory = 0.8;

// This part of the mean work, at the group's speed, is added to every rank's own.
constexpr double kAverageShare = 0.02;

// One frame makes a rank look at most this much faster or slower than it was known to be. What the system did meanwhile
// (new memory, another program) is no speed. A rank that got nothing to do for it could never show better.
constexpr double kMostChange = 2;

}  // namespace

void addFrame(SpeedHistory& history, const std::vector<double>& work, const std::vector<double>& busyMs)
{
    const std::size_t ranks = work.size();
    if (history.work.size() != ranks) {
        history = {std::vector<double>(ranks, 0.0), std::vector<double>(ranks, 0.0)};
        return;
    }
    std::vector<double> rates;
    double meanWork = 0;
    for (std::size_t r = 0; r < ranks; ++r) {
        meanWork += work[r] / double(ranks);
        if (work[r] > 0 && busyMs[r] > 0) rates.push_back(work[r] / busyMs[r]);
    }
    if (rates.empty()) return;
    // The median: a single rank that was held up does not make the others look fast.
    const double groupRate = median(rates);
    const std::vector<double> known = relativeSpeeds(history);
    const double middle = median(known);
    for (std::size_t r = 0; r < ranks; ++r) {
        double done = (1 - kMemory) * meanWork, speed = 1;  // With nothing to do a rank is slowly taken for average.
        if (work[r] > 0 && busyMs[r] > 0) {
            done = work[r];
            const double before = known.empty() ? 1.0 : known[r] / middle;
            speed = std::clamp(work[r] / busyMs[r] / groupRate, before / kMostChange, before * kMostChange);
        }
        history.work[r] = kMemory * history.work[r] + done;
        history.time[r] = kMemory * history.time[r] + done / speed;
    }
}

std::vector<double> relativeSpeeds(const SpeedHistory& history)
{
    const double work = std::accumulate(history.work.begin(), history.work.end(), 0.0);
    const double time = std::accumulate(history.time.begin(), history.time.end(), 0.0);
    if (!(work > 0) || !(time > 0)) return {};
    const double groupSpeed = work / time, extraWork = kAverageShare * work / double(history.work.size());
    std::vector<double> speeds;
    for (std::size_t r = 0; r < history.work.size(); ++r)
        speeds.push_back((history.work[r] + extraWork) / (history.time[r] + extraWork / groupSpeed) / groupSpeed);
    return speeds;
}

}  // namespace aeolic
