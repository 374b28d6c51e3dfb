#pragma once

#include <pybind11/pybind11.h>

#include "aeolic/topology.h"

namespace aeolic::python {

/// Adds the class that aeolic/_topology.py wraps.
void addTopology(pybind11::module_& module);

}  // namespace aeolic::python
