#pragma once

#include <vtkDataObject.h>

#include <string>

namespace aeolic {

/// "image data", "an unstructured grid" …
std::string kindOf(vtkDataObject& data);

}  // namespace aeolic
