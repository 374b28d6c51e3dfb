#pragma once

#include <optional>
#include <string>

namespace aeolic {

/// What is needed of a grid file's arrays; all others are not even read.
struct GridRequest {
    std::string vectors;                              ///< Empty: the active ones, or the only ones.
    std::string colorBy;                              ///< NAME or NAME:mag, or empty.
    std::string contour;                              ///< Of an isosurface: NAME or NAME:mag, or empty.
    bool halves = false;                              ///< Vectors will be taken as halves.
    std::optional<double> timeInFile = std::nullopt;  ///< Of a file with several time steps; else the first.
};

}  // namespace aeolic
