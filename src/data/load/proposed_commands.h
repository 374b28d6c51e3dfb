#pragma once

#include <string>
#include <vector>

#include "data/file_summary.h"

namespace aeolic {

/// Commands to try first on a file, or why there are none.
struct ProposedCommands {
    std::vector<std::string> commands = {};  ///< What follows "aeolic render", but for `-o`.
    std::string none = {};                   ///< "no cell has an area"; empty where there are commands.
    std::string note = {};                   ///< A line about them, or empty.
};

/// Each of them draws something: vectors that flow, colours that differ, a plane through the data, flat data looked at
/// straight.
ProposedCommands proposedCommands(const std::string& path, const FileSummary& summary);

/// A time of a file, as people type it: with so many digits that it lies within `times`, which are not empty.
std::string timeText(double time, const std::vector<double>& times);

}  // namespace aeolic
