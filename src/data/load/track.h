#pragma once

#include <string>
#include <vector>

#include "data/load/time_series.h"

namespace aeolic {

/// Steps on either side of a moment, by their keys, and the second's weight.
struct Around {
    double first = 0, second = 0, weight = 0;
    bool operator==(const Around&) const = default;

    std::vector<double> keys() const
    {
        return first == second ? std::vector<double>{first} : std::vector<double>{first, second};
    }
};

/// One source of data over time.
struct Track {
    std::string name;           ///< As the user wrote it.
    TimeSeries series;          ///< Of files; a key is the number of a step.
    std::vector<double> times;  ///< Moments to choose from; none or one: it does not change.
    bool anyMoment = false;     ///< Built in: a key is the moment itself.

    bool moves() const { return times.size() > 1; }
    Around around(double moment) const
    {
        if (!moves()) return {};
        if (anyMoment) return {moment, moment, 0};
        const Bracket bracket = bracketOf(times, moment);
        return {double(bracket.first), double(bracket.second), bracket.weight};
    }
    const StepFile& file(double key) const { return series.steps[std::size_t(key)]; }
    double firstKey() const { return anyMoment && moves() ? times.front() : 0; }

    /// Of a single file, once it has been opened.
    void takeStepsOf(const std::vector<double>& timeSteps);
};

/// Of a file, or of the series that the path names. Throws InputError for one that makes no sense.
Track fileTrack(const std::string& path);

/// Of something built in, which has `times` to begin with.
Track builtinTrack(const std::string& spec, std::vector<double> times);

}  // namespace aeolic
