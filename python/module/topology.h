#pragma once

#include <pybind11/pybind11.h>

#include "aeolic/topology.h"

namespace aeolic::python {

/// What aeolic/_topology.py is made of.
void addTopology(pybind11::module_& module);

}  // namespace aeolic::python
