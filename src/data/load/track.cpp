#include "data/load/track.h"

#include <optional>
#include <utility>

namespace aeolic {

void Track::takeStepsOf(const std::vector<double>& timeSteps)
{
    if (series.steps.size() != 1 || timeSteps.size() < 2) return;
    series = seriesInFile(series.steps.front().path, timeSteps);
    times = series.times;
}

Track fileTrack(const std::string& path)
{
    Track track;
    track.name = path;
    track.series = namesSeries(path) ? readTimeSeries(path) : TimeSeries{{0}, {{path, std::nullopt}}};
    if (namesSeries(path)) track.times = track.series.times;
    return track;
}

Track builtinTrack(const std::string& spec, std::vector<double> times)
{
    Track track;
    track.name = spec;
    track.times = std::move(times);
    track.anyMoment = true;
    return track;
}

}  // namespace aeolic
