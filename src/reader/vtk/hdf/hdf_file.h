#pragma once

#include <memory>
#include <optional>
#include <string>

#include "reader/vtk/own_reader.h"

namespace aeolic {

/// A VTKHDF file: image data, an unstructured grid or polygons, or several of them as parts. Throws InputError.
std::unique_ptr<OwnReader> openVtkHdf(const std::string& path, FileUse use, std::optional<double> time);

}  // namespace aeolic
