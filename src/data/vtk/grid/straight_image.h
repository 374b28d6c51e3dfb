#pragma once

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <string>

namespace aeolic {

/// An image whose axes run along x, y and z and upwards, with the same samples at the same places as one with negative
/// spacing, or with axes that its Direction flips or exchanges. Where the Direction turns it by other angles, a
/// structured grid. Anything else is returned as it is. Throws InputError that begins with `path` where memory is
/// missing. Cost: a copy of all values.
vtkSmartPointer<vtkDataSet> straightened(vtkDataSet& data, const std::string& path);

}  // namespace aeolic
