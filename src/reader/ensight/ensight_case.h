#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace aeolic {

/// A file of an EnSight case, or one for each step of time, with '*' in its name for the step's number.
struct EnSightFile {
    std::string pattern;
    int timeSet = 0;  ///< 0: none is named.
};

struct EnSightVariable {
    std::string name;
    bool onPoints = true;
    int components = 1;  ///< 1 or 3.
    EnSightFile file;
};

struct EnSightTimes {
    int number = 0;                    ///< As the case file calls it.
    std::vector<double> values;        ///< Increasing; at least one.
    std::vector<std::string> numbers;  ///< Of the files, one for each value.
};

/// What the text of an EnSight Gold case file says.
struct EnSightCase {
    std::string path, folder;
    EnSightFile geometry;
    std::vector<EnSightVariable> variables;  ///< Scalars and vectors on nodes or elements. Others are left out.
    std::vector<EnSightTimes> timeSets;

    /// The times of all sets that files use, increasing, each once. Empty where nothing changes.
    std::vector<double> times() const;

    /// The path of the file that holds at a time: that of the latest step which is not later, else of the first step.
    /// No time: the first of times().
    std::string fileAt(const EnSightFile& file, std::optional<double> time) const;
};

/// Reads a case file, and looks whether every file that it names for every step is there. Throws InputError, which
/// begins with `path`.
EnSightCase readEnSightCase(const std::string& path);

}  // namespace aeolic
