#pragma once

#include <pybind11/pybind11.h>

#include <optional>

#include "aeolic/data.h"

namespace aeolic::python {

/// Views of the numpy arrays in these dicts, which keep the arrays alive (aeolic/_data.py makes them so that tuples
/// have no gaps within). "points", "triangles", "offsets", "connectivity"; "origin", "spacing", "dims"; "types",
/// "faces", "face_locations", "axes"; "point_data" and "cell_data": a list of pairs; "active": {("point_data",
/// "vectors"): name}. `field` is a grid or, with "types", a volume. None: nothing of that kind is in memory. Needs the
/// GIL.
Data dataOf(const pybind11::object& surface, const pybind11::object& field);

}  // namespace aeolic::python
