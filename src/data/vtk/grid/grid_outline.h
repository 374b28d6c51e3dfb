#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/vector_field.h"

namespace aeolic {

/// What is needed of a grid file's arrays; all others are not even read.
struct GridRequest {
    std::string vectors;                              ///< Empty: the active ones, or the only ones.
    std::string colorBy;                              ///< NAME or NAME:mag, or empty.
    std::vector<std::string> contours;                ///< What isosurfaces are cut by: NAME or NAME:mag each.
    bool halves = false;                              ///< Vectors will be taken as halves.
    std::optional<double> timeInFile = std::nullopt;  ///< One of the file's time steps; none: the first.
    int ranksOnHost = 1;                              ///< That cut the same surface at once.
    bool lookUp = false;                       ///< It will be looked up in its own cells, so polyhedra stay whole.
    std::vector<std::string> otherFiles = {};  ///< With the rest of the volume, which lies in several.
    std::vector<std::string> parts = {};       ///< Names and patterns; empty: all that fill space.
    bool cutsOut = false;                      ///< Some surface is cut out of it.

    std::vector<std::string> arrays() const
    {
        std::vector<std::string> all{vectors, colorBy};
        all.insert(all.end(), contours.begin(), contours.end());
        return all;
    }
};

/// A field's grid before it is read: everything but samples, their longest, and their precision in memory.
struct GridOutline {
    std::optional<GridField> vectors;
    std::optional<GridField> scalar;  ///< What is coloured by; none where it is the vectors' own length.
};

/// The outline of image data that can be sampled as it is, by the file's header; empty for other files. Throws
/// InputError.
GridOutline outlineOfGridFile(const std::string& path, const GridRequest& request);

}  // namespace aeolic
