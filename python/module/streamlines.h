#pragma once

#include <pybind11/pybind11.h>

#include "aeolic/streamlines.h"

namespace aeolic::python {

/// Adds the class that aeolic/_streamlines.py wraps.
void addStreamlines(pybind11::module_& module);

}  // namespace aeolic::python
