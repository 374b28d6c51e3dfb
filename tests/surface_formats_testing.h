#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reader/parts/testing/sample_surface.h"

namespace aeolic::test {

/// A way to write a surface as a file.
struct SurfaceFormat {
    std::string name;  ///< "CGNS"
    std::string file;  ///< In its folder: what is given to --surface.
    std::function<void(const std::string& path, const SampleSurface&)> write;
    std::string vectors = "Vector", scalars = "Scalar";
    bool onPoints = true, onCells = true;  ///< Where its values can be.
    bool floats = true, doubles = true;    ///< What its numbers can be.
};

/// Every format of surfaces with values that there is a writer for.
std::vector<SurfaceFormat> surfaceFormats();

/// Those that have no values.
std::vector<SurfaceFormat> bareSurfaceFormats();

/// A bent sheet. `exact`: all its numbers are those of 32 bits, too. Floats are rounded to them.
SampleSurface bentSheet(bool onCells, bool doubles, bool exact);

}  // namespace aeolic::test
