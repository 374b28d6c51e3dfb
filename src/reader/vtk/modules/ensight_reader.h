#pragma once

#include <memory>
#include <optional>
#include <string>

#include "reader/vtk/own_reader.h"

namespace aeolic {

/// A case of EnSight 6 by VTK's reader. Our own reads those of EnSight Gold. Throws InputError.
std::unique_ptr<OwnReader> openEnSight6(const std::string& path, FileUse use, std::optional<double> time);

}  // namespace aeolic
