#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/scene_description.h"

namespace aeolic {

/// Where one step of a series is: a file, or one of the steps that a file holds.
struct StepFile {
    std::string path;
    std::optional<double> timeInFile;
    std::vector<std::string> parts = {};   ///< Empty: the usual ones.
    std::vector<std::string> others = {};  ///< Files with the rest of the data set, which lies in several.

    std::vector<std::string> files() const
    {
        std::vector<std::string> all{path};
        all.insert(all.end(), others.begin(), others.end());
        return all;
    }
};

/// Data sets of the same kind at several moments.
struct TimeSeries {
    std::vector<double> times;    ///< Finite, strictly increasing; at least one.
    std::vector<StepFile> steps;  ///< [times]
};

/// The steps on either side of a moment, and where between them it lies.
struct Around {
    double first = 0, second = 0;  ///< Keys: the numbers of the steps, or moments where anything is built in.
    double weight = 0;             ///< The second's, [0, 1). 0 where both are the same step.
    bool operator==(const Around&) const = default;

    std::vector<double> keys() const
    {
        return first == second ? std::vector<double>{first} : std::vector<double>{first, second};
    }
};

/// Before the first time and after the last: the nearest end. `times` is not empty.
Around bracketOf(const std::vector<double>& times, double moment);

/// Whether `path` names a series of files rather than one: it ends in .pvd or .series, or its file name (which no file
/// has) holds a wildcard for numbers: %d, %04d or *.
bool namesSeries(const std::string& path);

/// What the series names, every file looked for but none opened:
///
/// - .pvd: a ParaView collection, VTK's XML with a `timestep` and a `file` for each data set, and a `part` where the
///   data set of a time lies in several files;
/// - .vti.series, .vtp.series, …: ParaView's JSON, {"file-series-version": "1.0", "files": [{"name": …, "time": …}]};
/// - wave_%04d.vti, wave_*.vti: all files whose name has a number there, in the order of the numbers. Their times are
///   0, 1, 2 and so on, however far the numbers are apart.
///
/// Names are relative to the series' folder. Throws InputError with one line for a file that is damaged or missing, no
/// files, files of different kinds, times that are missing, not finite, equal or not increasing.
TimeSeries readTimeSeries(const std::string& path);

/// The steps of a file that holds several. Throws InputError as above.
TimeSeries seriesInFile(const std::string& path, const std::vector<double>& timeSteps);

/// The file that `spec` names, or the first file of the series that it names. Throws InputError.
std::string firstFileOf(const std::string& spec);

/// Both lists in one, sorted, each time once.
std::vector<double> mergedTimes(const std::vector<double>& a, const std::vector<double>& b);

/// The moment a description begins with; `times`: those there are.
double startOf(const SceneDescription& description, const std::vector<double>& times);

/// The moment of frame `index` of `frames` over a range in time: a share of the way that is 0 and 1 at its ends,
/// exactly.
double momentOfFrame(const std::array<double, 2>& range, int index, int frames);

}  // namespace aeolic
