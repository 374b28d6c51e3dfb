#pragma once

#include <string>

#include "aeolic/streamlines.h"

namespace aeolic {

/// Streamlines as VTK XML polydata: a line each. Arrays of cells: `closed` (1, or 0) and `length`. Arrays of points:
/// `vectors`, and the scalar by its name.
std::string streamlinesVtp(const EvenSurfaceLines& lines);

/// Streamlines as comma-separated values with a heading: a row for each place, with the line's number from 0.
std::string streamlinesCsv(const EvenSurfaceLines& lines);

}  // namespace aeolic
