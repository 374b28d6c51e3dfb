#pragma once

#include <vtkAlgorithm.h>
#include <vtkSmartPointer.h>

namespace aeolic {

/// VTK's reader of NRRD files, for headers that VTK 9.1 misunderstands: one whose last line has no end keeps it busy
/// for ever, and a space before the sizes takes the components for an axis. It refuses headers without a type, with
/// sizes or spacings that are none, and values that are not raw.
vtkSmartPointer<vtkAlgorithm> makeNrrdReader();

}  // namespace aeolic
