#pragma once

#include <memory>
#include <optional>
#include <string>

#include "reader/vtk/own_reader.h"

namespace aeolic {

/// A netCDF file of grids, as models of oceans and of the air write them. A file may hold several grids: what is read
/// is the one that the arrays which are kept need. Throws InputError.
std::unique_ptr<OwnReader> openNetcdfGrid(const std::string& path, FileUse use, std::optional<double> time);

}  // namespace aeolic
