#pragma once

#include <string>

namespace aeolic {

/// A line of a list of files, as it stands there.
struct SeriesEntry {
    std::string file;
    double time = 0;
    long part = 0;  ///< Which of several files at the same time.
};

}  // namespace aeolic
