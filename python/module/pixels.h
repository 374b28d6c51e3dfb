#pragma once

#include <pybind11/pybind11.h>

#include <optional>

#include "aeolic/buffers.h"
#include "aeolic/pick.h"

namespace aeolic::python {

/// What aeolic/_pick.py makes a PickedPlace of; None on the background.
pybind11::object told(const std::optional<PickedPlace>& place);

/// What aeolic/_pick.py makes PictureBuffers of. The arrays keep the memory; nothing is copied.
pybind11::dict arraysOf(PictureBuffers buffers);

}  // namespace aeolic::python
